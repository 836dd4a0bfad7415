#pragma once

#include "ui/widgets/Steady.h"

#include <QObject>
#include <QPoint>
#include <QPointF>
#include <QString>
#include <QVector>

#include <optional>
#include <vector>

// Compiled as C++17 too: Qwt's headers are not C++20.
class QMouseEvent;
class QRubberBand;
class QWheelEvent;
class QWidget;

namespace asperity {

class PlotNavigation;

/// Positions along the horizontal axis of a plot that a user can drag. Where none of them is near
/// the pointer, the mouse does what PlotNavigation says.
class PlotHandles : public QObject {
    Q_OBJECT

public:
    /// @param canvas of the plot, whose navigation is there already; both outlive this
    PlotHandles(QWidget& canvas, const PlotNavigation& navigation);

    void setPositions(const QVector<double>& positions) { positions_ = positions; }

Q_SIGNALS:
    void dragged(int index, double position);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// The nearest one within reach of a pixel; -1: none.
    [[nodiscard]] int handleAt(double pixel) const;

    QWidget& canvas_;
    const PlotNavigation& navigation_;
    QVector<double> positions_;
    int held_ = -1;
};

/// The part of a plot's plane that is shown, in the units of its data.
struct PlotWindow {
    AxisRange x;
    AxisRange y;
};

/// Lets a user look around in a plot by mouse. The wheel zooms about the pointer (Ctrl: only the
/// horizontal axis, Shift: only the vertical one); a drag zooms into a rectangle, a flat one only
/// along its long side; a drag with the right or middle button, or with Ctrl, pans; a double click
/// returns to all. A hovering pointer is the cursor.
class PlotNavigation : public QObject {
    Q_OBJECT

public:
    /// @param canvas  the area of the data; outlives this
    /// @param xLimits beyond which the horizontal axis never shows
    explicit PlotNavigation(QWidget& canvas, const std::optional<AxisRange>& xLimits = {});

    /// Once a frame. @param whole what the plot shows by itself
    /// @return what is to be shown: that, or what the user looks at
    const PlotWindow& fit(const PlotWindow& whole);
    [[nodiscard]] bool isZoomed() const { return zoomed_; }
    void reset();
    /// The horizontal coordinate under the pointer; none: it is elsewhere.
    [[nodiscard]] std::optional<double> cursor() const;

    /// Between the horizontal axis and the pixels of the canvas.
    [[nodiscard]] double xOf(double pixel) const;
    [[nodiscard]] double pixelOf(double x) const;

    /// Returns what the mouse does, for tool tips.
    [[nodiscard]] static QString help();

Q_SIGNALS:
    void windowChanged();  ///< the user looks elsewhere
    void cursorMoved();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag { None, Rectangle, Pan };

    [[nodiscard]] QPointF positionOf(const QPointF& pixel) const;
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void turnWheel(const QWheelEvent& event);
    void zoomInto(const QRectF& pixels);
    void look(const PlotWindow& window);

    QWidget& canvas_;
    std::optional<AxisRange> xLimits_;
    PlotWindow whole_;
    PlotWindow shown_;
    bool zoomed_ = false;
    Drag drag_ = Drag::None;
    QPointF pressed_;  ///< pixel
    PlotWindow before_;
    std::optional<QPointF> pointer_;  ///< pixel
    QRubberBand* band_;
};

/// Round numbers within [low, high], at most about `room` of them, but never only one: a single
/// number says nothing about distances.
[[nodiscard]] std::vector<double> axisTicks(double low, double high, int room);

}  // namespace asperity
