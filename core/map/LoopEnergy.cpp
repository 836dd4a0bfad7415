#include "core/map/LoopEnergy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

constexpr int kBondedSteps = 24;
constexpr int kFreeSteps = 6;

/// A state of the tip by the height of the base.
struct BasePoint {
    double base = 0.0;   ///< [m]
    double force = 0.0;  ///< along z [N]
};

/// Area under a line of points in rising order [J].
double areaUnder(const std::vector<BasePoint>& points) {
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        area +=
            0.5 * (points[i - 1].force + points[i].force) * (points[i].base - points[i - 1].base);
    }
    return area;
}

std::vector<BasePoint> wayUp(const VerticalPath& path, const RetractCurve& curve) {
    std::vector<BasePoint> points;
    for (const RetractPoint& point : curve.bonded) {
        points.push_back({point.height - (path.complianceZ() * point.force), point.force});
    }
    // Near to the jump its search goes back and forth.
    std::ranges::sort(points, {}, &BasePoint::base);
    return points;
}

/// Bonded, from the setpoint up to the snap-in.
void addBondedWay(VerticalPath& path, const Engagement& engaged, std::vector<BasePoint>& points) {
    const double top = engaged.snapIn.base;
    const double bottom = engaged.atSetpoint.base;
    std::vector<BasePoint> down;
    EquilibriumMemory memory = engaged.snapIn.after.memory;
    for (int i = 0; i < kBondedSteps; ++i) {
        const TipAtHeight tip =
            path.at(std::lerp(top, bottom, static_cast<double>(i) / kBondedSteps), memory);
        memory = tip.memory;
        down.push_back({tip.base, tip.force()});
    }
    down.push_back({bottom, engaged.atSetpoint.force()});
    points.insert(points.end(), down.rbegin(), down.rend());
}

/// Free, from the snap-in up to the pull-off. Near the snap-in the attraction changes most: steps
/// are shorter there.
void addFreeWay(VerticalPath& path, const FoundJump& snapIn, double top,
                std::vector<BasePoint>& points) {
    points.push_back({snapIn.base, snapIn.forceBefore()});
    EquilibriumMemory memory = snapIn.before.memory;
    for (int i = 1; i <= kFreeSteps; ++i) {
        const double share = static_cast<double>(i) / kFreeSteps;
        const TipAtHeight tip = path.at(std::lerp(snapIn.base, top, share * share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
}

/// The way down, as points in rising order.
std::vector<BasePoint> wayDown(VerticalPath& path, const Engagement& engaged, double top) {
    std::vector<BasePoint> points;
    path.goDown();
    addBondedWay(path, engaged, points);
    addFreeWay(path, engaged.snapIn, top, points);
    return points;
}

}  // namespace

double loopEnergy(VerticalPath& path, const Engagement& engaged, const RetractCurve& curve) {
    const std::vector<BasePoint> down = wayDown(path, engaged, curve.pullOff.base);
    return std::max(0.0, areaUnder(down) - areaUnder(wayUp(path, curve)));
}

}  // namespace asperity
