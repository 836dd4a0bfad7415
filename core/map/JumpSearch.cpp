#include "core/map/JumpSearch.h"

#include "core/surface/deformation/ContactHeight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace asperity {

namespace {

constexpr double kShortest = 1.0 / 32.0;  // step of a way that is sampled, of the longest one
constexpr int kMaxJumpSteps = 400;
constexpr int kMaxJumpHalvings = 60;

enum class Way : std::int8_t { Down = -1, Up = 1 };

/// Returns the length by which the steps of a search are chosen [m]: the base's way between both
/// jumps, by the law at the position; without jumps, the range of its attraction, or the effective
/// radius. The tip's own radius says nothing: a blunt tip may rest on a sharp asperity.
double jumpScale(const VerticalPath& path, const TipAtHeight& tip) {
    const ContactModel law = contactModelAt(path.instrument().system(), tip.state);
    const double compliance = path.compliance(tip.state);
    const double loop = law.jumpInApproach(compliance) - law.pullOffApproach(compliance);
    const double range = law.attractionRange();
    return loop > 0.0 ? loop : range > 0.0 ? range : law.pair().tipRadius;
}

/// Returns how near to a jump the base goes where the law knows the rest [m]: right at it the force
/// goes as the root of the distance. On a way that is sampled nearer than its shortest step: from
/// farther off that step would go on from there, and back, and rounding would say at which of the
/// two the search ends.
double nearOn(const VerticalPath& path, const TipAtHeight& tip, double maxStep) {
    constexpr double kOfStep = 0.5 * kShortest;
    constexpr double kOfScale = 1.0 / 64.0;
    return std::isfinite(maxStep) ? kOfStep * std::abs(maxStep) : kOfScale * jumpScale(path, tip);
}

/// The same where it does not [m].
double resolutionOn(const VerticalPath& path, const TipAtHeight& tip) {
    constexpr double kOfScale = 1e-4;
    return kOfScale * jumpScale(path, tip);
}

/// Way of the undeflected tip towards the surface, along the normal [m].
double approachOf(const VerticalPath& path, const TipAtHeight& tip) {
    const ContactState& contact = tip.state.contact;
    return contact.indentation + (path.compliance(tip.state) * contact.force);
}

/// Returns how far the base has to go until the tip jumps, as the law has it here [m]; at or below
/// 0: it should have jumped.
double wayToJump(const VerticalPath& path, const TipAtHeight& tip, Way way) {
    const ContactModel law = contactModelAt(path.instrument().system(), tip.state);
    const double compliance = path.compliance(tip.state);
    const double approach = approachOf(path, tip);
    const double along = way == Way::Down ? law.jumpInApproach(compliance) - approach
                                          : approach - law.pullOffApproach(compliance);
    return along / std::max(tip.state.closest.normal.z(), kMinNormalZ);
}

/// The next step of the base towards a jump that is so far away. It ends at one distance from the
/// jump, so that the last state is a smooth function of the position. Near to it, where the force
/// bends, steps of a way that is sampled grow short by halves.
double stepTowards(double left, double maxStep, double near) {
    return left > kShortest * maxStep ? std::min(0.5 * left, maxStep) : left - near;
}

/// Returns whether the law of the main contact point can say when the tip jumps. Where another one
/// holds the tip it may ask for a way back, which would push the tip into the sample.
bool isOfMainPoint(const TipAtHeight& tip, double left, Way way, double near) {
    return way == Way::Down || (tip.state.contact.branch == ContactBranch::Bonded && left >= -near);
}

bool isOfOnePoint(const TipAtHeight& before, const TipAtHeight& after) {
    return before.state.points == 1 && after.state.points == 1;
}

/// The contact law's jump at a position.
std::optional<TipJump> jumpOfLaw(const VerticalPath& path, const TipState& state, Way way) {
    const ContactModel law = contactModelAt(path.instrument().system(), state);
    const double compliance = path.compliance(state);
    return way == Way::Down ? snapInOf(law, compliance) : pullOffOf(law, compliance);
}

/// The last height at which the tip is as before, and in equilibrium.
/// @param lost a height at which it is not any more
FoundJump narrowed(VerticalPath& path, TipAtHeight before, double lost, TipAtHeight after) {
    const bool wasBonded = before.isBonded();
    const double resolution = resolutionOn(path, before);
    for (int i = 0; i < kMaxJumpHalvings && std::abs(lost - before.base) > resolution; ++i) {
        TipAtHeight middle = path.at(std::midpoint(before.base, lost), before.memory);
        const bool changed = middle.isBonded() != wasBonded;
        if (middle.state.converged && !changed) {
            before = std::move(middle);
            continue;
        }
        lost = middle.base;
        if (changed) {
            after = std::move(middle);
        }
    }
    TipAtHeight beside = path.at(lost, after.memory);
    if (beside.isBonded() != wasBonded) {
        after = std::move(beside);
    }
    const double base = before.base;
    return {std::move(before), std::move(after), base, false, std::nullopt};
}

/// The jump between two heights. Right at it an equilibrium takes many steps: where the law knows
/// the jump, there is no need to go there.
FoundJump jumpBetween(VerticalPath& path, TipAtHeight before, TipAtHeight after, Way way) {
    if (!isOfOnePoint(before, after)) {
        const double lost = after.base;
        return narrowed(path, std::move(before), lost, std::move(after));
    }
    const double base = before.base + (static_cast<double>(way) * wayToJump(path, before, way));
    const std::optional<TipJump> exact = jumpOfLaw(path, before.state, way);
    return {std::move(before), std::move(after), base, true, exact};
}

/// Returns whether a step was too long for a tip on several points: they have no equilibrium after
/// it, but short steps may follow one.
bool losesTrack(const TipAtHeight& from, const TipAtHeight& next) {
    return from.state.points > 1 && from.state.converged && next.isBonded() &&
           !next.state.converged;
}

/// The base moved by a step, or by a part of it where the tip is followed so only.
TipAtHeight moved(VerticalPath& path, const TipAtHeight& from, double step, double maxStep) {
    TipAtHeight next = path.at(from.base + step, from.memory);
    while (losesTrack(from, next) && step > kShortest * maxStep) {
        step *= 0.5;
        next = path.at(from.base + step, from.memory);
    }
    return next;
}

template <class Visit>
std::optional<FoundJump> findJump(VerticalPath& path, TipAtHeight now, Way way, double maxStep,
                                  const Visit& visit) {
    constexpr double kThere = 1e-4;  // of the distance `near`
    constexpr int kCorrections = 6;
    const bool wasBonded = now.isBonded();
    // Steps of a way that is sampled are as long as it, those of one that is not begin small.
    double push = 2.0 * nearOn(path, now, maxStep);
    int corrections = 0;
    TipAtHeight found = now;  // the last one in equilibrium
    double lost = now.base;   // the next height, at which there was none
    for (int i = 0; i < kMaxJumpSteps; ++i) {
        visit(now);
        const double near = nearOn(path, now, maxStep);
        const double left = wayToJump(path, now, way);
        const bool knowsWay = isOfMainPoint(now, left, way, near);
        double step = stepTowards(left, maxStep, near);
        corrections += knowsWay && step < near ? 1 : 0;
        const bool isThere = std::abs(step) <= kThere * near || corrections > kCorrections;
        if (isThere || !knowsWay) {
            step = push;
            push = std::min(2.0 * push, std::max(push, maxStep));
        }
        TipAtHeight next = moved(path, now, static_cast<double>(way) * step, maxStep);
        if (next.isBonded() != wasBonded) {
            if (isThere && now.state.converged) {
                return jumpBetween(path, std::move(now), std::move(next), way);
            }
            // A lever that bends to the side lets the tip go before the law at one position does.
            if (now.state.converged) {
                found = std::move(now);
                lost = next.base;
            }
            return narrowed(path, std::move(found), lost, std::move(next));
        }
        if (now.state.converged && !next.state.converged) {
            found = now;
            lost = next.base;
        }
        now = std::move(next);
    }
    return std::nullopt;
}

constexpr double kTolerance = 1e-12;     // of the force
constexpr double kSmallestStep = 1e-15;  // [m]
constexpr double kGrowth = 2.0;          // of a step over the one before
constexpr int kMaxForceSteps = 100;
constexpr int kMaxForceHalvings = 100;
constexpr int kMaxAway = 3;  // steps in turn that lead away from the force

/// Force along z per height of the base, by the main contact point [N/m]; never zero.
double slopeAt(const VerticalPath& path, const TipAtHeight& tip) {
    constexpr double kMin = 1e-3;  // of the lever's stiffness
    const double stiffness = std::max(0.0, tip.state.contact.stiffness);
    const double normal = tip.state.closest.normal.z();
    const double along = stiffness / (1.0 + (path.compliance(tip.state) * stiffness));
    return std::max(along * normal * normal, kMin / path.complianceZ());
}

/// The search between a height that pushes less than the force and one that pushes as hard.
class Bracket {
public:
    Bracket(VerticalPath& path, TipAtHeight less, TipAtHeight more, const SoughtForce& force)
        : path_(path)
        , force_(force)
        , less_(std::move(less))
        , more_(std::move(more))
        , lessMiss_(miss(less_))
        , moreMiss_(miss(more_)) {}

