#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"

#include <QPointF>
#include <QVector>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

namespace asperity {

/// A stretch of a profile, by distances from its start [m].
struct PlotStretch {
    double from = 0.0;
    double to = 0.0;
};

/// Heights along a profile line, with two cursors and, for a step height, two marked stretches;
/// all of them can be dragged. A user may zoom and pan (PlotNavigation).
class ProfilePlot : public QWidget {
    Q_OBJECT

public:
    using Cursors = std::array<double, 2>;         ///< distances from the start [m]
    using Stretches = std::array<PlotStretch, 2>;  ///< the lower one first, then the upper one

    explicit ProfilePlot(QWidget* parent = nullptr);
    ~ProfilePlot() override;
    ProfilePlot(const ProfilePlot&) = delete;
    ProfilePlot& operator=(const ProfilePlot&) = delete;

    /// @param points distance and height [m]; a height that is not a number parts two pieces.
    /// Empty:
    ///               there is no profile
    void setProfile(const QVector<QPointF>& points);
    void setCursors(const Cursors& distances);
    /// None: no step is measured.
    void setStretches(const std::optional<Stretches>& stretches);

    /// Distance [m] and height [m] along the line.
    [[nodiscard]] PlotTable table() const;

    [[nodiscard]] QWidget& canvas();
    /// Returns the position of a distance on the canvas [px].
    [[nodiscard]] double pixelOf(double distance) const;

Q_SIGNALS:
    void cursorDragged(int index, double distance);
    /// @param edge 0: its start, 1: its end
    void stretchDragged(int index, int edge, double distance);

private:
    class Canvas;  ///< what Qwt draws

    void draw();
    void drag(int handle, double distance);

    QVector<QPointF> points_;
    Cursors cursors_{};
    std::optional<Stretches> stretches_;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace asperity
