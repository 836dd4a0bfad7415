#include "core/fidelity/SampledCycle.h"

#include "core/map/Engagement.h"
#include "core/map/RetractCurve.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

/// What rounding leaves of a search for the setpoint, see findForce(), and of its tip.
constexpr double kRounding = 1e-9;

/// The difference as a share of `scale`, which is that of the reference.
double shareOf(double value, double reference, double scale, double rounding) {
    const double difference = std::abs(value - reference);
    if (!(difference > rounding)) {
        return std::isfinite(difference) ? 0.0 : 1.0;
    }
    return scale > rounding ? difference / scale : 1.0;
}

/// Of a quantity as a share of itself; where the reference has none, all of it is wrong.
double shareOf(double value, double reference, double rounding) {
    return shareOf(value, reference, std::abs(reference), rounding);
}

ForceLine::Point linePointOf(const VerticalPath& path, const RetractPoint& point) {
    return {.base = point.height - (path.complianceZ() * point.force), .force = point.force};
}

/// A jump of a line.
struct LineJump {
    double base = 0.0;    ///< [m]
    double bonded = 0.0;  ///< force below it [N]
    double free = 0.0;    ///< and above it [N]
};

/// The bonded points below a jump, the jump, and the free points above it.
ForceLine lineOf(std::vector<ForceLine::Point> bonded, const LineJump& jump,
                 const std::vector<ForceLine::Point>& free) {
    std::vector<ForceLine::Point> points = std::move(bonded);
    std::erase_if(points, [&](const ForceLine::Point& point) { return point.base >= jump.base; });
    // Near to the pull-off its search goes back and forth by some picometers.
    std::ranges::stable_sort(points, {}, &ForceLine::Point::base);
    points.push_back({jump.base, jump.bonded});
    points.push_back({jump.base, jump.free});
    for (const ForceLine::Point& point : free) {
        if (point.base > points.back().base) {
            points.push_back(point);
        }
    }
    return ForceLine(std::move(points));
}

std::vector<ForceLine::Point> linePointsOf(const VerticalPath& path,
                                           const std::vector<RetractPoint>& points) {
    std::vector<ForceLine::Point> line;
    std::ranges::transform(points, std::back_inserter(line),
                           [&](const RetractPoint& point) { return linePointOf(path, point); });
    return line;
}