    /// Illinois: the false position, whose end that stays counts half.
    TipAtHeight solve() {
        for (int i = 0; i < kMaxForceHalvings && !isDone(); ++i) {
            const double share = lessMiss_ / (lessMiss_ - moreMiss_);
            const double base = std::lerp(less_.base, more_.base, share);
            if (base == less_.base || base == more_.base) {
                break;
            }
            take(path_.at(base, less_.memory));
        }
        return std::abs(miss(less_)) < std::abs(miss(more_)) ? less_ : more_;
    }

private:
    [[nodiscard]] double miss(const TipAtHeight& tip) const {
        return force_.of(tip) - force_.value;
    }
    [[nodiscard]] bool isDone() const {
        return std::min(std::abs(miss(less_)), std::abs(miss(more_))) <=
               kTolerance * std::abs(force_.value);
    }

    void take(TipAtHeight tip) {
        const double missed = miss(tip);
        if (missed < 0.0) {
            moreMiss_ *= stayed_ > 0 ? 0.5 : 1.0;
            stayed_ = 1;
            lessMiss_ = missed;
            less_ = std::move(tip);
        } else {
            lessMiss_ *= stayed_ < 0 ? 0.5 : 1.0;
            stayed_ = -1;
            moreMiss_ = missed;
            more_ = std::move(tip);
        }
    }

