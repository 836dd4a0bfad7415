#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"
#include "ui/widgets/Steady.h"

#include <QColor>
#include <QPointF>
#include <QString>
#include <QVector>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QHBoxLayout;

namespace asperity {

/// Colors of the two branches, told apart with any color vision.
struct BranchColors {
    QColor approach;
    QColor retract;
};

/// Returns the colors of the newest cycle (age 0), or of an older one: the older the fainter.
[[nodiscard]] BranchColors branchColors(int age);

/// Names of the two branches: those of CurveBranch, whose table is C++20.
struct BranchNames {
    QString approach;
    QString retract;
};
[[nodiscard]] BranchNames branchNames();

/// One cycle as it is drawn; points are distance [m] and force [N]. A force that is not a number
/// parts two pieces.
struct DrawnCycle {
    QVector<QPointF> approach;
    QVector<QPointF> retract;
    std::optional<QPointF> snapIn;   ///< marked with a ring
    std::optional<QPointF> pullOff;  ///< same
};

/// A measured curve as it is drawn over the cycles; points as theirs.
struct DrawnMeasurement {
    QString name;  ///< empty: there is none
    QVector<QPointF> approach;
    QVector<QPointF> retract;
};

/// Force-distance curves of a few cycles over one another, the newest in full colors, and a
/// measured one in ink. A user may zoom and pan (PlotNavigation); a hovering pointer reads them.
class ForceDistancePlot : public QWidget {
public:
    static constexpr int kMaxCycles = 4;

    explicit ForceDistancePlot(QWidget* parent = nullptr);
    ~ForceDistancePlot() override;
    ForceDistancePlot(const ForceDistancePlot&) = delete;
    ForceDistancePlot& operator=(const ForceDistancePlot&) = delete;

    /// @param newestFirst at most kMaxCycles
    /// @param distances   what the distance axis must hold [m]
    void setCycles(const std::vector<DrawnCycle>& newestFirst, const AxisRange& distances,
                   const DrawnMeasurement& measured = {});
    /// Distance [m] and force [N] of both branches of each cycle, the newest first, and of the
    /// measured curve.
    [[nodiscard]] PlotTable table() const;
    /// As they were drawn last, the newest first.
    [[nodiscard]] const std::vector<DrawnCycle>& cycles() const { return cycles_; }
    [[nodiscard]] const DrawnMeasurement& measured() const { return measured_; }
    /// Another quantity is on the distance axis: it ranges itself again.
    void forgetRange();
    /// Returns the row beside the legend, for controls of the plot.
    [[nodiscard]] QHBoxLayout& heading();

    /// Returns what the cursor reads; empty: the pointer is elsewhere.
    [[nodiscard]] QString reading() const;
    [[nodiscard]] bool isZoomed() const;
    [[nodiscard]] QWidget& canvas();

    /// Ranges that the plot shows by default, without zoom.
    [[nodiscard]] const AxisRange& forceRange() const { return forces_.range(); }        ///< [N]
    [[nodiscard]] const AxisRange& distanceRange() const { return distances_.range(); }  ///< [m]

private:
    class Canvas;  ///< what Qwt draws

    void fitRanges(const AxisRange& distances);
    void draw();

    std::vector<DrawnCycle> cycles_;  ///< the newest first
    DrawnMeasurement measured_;
    SteadyRange forces_;
    SteadyRange distances_;
    SteadyScale forceScale_;
    SteadyScale distanceScale_;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace asperity
