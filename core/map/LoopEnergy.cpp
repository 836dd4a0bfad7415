#include "core/map/LoopEnergy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

constexpr int kFreeSteps = 6;

/// A state of the tip by the height of the base.
struct BasePoint {
    double base = 0.0;   ///< [m]
    double force = 0.0;  ///< along z [N]
};

/// Area under a line of points in rising order, from a height on [J].
double areaAbove(const std::vector<BasePoint>& points, double from) {
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto& [low, lowForce] = points[i - 1];
        const auto& [high, highForce] = points[i];
        if (high <= from || high <= low) {
            continue;
        }
        const double begin = std::max(low, from);
        const double beginForce = std::lerp(lowForce, highForce, (begin - low) / (high - low));
        area += 0.5 * (beginForce + highForce) * (high - begin);
    }
    return area;
}

std::vector<BasePoint> bondedBranch(const VerticalPath& path, const RetractCurve& curve) {
    std::vector<BasePoint> points;
    for (const RetractPoint& point : curve.bonded) {
        points.push_back({point.height - (path.complianceZ() * point.force), point.force});
    }
    std::ranges::sort(points, {},
                      &BasePoint::base);  // near the jump its search goes back and forth
    return points;
}

/// From the height of the snap-in up to that of the pull-off. Near the snap-in the attraction
/// changes most: steps are shorter there.
std::vector<BasePoint> freeBranch(VerticalPath& path, const FoundJump& snapIn,
                                  const FoundJump& pullOff) {
    std::vector<BasePoint> points{{snapIn.base, snapIn.forceBefore()}};
    EquilibriumMemory memory = snapIn.before.memory;
    for (int i = 1; i <= kFreeSteps; ++i) {
        const double share = static_cast<double>(i) / kFreeSteps;
        const TipAtHeight tip =
            path.at(std::lerp(snapIn.base, pullOff.base, share * share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
    return points;
}

}  // namespace

double loopEnergy(VerticalPath& path, const FoundJump& snapIn, const RetractCurve& curve) {
    path.goUp();
    const double free = areaAbove(freeBranch(path, snapIn, curve.pullOff), snapIn.base);
    const double bonded = areaAbove(bondedBranch(path, curve), snapIn.base);
    return std::max(0.0, free - bonded);
}

}  // namespace asperity