    VerticalPath& path_;
    SoughtForce force_;
    TipAtHeight less_;
    TipAtHeight more_;
    double lessMiss_;
    double moreMiss_;
    int stayed_ = 0;  ///< > 0: `more_` stayed the last time, < 0: `less_`
};

/// The tip above all that could make it snap in.
std::optional<TipAtHeight> freeTip(VerticalPath& path) {
    constexpr double kMinShare = 0.05;  // of the tip's radius
    constexpr double kMargin = 1.5;
    constexpr int kMaxLifts = 40;
    const MapInstrument& instrument = path.instrument();
    const ProbeSystem& system = instrument.system();
    const double radius = system.tipRadius();
    const double touch = tipContactHeight(instrument.scene().surface, path.position().x(),
                                          path.position().y(), radius) -
                         radius;
    double clearance =
        kMargin * std::max(-system.contact.jumpInApproach(path.complianceZ()), kMinShare * radius);
    for (int i = 0; i < kMaxLifts; ++i) {
        TipAtHeight tip = path.at(touch + clearance, {});
        if (!tip.isBonded()) {
            return tip;
        }
        clearance *= 2.0;
    }
    return std::nullopt;
}

}  // namespace

bool TipAtHeight::isBonded() const noexcept {
    const auto end = memory.points.begin() + static_cast<std::ptrdiff_t>(memory.pointCount);
    return std::any_of(memory.points.begin(), end, [](const ClosestPointMemory& point) {
        return point.contact.branch == ContactBranch::Bonded;
    });
}

