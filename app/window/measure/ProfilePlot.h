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

/// Heights along a line.
struct ProfileCurve {
    QString name;
    int color = 0;            ///< as seriesColor() counts
    QVector<QPointF> points;  ///< distance and height [m]; NaN parts two pieces
};

/// Heights along profile lines. One of them is selected: it has two cursors and, for a step height,
/// two marked stretches; all of them can be dragged. A user may zoom and pan (PlotNavigation).
class ProfilePlot : public QWidget {
    Q_OBJECT

public:
    using Cursors = std::array<double, 2>;         ///< distances from the start [m]
    using Stretches = std::array<PlotStretch, 2>;  ///< the lower one first, then the upper one

    explicit ProfilePlot(QWidget* parent = nullptr);
    ~ProfilePlot() override;
    ProfilePlot(const ProfilePlot&) = delete;
    ProfilePlot& operator=(const ProfilePlot&) = delete;

    /// @param selected of the curves; -1: none
    void setCurves(const QVector<ProfileCurve>& curves, int selected);
    void setCursors(const Cursors& distances);
    /// None: no step is measured.
    void setStretches(const std::optional<Stretches>& stretches);

    /// Distance [m] and height [m] along each line.
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

    [[nodiscard]] double selectedLength() const;

    QVector<ProfileCurve> curves_;
    int selected_ = -1;
    Cursors cursors_{};
    std::optional<Stretches> stretches_;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace asperity
