#include "core/contact/EffectiveRadius.h"

#include "core/contact/ContactStatus.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <cmath>

namespace asperity {

EffectiveRadius effectiveRadius(double tipRadius, double largest, double smallest) noexcept {
    constexpr double kMin = 0.1;
    constexpr double kMax = 10.0;
    constexpr double kElongated = 2.0;
    if (!isWithin(tipRadius, kMinTipRadius, kMaxTipRadius) || !std::isfinite(largest) ||
        !std::isfinite(smallest)) {
        return {.radius = tipRadius, .fits = false};
    }
    const double sharper = 1.0 + (largest * tipRadius);
    const double blunter = 1.0 + (smallest * tipRadius);
    const double first = std::clamp(sharper, kMin, kMax);
    const double second = std::clamp(blunter, kMin, kMax);
    return {.radius = tipRadius / std::sqrt(first * second),
            .fits = blunter >= kMin,
            .elongated = first > kElongated * second};
}

}  // namespace asperity
