#include "core/contact/EffectiveRadius.h"

#include "core/contact/ContactStatus.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <cmath>

namespace asperity {

EffectiveRadius effectiveRadius(double tipRadius, double largest, double smallest) noexcept {
    constexpr double kLeast = 0.1;
    constexpr double kMost = 10.0;
    constexpr double kElongated = 2.0;
    if (!isWithin(tipRadius, kSmallestTipRadius, kLargestTipRadius) || !std::isfinite(largest) ||
        !std::isfinite(smallest)) {
        return {.radius = tipRadius, .fits = false};
    }
    const double sharper = 1.0 + (largest * tipRadius);
    const double blunter = 1.0 + (smallest * tipRadius);
    const double first = std::clamp(sharper, kLeast, kMost);
    const double second = std::clamp(blunter, kLeast, kMost);
    return {.radius = tipRadius / std::sqrt(first * second),
            .fits = blunter >= kLeast,
            .elongated = first > kElongated * second};
}

}  // namespace asperity