/// Down from the snap-in to the setpoint: friction acts the other way than on the retract.
std::vector<ForceLine::Point> pressedWay(VerticalPath& path, const Engagement& engaged) {
    constexpr int kSteps = 16;
    const TipAtHeight& first = engaged.snapIn.after;
    std::vector<ForceLine::Point> points;
    EquilibriumMemory memory = first.memory;
    path.goDown();
    for (int i = 1; i < kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const TipAtHeight tip =
            path.at(std::lerp(first.base, engaged.atSetpoint.base, share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
    points.push_back({engaged.atSetpoint.base, engaged.atSetpoint.force()});
    return points;
}

/// The free tip from its snap-in up to the pull-off, where the retract goes on. Near the snap-in
/// the attraction changes most: steps are shorter there.
std::vector<ForceLine::Point> freeWay(VerticalPath& path, const FoundJump& snapIn,
                                      const RetractCurve& curve) {
    constexpr int kSteps = 8;
    const double top = curve.pullOff.base;
    std::vector<ForceLine::Point> points;
    EquilibriumMemory memory = snapIn.before.memory;
    path.goDown();
    for (int i = 1; i <= kSteps && top > snapIn.base; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const TipAtHeight tip = path.at(std::lerp(snapIn.base, top, share * share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
    std::ranges::move(linePointsOf(path, curve.free), std::back_inserter(points));
    return points;
}

ForceLine approachLine(VerticalPath& path, const Engagement& engaged, const RetractCurve& curve) {
    const FoundJump& jump = engaged.snapIn;
    return lineOf(pressedWay(path, engaged), {jump.base, jump.forceAfter(), jump.forceBefore()},
                  freeWay(path, jump, curve));
}

ForceLine retractLine(const VerticalPath& path, const RetractCurve& curve) {
    const FoundJump& jump = curve.pullOff;
    return lineOf(linePointsOf(path, curve.bonded),
                  {jump.base, jump.forceBefore(), jump.forceAfter()},
                  linePointsOf(path, curve.free));
}

/// By how much the indentation falls from a state until the tip pulls off [m].
double pulledFrom(const ContactState& contact, const FoundJump& pullOff) {
    return contact.indentation - (pullOff.exact ? pullOff.exact->before.indentation
                                                : pullOff.before.state.contact.indentation);
}

/// Integral of the square of what a function has between two heights, exact for straight lines.
template <class Function>
double squareBetween(double low, double high, const Function& function) {
    const double middle = std::midpoint(low, high);
    const double half = 0.5 * (high - low) / std::sqrt(3.0);  // Gauss, two points
    const double below = function(middle - half);
    const double above = function(middle + half);
    return 0.5 * (high - low) * (below * below + above * above);
}

/// Adds the squares of a difference over one way from a height of the base up, and of the
/// reference.
/// @param jump, jumpOfReference where the tip changes between free and bonded
void addSquares(const ForceLine& line, double jump, const ForceLine& reference,
                double jumpOfReference, double from, ForceSquares& squares) {
    const auto [first, last] = std::minmax(jump, jumpOfReference);
    std::vector<double> heights;
    for (const ForceLine* const each : {&line, &reference}) {
        for (const ForceLine::Point& point : each->points()) {
            heights.push_back(std::max(point.base, from));
        }
    }
    std::ranges::sort(heights);
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const double low = heights[i - 1];
        const double high = heights[i];
        const bool isBetween = low >= first && high <= last;
        (isBetween ? squares.heldByOne : squares.heldAlike) += squareBetween(
            low, high, [&](double base) { return line.at(base) - reference.at(base); });
        squares.reference +=
            squareBetween(low, high, [&](double base) { return reference.at(base); });
    }
}

/// Of the force over both ways, from where both models have reached the setpoint.
double rmsShare(const SampledCycle& cycle, const SampledCycle& reference) {
    const double from = std::max(cycle.setpointBase, reference.setpointBase);
    ForceSquares squares;
    addSquares(cycle.approach, cycle.snapInBase, reference.approach, reference.snapInBase, from,
               squares);
    addSquares(cycle.retract, cycle.pullOffBase, reference.retract, reference.pullOffBase, from,
               squares);
    return squares.share();
}

}  // namespace

double ForceLine::at(double base) const noexcept {
    const auto above = std::ranges::upper_bound(points_, base, {}, &Point::base);
    if (above == points_.begin() || above == points_.end()) {
        return 0.0;
    }
    const Point& below = *std::prev(above);
    return std::lerp(below.force, above->force, (base - below.base) / (above->base - below.base));
}

std::optional<SampledCycle> sampleCycle(const Scene& scene, const Vector2& place, double setpoint) {
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, place);
    const std::optional<Engagement> engaged = engage(path, setpoint);
    if (!engaged || !engaged->atSetpoint.state.converged) {
        return std::nullopt;
    }
    const TipAtHeight& pressed = engaged->atSetpoint;
    const std::optional<RetractCurve> curve = retract(path, pressed);
    if (!curve) {
        return std::nullopt;
    }
    const ContactState& contact = pressed.state.contact;
    const FoundJump& in = engaged->snapIn;
    const FoundJump& off = curve->pullOff;
    return SampledCycle{.pullOffForce = strongestPull(path, *curve),
                        .pullOffBase = off.base,
                        .snapInForce = std::max(0.0, -in.forceAfter()),
                        .snapInBase = in.base,
                        .setpointBase = pressed.base,
                        .indentation = contact.indentation,
                        .pulled = pulledFrom(contact, off),
                        .stiffness = contact.stiffness,
                        .separationWork = separationWork(*curve),
                        .setpoint = setpoint,
                        .approach = approachLine(path, *engaged, *curve),
                        .retract = retractLine(path, *curve)};
}

QuantityErrors errorsOf(const SampledCycle& cycle, const SampledCycle& reference) {
    const double force = kRounding * reference.setpoint;
    const double travel = reference.pullOffBase - reference.setpointBase;
    const double length = kRounding * travel;
    const auto moved = [&](double SampledCycle::*base) {
        return shareOf(cycle.*base, reference.*base, travel, length);
    };
    QuantityErrors errors;
    errors[JudgedQuantity::PullOffForce] =
        shareOf(cycle.pullOffForce, reference.pullOffForce, force);
    errors[JudgedQuantity::PullOffPosition] = moved(&SampledCycle::pullOffBase);
    errors[JudgedQuantity::SnapInForce] = shareOf(cycle.snapInForce, reference.snapInForce, force);
    errors[JudgedQuantity::SnapInPosition] = moved(&SampledCycle::snapInBase);
    // Under adhesion the indentation is a difference of two lengths and passes 0: as a share of
    // itself it says nothing there, within a tenth of what the retract takes away.
    constexpr double kNearZero = 0.1;
    errors[JudgedQuantity::Indentation] =
        shareOf(cycle.indentation, reference.indentation,
                std::max(std::abs(reference.indentation), kNearZero * reference.pulled), length);
    errors[JudgedQuantity::Stiffness] = shareOf(cycle.stiffness, reference.stiffness, 0.0);
    errors[JudgedQuantity::SeparationWork] =
        shareOf(cycle.separationWork, reference.separationWork, force * travel);
    errors[JudgedQuantity::RunForce] = rmsShare(cycle, reference);
    return errors;
}

}  // namespace asperity
