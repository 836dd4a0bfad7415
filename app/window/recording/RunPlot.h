#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"
#include "ui/widgets/Theme.h"

#include <QPointF>
#include <QString>
#include <QVector>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// Content and look of a plot of whole runs.
struct RunPlotSetup {
    /// Order of the horizontal axis; `Rising`: its values rise along a line.
    enum class Order { Rising, Any };

    QString title;
    QString xName;          ///< "time"
    QString xUnit;          ///< SI unit
    QString yUnit;          ///< SI unit
    double smallest = 0.0;  ///< least extent of the vertical axis [yUnit]
    Order order = Order::Rising;
    QString toolTip;
};

/// Lines of whole runs, however many ticks they have, with a mark at the moment that is shown. A
/// user may zoom and pan (PlotNavigation); a hovering pointer reads all lines.
class RunPlot : public QWidget {
public:
    struct Line {
        QString name;
        QColor ThemeColors::*color = &ThemeColors::ink;
        QVector<QPointF> points;  ///< SI; one that is not a number parts the line
    };

    explicit RunPlot(const RunPlotSetup& setup, QWidget* parent = nullptr);
    ~RunPlot() override;
    RunPlot(const RunPlot&) = delete;
    RunPlot& operator=(const RunPlot&) = delete;

    /// At most two.
    void setLines(const std::vector<Line>& lines);
    /// A vertical line, and a dot upon it; none: no moment is shown.
    void setMoment(const std::optional<QPointF>& moment);
    [[nodiscard]] const std::optional<QPointF>& moment() const { return moment_; }

    /// All points of the lines [SI].
    [[nodiscard]] PlotTable table() const;
    /// Returns what the cursor reads; empty: the pointer is elsewhere.
    [[nodiscard]] QString reading() const;
    [[nodiscard]] QWidget& canvas();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    class Canvas;  ///< what Qwt draws

    void draw();

    RunPlotSetup setup_;
    std::vector<Line> lines_;
    std::optional<QPointF> moment_;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace asperity
