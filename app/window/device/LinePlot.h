#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/widgets/Steady.h"

#include <QPointF>
#include <QString>
#include <QVector>
#include <QWidget>

#include <array>
#include <memory>

class QLabel;
class QToolButton;
class QwtPlot;

namespace asperity {

class NumberScaleDraw;
class PiecewiseCurve;
class PlotCursor;

/// One quantity along a line of a path, there (trace) and back (retrace). A hovering pointer reads
/// both; a user may zoom and pan (PlotNavigation).
class LinePlot : public QWidget {
public:
    struct Setup {
        QString title;          ///< "Height"
        QString unit;           ///< SI unit of the values
        double smallest = 0.0;  ///< least extent of the value axis [unit]: noise stays small
    };
    /// Distance from the line's start [m] and value [unit] of each way; a value that is not a
    /// number parts two pieces.
    struct Ways {
        QVector<QPointF> trace;
        QVector<QPointF> retrace;
    };

    explicit LinePlot(const Setup& setup, QWidget* parent = nullptr);
    ~LinePlot() override;
    LinePlot(const LinePlot&) = delete;
    LinePlot& operator=(const LinePlot&) = delete;

    /// Replaces what is shown; a user's zoom stays unless the length is another one.
    /// @param length of the line: the extent of the distance axis [m]
    void setWays(const Ways& ways, double length);

    /// Returns all points of both ways, in the order in which they were given [SI].
    [[nodiscard]] PlotTable table() const;
    /// Returns what the cursor reads; empty: the pointer is elsewhere.
    [[nodiscard]] QString reading() const;
    /// Returns the part that is in sight: distances [m] and values [unit].
    [[nodiscard]] const PlotWindow& shown() const { return shown_; }
    [[nodiscard]] QWidget& canvas();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void draw();
    /// @param numbered whether the axes have numbers: those of an empty plot say nothing
    void showAxes(bool numbered);
    void showAxis(int axis, NumberScaleDraw& labels, const AxisRange& range, const SiScale& scale);
    void showWays();
    void showReading();
    void showTitle();

    Setup setup_;
    Ways ways_;
    double length_ = 0.0;  ///< [m]
    PlotWindow shown_;
    SiScale distance_;  ///< of the distance axis
    SiScale value_;     ///< of the value axis
    QLabel* title_;
    QToolButton* reset_;
    QwtPlot* plot_;
    NumberScaleDraw* valueLabels_;     ///< owned by the plot
    NumberScaleDraw* distanceLabels_;  ///< owned by the plot
    std::array<PiecewiseCurve*, 2> curves_{};
    std::unique_ptr<PlotCursor> reading_;
    PlotNavigation* navigation_;
};

}  // namespace asperity
