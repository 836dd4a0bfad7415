#include "core/contact/laws/ForceCurve.h"

#include "core/Error.h"
#include "core/contact/ContactState.h"
#include "core/contact/numerics/RootSearch.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace asperity {

namespace {

constexpr ContactMemory kFar{};

void requireLever(double compliance) {
    if (checkRequest(0.0, compliance) != ContactStatus::Solved) {
        throw Error("force curve: the lever's compliance must lie between 0 and 1e6 m/N");
    }
}

void requirePlan(const ForceCurvePlan& plan) {
    constexpr int kMaxPoints = 1'000'000;
    const bool within = checkRequest(plan.farthest, 0.0) == ContactStatus::Solved &&
                        checkRequest(plan.deepest, 0.0) == ContactStatus::Solved;
    if (!within || !(plan.farthest < plan.deepest)) {
        throw Error("force curve: it must begin farther away than it ends, both within 1000 m");
    }
    if (plan.points < 2 || plan.points > kMaxPoints) {
        throw Error("force curve: expected 2 to 1000000 points on each branch");
    }
}

/// The next approach that differs from this one after rounding in any sum with it.
double justBeyond(double approach) {
    return approach + (16.0 * std::numeric_limits<double>::epsilon() * std::abs(approach)) +
           std::numeric_limits<double>::min();
}

/// A way of the base from one position to another [m].
struct Way {
    double from = 0.0;
    double to = 0.0;
    int points = 2;
    ContactMemory start;               ///< of the tip at `from`
    std::optional<TipJump> jump = {};  ///< on the way

    [[nodiscard]] bool approaches() const { return from < to; }
    [[nodiscard]] bool comesAfter(double position, double other) const {
        return approaches() ? position > other : position < other;
    }
    [[nodiscard]] bool isPastJump(double position) const {
        return jump && comesAfter(position, jump->basePosition);
    }
    [[nodiscard]] ContactMemory memoryAt(double position) const {
        return isPastJump(position) ? jump->after.memory() : start;
    }
};

/// The way with the jump where it lies on it, or with what the jump left where it lies before it.
Way withJump(Way way, const std::optional<TipJump>& jump) {
    if (jump && way.comesAfter(way.from, jump->basePosition)) {
        way.start = jump->after.memory();
    } else if (jump && way.comesAfter(way.to, jump->basePosition)) {
        way.jump = jump;
    }
    return way;
}

/// A position of the curve.
struct Knot {
    double position = 0.0;  ///< of the base [m]
    double force = 0.0;     ///< [N]
};

/// Places the points of a way so that neighbors lie about equally far apart along the curve, as it
/// is drawn with its whole range of positions and forces: of two knots, the pair that is farthest
/// apart gets another one between them, until there are enough. A jump is no distance.
class PointPlacing {
public:
    PointPlacing(const ContactModel& model, double compliance, const Way& way)
        : model_(model), compliance_(compliance), way_(way) {}

    /// The base positions, in the order of the way. @param strongest a point that the way may pass
    [[nodiscard]] std::vector<double> positions(const std::optional<ForceCurvePoint>& strongest) {
        std::vector<Knot> knots = firstKnots(strongest);
        const auto [lowest, highest] = std::ranges::minmax_element(knots, {}, &Knot::force);
        forceRange_ = std::max(highest->force - lowest->force, std::numeric_limits<double>::min());
        std::vector<double> found;
        for (std::size_t i = 0; i < knots.size(); ++i) {
            const bool isJump = way_.jump && knots[i].position == way_.jump->basePosition;
            if (!isJump) {
                found.push_back(knots[i].position);
            }
            if (i > 0 && knots[i].position != knots[i - 1].position) {
                push(knots[i - 1], knots[i]);
            }
        }
        while (std::ssize(found) < way_.points) {
            found.push_back(splitFarthest());
        }
        std::ranges::sort(found);
        if (!way_.approaches()) {
            std::ranges::reverse(found);
        }
        return found;
    }

private:
    struct Gap {
        double length = 0.0;  ///< in ranges of position and force
        Knot from;
        Knot to;
        bool operator<(const Gap& other) const { return length < other.length; }
    };

    [[nodiscard]] Knot knotAt(double position) const {
        const ContactMemory memory = way_.memoryAt(position);
        return {position, model_.equilibrium(position, compliance_, memory).force};
    }

    /// The ends of the way, both sides of its jump and the strongest pull.
    [[nodiscard]] std::vector<Knot>
    firstKnots(const std::optional<ForceCurvePoint>& strongest) const {
        std::vector<Knot> knots{knotAt(way_.from), knotAt(way_.to)};
        if (way_.jump) {
            const double position = way_.jump->basePosition;
            knots.insert(knots.begin() + 1,
                         {{position, way_.jump->before.force}, {position, way_.jump->after.force}});
        }
        const std::optional<Knot> pull = strongest && way_.points > 2
                                             ? std::optional(knotAt(strongest->basePosition))
                                             : std::nullopt;
        for (std::size_t i = 1; pull && i < knots.size(); ++i) {
            const auto [low, high] = std::minmax(knots[i - 1].position, knots[i].position);
            const bool isBonded = (i == 1) != way_.approaches() || !way_.jump;
            if (isBonded && pull->position > low && pull->position < high) {
                knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(i), *pull);
                break;
            }
        }
        return knots;
    }

