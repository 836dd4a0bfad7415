#include "core/map/RetractCurve.h"

#include "core/contact/laws/ForceCurve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

constexpr int kSteps = 32;

/// @param base its height [m] @param force along z [N]
RetractPoint retractPointAt(const VerticalPath& path, double base, double force) {
    return {.height = base + (path.complianceZ() * force), .force = force};
}

RetractPoint retractPointOf(const VerticalPath& path, const TipAtHeight& tip) {
    return retractPointAt(path, tip.base, tip.force());
}

/// Between two steps the tip may pull harder than at both: where no law has the strongest pull, the
/// steps beside it are halved, and again. @param ofLaw whether one has that of a single point
void refineStrongest(VerticalPath& path, std::vector<TipAtHeight>& passed, bool ofLaw) {
    constexpr int kHalvings = 3;
    const auto addBetween = [&](std::ptrdiff_t left) {
        const TipAtHeight& from = passed[static_cast<std::size_t>(left)];
        const TipAtHeight& to = passed[static_cast<std::size_t>(left) + 1];
        TipAtHeight between = path.at(std::midpoint(from.base, to.base), from.memory);
        if (between.state.converged) {
            passed.insert(passed.begin() + left + 1, std::move(between));
        }
    };
    for (int i = 0; i < kHalvings; ++i) {
        const auto strongest = std::ranges::min_element(passed, {}, &TipAtHeight::force);
        if (ofLaw && strongest->state.points == 1) {
            return;
        }
        const std::ptrdiff_t index = strongest - passed.begin();
        if (strongest + 1 != passed.end()) {
            addBetween(index);
        }
        if (index > 0) {
            addBetween(index - 1);
        }
    }
}

/// The rest of the attraction falls with the square of the distance: steps grow.
std::vector<RetractPoint> freeWay(VerticalPath& path, const TipAtHeight& first, double pull) {
    constexpr double kFirstStep = 0.02;  // of the tip's radius
    constexpr double kGrowth = 1.4;
    constexpr double kEnd = 1e-3;  // of the pull
    constexpr int kMaxPoints = 24;
    std::vector<RetractPoint> points{retractPointOf(path, first)};
    double step = kFirstStep * path.instrument().system().tipRadius();
    TipAtHeight tip = first;
    while (points.back().force < -kEnd * pull && points.size() < kMaxPoints) {
        tip = path.at(tip.base + step, tip.memory);
        points.push_back(retractPointOf(path, tip));
        step *= kGrowth;
    }
    return points;
}

/// Between two points of the curve, where it pulls; the force as a straight line [J].
double pullingArea(const RetractPoint& from, const RetractPoint& to) {
    const double pull = std::max(0.0, -from.force);
    const double next = std::max(0.0, -to.force);
    const double swing = std::abs(to.force - from.force);
    const bool crosses = (from.force > 0.0) != (to.force > 0.0);
    const double share = crosses && swing > 0.0 ? std::max(pull, next) / swing : 1.0;
    return 0.5 * (pull + next) * share * (to.height - from.height);
}

/// Energy of bonded states [J].
double pullingArea(std::span<const RetractPoint> points) {
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        area += pullingArea(points[i - 1], points[i]);
    }
    return area;
}

/// Energy of a free tip, to infinity: exact for a pull that falls with the distance squared [J].
double freeArea(std::span<const RetractPoint> points) {
    double area = 0.0;
    double rest = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double near = std::max(0.0, -points[i - 1].force);
        const double far = std::max(0.0, -points[i].force);
        const double step = points[i].height - points[i - 1].height;
        const double mean = std::sqrt(near * far);
        area += mean * step;
        rest = near > mean ? far * step / (1.0 - (mean / near)) : 0.0;
    }
    return area + rest;
}

/// Slope of a least-squares line, of differences from the first point.
class LineFit {
public:
    void add(double x, double y) noexcept {
        if (count_ == 0) {
            x0_ = x;
            y0_ = y;
        }
        ++count_;
        x -= x0_;
        y -= y0_;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] double slope() const noexcept {
        return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_);
    }

