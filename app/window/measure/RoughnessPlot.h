#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"

#include <QPointF>
#include <QVector>
#include <QWidget>

#include <memory>

namespace asperity {

/// Plot of the histogram of heights, or of the power spectrum on logarithmic axes. A user may zoom
/// and pan (PlotNavigation).
class RoughnessPlot : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Histogram, Spectrum };

    explicit RoughnessPlot(Kind kind, QWidget* parent = nullptr);
    ~RoughnessPlot() override;
    RoughnessPlot(const RoughnessPlot&) = delete;
    RoughnessPlot& operator=(const RoughnessPlot&) = delete;

    /// @param points of a histogram the middles of its bins, one width apart [m], and the share of
    ///        the area in each, 0..1; of a spectrum frequency [1/m] and density [m^4], both above
    ///        0. Empty: nothing to show
    void setPoints(const QVector<QPointF>& points);
    /// Returns what setPoints() got.
    [[nodiscard]] PlotTable table() const;

private:
    class Canvas;  ///< what Qwt draws

    void draw();

    Kind kind_;
    QVector<QPointF> points_;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace asperity
