#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity {

/// Root of a continuous `function` between `low` and `high`, where its signs differ (otherwise the
/// end with the smaller value), to rounding; bounded. Inverse quadratic interpolation where that
/// is sure to help, bisection elsewhere. Source: Chandrupatla (1997), Adv. Eng. Software 28, 145.
template <typename Function>
double rootBetween(const Function& function, double low, double high) noexcept {
    constexpr int kMaxIterations = 100;
    double newest = high;
    double opposite = low;
    double fNewest = function(newest);
    double fOpposite = function(opposite);
    if ((fNewest > 0.0) == (fOpposite > 0.0)) {
        return std::abs(fNewest) < std::abs(fOpposite) ? newest : opposite;
    }
    double third = opposite;
    double fThird = fOpposite;
    double step = 0.5;
    for (int i = 0; i < kMaxIterations; ++i) {
        const double trial = newest + (step * (opposite - newest));
        const double fTrial = function(trial);
        if ((fTrial > 0.0) == (fNewest > 0.0)) {
            third = std::exchange(newest, trial);
            fThird = std::exchange(fNewest, fTrial);
        } else {
            third = std::exchange(opposite, newest);
            fThird = std::exchange(fOpposite, fNewest);
            newest = trial;
            fNewest = fTrial;
        }
        const double best = std::abs(fNewest) < std::abs(fOpposite) ? newest : opposite;
        const double width = std::abs(opposite - newest);
        const double tolerance = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(best);
        if (width <= tolerance || fNewest == 0.0) {
            return best;
        }
        const double xi = (newest - opposite) / (third - opposite);
        const double phi = (fNewest - fOpposite) / (fThird - fOpposite);
        step = 0.5;
        if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
            step = (fNewest / (fOpposite - fNewest) * fThird / (fOpposite - fThird)) +
                   ((third - newest) / (opposite - newest) * fNewest / (fThird - fNewest) *
                    fOpposite / (fThird - fOpposite));
        }
        const double smallest = tolerance / width / 2.0;
        step = std::fmin(std::fmax(step, smallest), 1.0 - smallest);
    }
    return newest;
}

/// A quantity that rises with a coordinate, and its derivative by it.
struct Rise {
    double value = 0.0;
    double rate = 0.0;
    double rounding = 0.0;  ///< what rounding may leave in the value
};

/// Search for the coordinate where a rising quantity takes the value `target`. It grows from
/// `origin` (coordinate and value) roughly as a power of the distance, so Newton's method runs on
/// the logarithms of both, and on themselves near the root or where that takes long, as for a
/// quantity that levels off; a bracket guards it. Real-time safe.
class RisingSearch {
public:
    RisingSearch(double origin, double originValue, double target,
                 double high = std::numeric_limits<double>::infinity()) noexcept
        : origin_(origin), originValue_(originValue), target_(target), low_(origin), high_(high) {}

    /// The root, from a first guess beyond the origin; `function(coordinate)` gives a Rise.
    template <typename Function>
    [[nodiscard]] double solve(const Function& function, double guess) noexcept {
        constexpr int kPowerSteps = 100;
        constexpr int kMaxIterations = 200;
        double here = guess;
        for (int i = 0; i < kMaxIterations; ++i) {
            const Rise rise = function(here);
            if (std::abs(rise.value - target_) <= rise.rounding) {
                break;
            }
            const double before = here;
            here = next(before, rise, i >= kPowerSteps);
            if (std::abs(here - before) <= 2.0 * std::numeric_limits<double>::epsilon() * here) {
                break;
            }
        }
        return here;
    }

private:
    [[nodiscard]] double next(double here, const Rise& rise, bool takesLong) noexcept {
        const double miss = rise.value - target_;
        (miss < 0.0 ? low_ : high_) = here;
        const bool near = takesLong || std::abs(miss) < 1e-3 * (target_ - originValue_);
        const double trial = near ? newtonStep(here, miss, rise.rate) : powerStep(here, rise);
        const bool shrinks = std::isinf(high_) || std::abs(trial - here) < 0.5 * steps_[0];
        const double there = trial > low_ && trial < high_ && shrinks ? trial : middle();
        steps_ = {steps_[1], std::abs(there - here)};
        return there;
    }

    [[nodiscard]] double newtonStep(double here, double miss, double rate) const noexcept {
        return rate > 0.0 ? here - (miss / rate) : low_;
    }

    [[nodiscard]] double powerStep(double here, const Rise& rise) const noexcept {
        const double climbed = rise.value - originValue_;
        if (!(climbed > 0.0)) {
            return low_;
        }
        constexpr double kMaxRatio = 1e12;
        const double offset = here - origin_;
        const double ratio = (target_ - originValue_) / climbed;
        const double exponent = std::clamp(offset * rise.rate / climbed, 0.5, 8.0);
        return origin_ + (offset * std::pow(std::min(ratio, kMaxRatio), 1.0 / exponent));
    }

    [[nodiscard]] double middle() const noexcept {
        return std::isinf(high_) ? origin_ + (2.0 * (low_ - origin_)) : 0.5 * (low_ + high_);
    }

    double origin_;
    double originValue_;
    double target_;
    double low_;
    double high_;
    /// Sizes of the last two steps: one that is not half the step before the last is not trusted.
    std::array<double, 2> steps_{std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity()};
};

}  // namespace asperity