TipAtHeight VerticalPath::at(double base, const EquilibriumMemory& memory) {
    ++solved_;
    TipAtHeight tip{.base = base, .state = {}, .memory = memory};
    tip.state = tipEquilibrium(
        instrument_.surface(), instrument_.system(),
        {.position = Vector3(position_.x(), position_.y(), base), .velocity = velocity_},
        tip.memory, tracker_);
    return tip;
}

double VerticalPath::compliance(const TipState& state) const noexcept {
    const Vector3& normal = state.closest.normal;
    return normal.dot(instrument_.system().cantilever.compliance() * normal);
}

double VerticalPath::complianceZ() const noexcept {
    return instrument_.system().cantilever.compliance()(2, 2);
}

double FoundJump::energyLost() const noexcept {
    return exact ? exact->after.energyLost : after.state.contact.energyLost;
}

double FoundJump::forceBefore() const noexcept {
    return exact ? exact->before.force * before.state.closest.normal.z() : before.force();
}

double FoundJump::forceAfter() const noexcept {
    return exact ? exact->after.force * before.state.closest.normal.z() : after.force();
}

std::optional<FoundJump> findSnapIn(VerticalPath& path, TipAtHeight from) {
    path.goDown();
    return findJump(path, std::move(from), Way::Down, std::numeric_limits<double>::infinity(),
                    [](const TipAtHeight&) {});
}

std::optional<FoundJump> findPullOff(VerticalPath& path, TipAtHeight from, double maxStep,
                                     std::vector<TipAtHeight>& passed) {
    return findJump(path, std::move(from), Way::Up, maxStep,
                    [&](const TipAtHeight& tip) { passed.push_back(tip); });
}

double heightToPullOff(const VerticalPath& path, const TipAtHeight& from) {
    return wayToJump(path, from, Way::Up);
}

std::optional<TipAtHeight> findForce(VerticalPath& path, TipAtHeight from,
                                     const SoughtForce& force) {
    TipAtHeight now = std::move(from);
    const bool isBelow = force.of(now) < force.value;
    double longest = 0.1 * path.instrument().system().tipRadius();
    int away = 0;
    for (int i = 0; i < kMaxForceSteps; ++i) {
        const double missing = std::abs(force.value - force.of(now)) / slopeAt(path, now);
        const double step = std::clamp(missing, kSmallestStep, longest);
        TipAtHeight next = path.at(now.base + (isBelow ? -step : step), now.memory);
        if ((force.of(next) < force.value) != isBelow) {
            TipAtHeight& less = isBelow ? now : next;
            TipAtHeight& more = isBelow ? next : now;
            return Bracket(path, std::move(less), std::move(more), force).solve();
        }
        away = (force.of(next) < force.of(now)) == isBelow ? away + 1 : 0;
        if (away > kMaxAway) {
            return std::nullopt;
        }
        longest = kGrowth * std::max(step, longest);
        now = std::move(next);
    }
    return std::nullopt;
}

std::optional<Engagement> engage(VerticalPath& path, double setpoint) {
    path.goDown();
    std::optional<TipAtHeight> free = freeTip(path);
    std::optional<FoundJump> snapIn = free ? findSnapIn(path, std::move(*free)) : std::nullopt;
    if (!snapIn) {
        return std::nullopt;
    }
    std::optional<TipAtHeight> reached = snapIn->after;
    if (reached->force() < setpoint) {
        reached = findForce(path, std::move(*reached), {.value = setpoint});
    }
    return reached ? std::optional(Engagement{std::move(*snapIn), std::move(*reached)})
                   : std::nullopt;
}

}  // namespace asperity
