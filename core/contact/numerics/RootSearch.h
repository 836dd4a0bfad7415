#pragma once

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

}  // namespace asperity
