#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"

#include <QString>
#include <QWidget>

#include <memory>
#include <vector>

namespace asperity {

/// Errors below this share of the force look alike: nobody feels them.
inline constexpr double kNoticedShare = 1e-5;

/// One choice in the chart.
struct TradeOffPoint {
    double time = 0.0;   ///< median of a tick [s]
    double error = 0.0;  ///< of the force, root mean square [N]
    QString name;
    bool onFront = false;
};

struct TradeOffPoints {
    std::vector<TradeOffPoint> points;
    double forceScale = 0.0;  ///< that errors are shares of [N]
};

/// Force error against time of each choice, both logarithmic, the error in nN and as a share. The
/// front is joined and numbered from its cheapest; errors below kNoticedShare are drawn there.
class TradeOffChart : public QWidget {
    Q_OBJECT

public:
    explicit TradeOffChart(QWidget* parent = nullptr);
    ~TradeOffChart() override;
    TradeOffChart(const TradeOffChart&) = delete;
    TradeOffChart& operator=(const TradeOffChart&) = delete;

    /// Empty: the chart is hidden behind `hint`.
    void setPoints(const TradeOffPoints& points, const QString& hint);
    /// Rings a point; -1: none.
    void setCurrent(int index);
    /// The point that is ringed; -1: none.
    [[nodiscard]] int current() const { return current_; }

    /// Name, time [s] and error [N] of each point.
    [[nodiscard]] PlotTable table() const;

    /// Returns the widget in which the mouse picks points.
    [[nodiscard]] QWidget& canvas() const;
    /// Returns the position of a point on the canvas [px].
    [[nodiscard]] QPoint positionOf(int index) const;

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void picked(int index);

private:
    class Plot;  ///< what Qwt draws

    /// Nearest point within reach of the mouse; -1: none.
    [[nodiscard]] int nearest(const QPoint& position) const;
    [[nodiscard]] QString textOf(int index) const;

    TradeOffPoints shown_;
    int current_ = -1;
    std::unique_ptr<Plot> plot_;
};

/// Points on the front, the cheapest first: index 0 has number 1.
[[nodiscard]] std::vector<int> frontOf(const std::vector<TradeOffPoint>& points);

}  // namespace asperity