private:
    int count_ = 0;
    double x0_ = 0.0;
    double y0_ = 0.0;
    double x_ = 0.0;
    double y_ = 0.0;
    double xx_ = 0.0;
    double xy_ = 0.0;
};

}  // namespace

std::optional<RetractCurve> retract(VerticalPath& path, TipAtHeight atSetpoint) {
    const double step = heightToPullOff(path, atSetpoint) / kSteps;
    path.goUp();
    // Friction turns before the base moves; on a slope that moves the tip to the side.
    TipAtHeight turned = path.at(atSetpoint.base, atSetpoint.memory);
    std::vector<TipAtHeight> passed{std::move(atSetpoint)};
    std::optional<FoundJump> pullOff = findPullOff(path, std::move(turned), step, passed);
    if (!pullOff) {
        return std::nullopt;
    }
    std::erase_if(passed, [](const TipAtHeight& tip) { return !tip.state.converged; });
    refineStrongest(path, passed, pullOff->exact.has_value());
    RetractCurve curve{.bonded = {},
                       .free = {},
                       .pullOff = std::move(*pullOff),
                       .strongest = *std::ranges::min_element(passed, {}, &TipAtHeight::force),
                       .jumpWork = 0.0};
    for (const TipAtHeight& tip : passed) {
        curve.bonded.push_back(retractPointOf(path, tip));
    }
    const double pull = std::max(0.0, -curve.strongest.force());
    const FoundJump& jump = curve.pullOff;
    const RetractPoint last = retractPointAt(path, jump.base, jump.forceBefore());
    curve.bonded.push_back(last);
    curve.jumpWork = pullingArea(last, retractPointAt(path, jump.base, jump.forceAfter()));
    curve.free = freeWay(path, curve.pullOff.after, pull);
    return curve;
}

double separationWork(const RetractCurve& curve) noexcept {
    return pullingArea(curve.bonded) + curve.jumpWork + freeArea(curve.free);
}

std::optional<RetractPoint> strongestOfLaw(const VerticalPath& path,
                                           const RetractCurve& curve) noexcept {
    if (!curve.pullOff.exact) {
        return std::nullopt;
    }
    const TipState& state = curve.strongest.state;
    const double compliance = path.compliance(state);
    const std::optional<ForceCurvePoint> strongest =
        strongestPullOf(contactModelAt(path.instrument().system(), state), compliance);
    if (!strongest || state.points != 1) {
        return std::nullopt;
    }
    const double normal = state.closest.normal.z();
    const double approach = state.contact.indentation + (compliance * state.contact.force);
    const double below = (strongest->basePosition - approach) / std::max(normal, kMinNormalZ);
    return retractPointAt(path, curve.strongest.base - below, strongest->state.force * normal);
}

double strongestPull(const VerticalPath& path, const RetractCurve& curve) noexcept {
    double pull = 0.0;
    for (const RetractPoint& point : curve.bonded) {
        pull = std::max(pull, -point.force);
    }
    const std::optional<RetractPoint> ofLaw = strongestOfLaw(path, curve);
    return ofLaw ? std::max(pull, -ofLaw->force) : pull;
}

double dmtModulus(std::span<const RetractPoint> unloading, double adhesion,
                  double tipRadius) noexcept {
    constexpr double kLow = 0.3;
    constexpr double kHigh = 0.9;
    constexpr int kMinPoints = 3;
    const double range = unloading.empty() ? 0.0 : unloading.front().force + adhesion;
    LineFit line;
    for (const RetractPoint& point : unloading) {
        const double load = point.force + adhesion;
        if (load >= kLow * range && load <= kHigh * range) {
            line.add(point.height, std::cbrt(load * load));
        }
    }
    const double slope = line.count() < kMinPoints ? 0.0 : -line.slope();
    return slope > 0.0 ? 0.75 * slope * std::sqrt(slope / tipRadius)
                       : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace asperity
