#include "core/contact/laws/ForceCurve.h"

#include "core/Error.h"
#include "core/contact/ContactState.h"
#include "core/contact/ContactStatus.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The next approach that rounding tells from this one in any sum with it.
double justBeyond(double approach) {
    return approach + (16.0 * std::numeric_limits<double>::epsilon() * std::abs(approach)) +
           std::numeric_limits<double>::min();
}

/// Base positions from one to another [m].
struct Way {
    double from = 0.0;
    double to = 0.0;
    int points = 2;
};

/// The states along a way, in its order, both sides of a jump among them.
std::vector<ForceCurvePoint> follow(const ContactModel& model, double compliance, const Way& along,
                                    const std::optional<TipJump>& jump) {
    const auto [from, to, points] = along;
    std::vector<ForceCurvePoint> way;
    ContactMemory memory = from < to ? kFar : kBondedMemory;
    bool passed = !jump;
    for (int i = 0; i < points; ++i) {
        const double position = from + ((to - from) * i / (points - 1));
        const bool beyond =
            jump && (from < to ? position > jump->basePosition : position < jump->basePosition);
        if (beyond && !passed) {
            way.push_back({jump->basePosition, jump->before});
            way.push_back({jump->basePosition, jump->after});
            memory = jump->after.memory();
            passed = true;
        }
        const ContactState state = model.equilibrium(position, compliance, memory);
        memory = state.memory();
        way.push_back({position, state});
    }
    return way;
}

/// The first step beyond `least` at which the tip is pushed as hard as the pull-off pulls; a few
/// steps at most, since a soft sample may never push so hard at a depth of interest.
double repulsiveApproach(const ContactModel& model, double compliance, double least) {
    constexpr int kSteps = 12;
    constexpr double kGrowth = 1.25;
    const double pull = -model.lastBonded(compliance).force;
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
    curve.approach =
        follow(model, compliance, {plan.farthest, plan.deepest, plan.points}, curve.snapIn);
    curve.retract =
        follow(model, compliance, {plan.deepest, plan.farthest, plan.points}, curve.pullOff);
    return curve;
}

}  // namespace asperity