    void push(const Knot& from, const Knot& to) {
        const double across = (to.position - from.position) / (way_.to - way_.from);
        const double up = (to.force - from.force) / forceRange_;
        gaps_.push({std::hypot(across, up), from, to});
    }

    double splitFarthest() {
        const Gap gap = gaps_.top();
        gaps_.pop();
        const Knot middle = knotAt(std::midpoint(gap.from.position, gap.to.position));
        push(gap.from, middle);
        push(middle, gap.to);
        return middle.position;
    }

    const ContactModel& model_;
    double compliance_;
    Way way_;
    double forceRange_ = 1.0;  ///< [N]
    std::priority_queue<Gap> gaps_;
};

/// The states along a way, in its order, both sides of a jump among them.
std::vector<ForceCurvePoint> follow(const ContactModel& model, double compliance, const Way& way,
                                    const std::optional<ForceCurvePoint>& strongest) {
    std::vector<ForceCurvePoint> points;
    ContactMemory memory = way.memoryAt(way.from);
    bool passed = !way.jump;
    for (const double position : PointPlacing(model, compliance, way).positions(strongest)) {
        if (way.isPastJump(position) && !passed) {
            points.push_back({way.jump->basePosition, way.jump->before});
            points.push_back({way.jump->basePosition, way.jump->after});
            memory = way.jump->after.memory();
            passed = true;
        }
        const ContactState state = model.equilibrium(position, compliance, memory);
        memory = state.memory();
        points.push_back({position, state});
    }
    return points;
}

/// The first step beyond `least` at which the tip is pushed as hard as the pull-off pulls; a few
/// steps at most, since a soft sample may never push so hard at a depth of interest.
double repulsiveApproach(const ContactModel& model, double compliance, double least) {
    constexpr int kSteps = 12;
    constexpr double kGrowth = 1.25;
    const std::optional<ForceCurvePoint> strongest = strongestPullOf(model, compliance);
    const double pull = strongest ? -strongest->state.force : 0.0;
    double approach = least;
    for (int i = 0;
         i < kSteps && model.equilibrium(approach, compliance, kBondedMemory).force < pull; ++i) {
        approach *= kGrowth;
    }
    return approach;
}

}  // namespace

std::optional<TipJump> snapInOf(const ContactModel& model, double compliance) noexcept {
    const double end = model.jumpInApproach(compliance);
    const TipJump jump{end, model.lastFar(compliance),
                       model.equilibrium(justBeyond(end), compliance, kFar)};
    return jump.after.jumped ? std::optional(jump) : std::nullopt;
}

std::optional<TipJump> pullOffOf(const ContactModel& model, double compliance) noexcept {
    const double end = model.pullOffApproach(compliance);
    const double gone = -justBeyond(-end);
    const TipJump jump{end, model.lastBonded(compliance),
                       model.equilibrium(gone, compliance, kBondedMemory)};
    return jump.after.jumped ? std::optional(jump) : std::nullopt;
}

std::optional<ForceCurvePoint> strongestPullOf(const ContactModel& model,
                                               double compliance) noexcept {
    // Under a lever this soft the tip pulls off where it pulls hardest.
    const ContactState state = model.lastBonded(kMaxCompliance);
    return state.force < 0.0 ? std::optional(ForceCurvePoint{
                                   state.indentation + (compliance * state.force), state})
                             : std::nullopt;
}

std::optional<double> basePositionAt(const ContactModel& model, double compliance,
                                     double force) noexcept {
    const auto forceAt = [&](double position) {
        return model.equilibrium(position, compliance, kBondedMemory).force;
    };
    // Beyond its strongest pull a law rises without end, or has no equilibrium any more.
    double high = model.pair().tipRadius * 1e-3;
    while (forceAt(high) < force) {
        high *= 2.0;
        if (checkRequest(high, compliance) != ContactStatus::Solved ||
            !model.equilibrium(high, compliance, kBondedMemory).solved()) {
            return std::nullopt;
        }
    }
    return rootBetween([&](double position) { return forceAt(position) - force; }, 0.0, high);
}

ForceCurvePlan curvePlan(const ContactModel& model, double compliance) {
    requireLever(compliance);
    const double pullOff = model.pullOffApproach(compliance);
    const double reach =
        std::max({-pullOff, -model.jumpInApproach(compliance), 0.05 * model.pair().tipRadius});
    return {.farthest = -1.5 * reach, .deepest = repulsiveApproach(model, compliance, reach)};
}

ForceCurve forceCurve(const ContactModel& model, double compliance, const ForceCurvePlan& plan) {
    requireLever(compliance);
    requirePlan(plan);
    ForceCurve curve;
    curve.snapIn = snapInOf(model, compliance);
    curve.pullOff = pullOffOf(model, compliance);
    curve.strongest = strongestPullOf(model, compliance);
    const Way in{.from = plan.farthest, .to = plan.deepest, .points = plan.points, .start = kFar};
    curve.approach = follow(model, compliance, withJump(in, curve.snapIn), curve.strongest);
    const ContactMemory turned = curve.approach.back().state.memory();
    Way out{.from = plan.deepest, .to = plan.farthest, .points = plan.points, .start = turned};
    if (turned.branch == ContactBranch::Bonded) {
        out = withJump(out, curve.pullOff);
    }
    curve.retract = follow(model, compliance, out, curve.strongest);
    return curve;
}

}  // namespace asperity
