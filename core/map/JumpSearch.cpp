#include "core/map/JumpSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

constexpr double kResolution = 1e-13;  // of the base's height [m]
constexpr double kShort = 1e-3;     // of the way to the jump is left by a step, to stay before it
constexpr double kMinNormal = 0.1;  // z of a normal that says how far to go along z
constexpr int kMaxSteps = 400;
constexpr int kMaxHalvings = 60;

enum class Way : std::int8_t { Down = -1, Up = 1 };

/// Of the undeflected tip towards the surface, along the normal [m].
double approachOf(const VerticalPath& path, const TipAtHeight& tip) {
    const ContactState& contact = tip.state.contact;
    return contact.indentation + (path.compliance(tip.state) * contact.force);
}

/// How far the base has to go until the tip jumps, as the law has it here [m]; at or below 0: it
/// should have jumped.
double wayToJump(const VerticalPath& path, const TipAtHeight& tip, Way way) {
    const ContactModel law = contactModelAt(path.instrument().system(), tip.state);
    const double compliance = path.compliance(tip.state);
    const double approach = approachOf(path, tip);
    const double along = way == Way::Down ? law.jumpInApproach(compliance) - approach
                                          : approach - law.pullOffApproach(compliance);
    return along / std::max(tip.state.closest.normal.z(), kMinNormal);
}

/// The law's jump where one contact point bears the force on both sides.
std::optional<TipJump> exactJump(const VerticalPath& path, const FoundJump& found, Way way) {
    if (found.before.state.points > 1 || found.after.state.points > 1) {
        return std::nullopt;
    }
    const TipState& state = found.before.state;
    const ContactModel law = contactModelAt(path.instrument().system(), state);
    const double compliance = path.compliance(state);
    return way == Way::Down ? snapInOf(law, compliance) : pullOffOf(law, compliance);
}

/// Narrows the heights between which the tip changes.
FoundJump narrowed(VerticalPath& path, TipAtHeight before, TipAtHeight after, Way way) {
    const bool wasBonded = before.isBonded();
    for (int i = 0; i < kMaxHalvings && std::abs(after.base - before.base) > kResolution; ++i) {
        TipAtHeight middle = path.at(std::midpoint(before.base, after.base), before.memory);
        (middle.isBonded() == wasBonded ? before : after) = std::move(middle);
    }
    FoundJump found{std::move(before), std::move(after), std::nullopt};
    found.exact = exactJump(path, found, way);
    return found;
}

template <class Visit>
std::optional<FoundJump> findJump(VerticalPath& path, TipAtHeight now, Way way, double maxStep,
                                  const Visit& visit) {
    const bool wasBonded = now.isBonded();
    double push = kResolution;
    for (int i = 0; i < kMaxSteps; ++i) {
        visit(now);
        const double left = wayToJump(path, now, way);
        double step = std::min((1.0 - kShort) * left, maxStep);
        if (!(step > kResolution)) {
            step = push;
            push *= 2.0;
        }
        TipAtHeight next = path.at(now.base + (static_cast<double>(way) * step), now.memory);
        if (next.isBonded() != wasBonded) {
            return narrowed(path, std::move(now), std::move(next), way);
        }
        now = std::move(next);
    }
    return std::nullopt;
}

}  // namespace

bool FoundJump::jumps() const noexcept {
    return exact || before.state.points > 1 || after.state.points > 1;
}

double FoundJump::energyLost() const noexcept {
    return exact ? exact->after.energyLost : after.state.contact.energyLost;
}

std::optional<FoundJump> findSnapIn(VerticalPath& path, TipAtHeight from) {
    path.goDown();
    return findJump(path, std::move(from), Way::Down, std::numeric_limits<double>::infinity(),
                    [](const TipAtHeight&) {});
}

std::optional<FoundJump> findPullOff(VerticalPath& path, TipAtHeight from, double maxStep,
                                     std::vector<TipAtHeight>& passed) {
    path.goUp();
    return findJump(path, std::move(from), Way::Up, maxStep,
                    [&](const TipAtHeight& tip) { passed.push_back(tip); });
}

double heightToPullOff(const VerticalPath& path, const TipAtHeight& from) {
    return wayToJump(path, from, Way::Up);
}

}  // namespace asperity
