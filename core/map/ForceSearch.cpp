#include "core/map/ForceSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kTolerance = 1e-12;     // of the force
constexpr double kSmallestStep = 1e-15;  // [m]
constexpr double kGrowth = 2.0;          // of a step over the one before
constexpr int kMaxForceSteps = 100;
constexpr int kMaxForceHalvings = 100;
constexpr int kMaxAway = 3;  // steps in turn that lead away from the force

/// Force along z per height of the base, by the main contact point [N/m]; never zero.
double slopeAt(const VerticalPath& path, const TipAtHeight& tip) {
    constexpr double kLeast = 1e-3;  // of the lever's stiffness
    const double stiffness = std::max(0.0, tip.state.contact.stiffness);
    const double normal = tip.state.closest.normal.z();
    const double along = stiffness / (1.0 + (path.compliance(tip.state) * stiffness));
    return std::max(along * normal * normal, kLeast / path.complianceZ());
}

/// The search between a height that pushes less than the force and one that pushes as hard.
class Bracket {
public:
    Bracket(VerticalPath& path, TipAtHeight less, TipAtHeight more, double force)
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
    [[nodiscard]] double miss(const TipAtHeight& tip) const { return tip.force() - force_; }
    [[nodiscard]] bool isDone() const {
        return std::min(std::abs(miss(less_)), std::abs(miss(more_))) <=
               kTolerance * std::abs(force_);
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
    double force_;
    TipAtHeight less_;
    TipAtHeight more_;
    double lessMiss_;
    double moreMiss_;
    int stayed_ = 0;  ///< > 0: `more_` stayed the last time, < 0: `less_`
};

}  // namespace

std::optional<TipAtHeight> findForce(VerticalPath& path, TipAtHeight from, double force) {
    TipAtHeight now = std::move(from);
    const bool isBelow = now.force() < force;
    double longest = 0.1 * path.instrument().system().tipRadius();
    int away = 0;
    for (int i = 0; i < kMaxForceSteps; ++i) {
        const double missing = std::abs(force - now.force()) / slopeAt(path, now);
        const double step = std::clamp(missing, kSmallestStep, longest);
        TipAtHeight next = path.at(now.base + (isBelow ? -step : step), now.memory);
        if ((next.force() < force) != isBelow) {
            TipAtHeight& less = isBelow ? now : next;
            TipAtHeight& more = isBelow ? next : now;
            return Bracket(path, std::move(less), std::move(more), force).solve();
        }
        away = (next.force() < now.force()) == isBelow ? away + 1 : 0;
        if (away > kMaxAway) {
            return std::nullopt;
        }
        longest = kGrowth * std::max(step, longest);
        now = std::move(next);
    }
    return std::nullopt;
}

}  // namespace asperity
