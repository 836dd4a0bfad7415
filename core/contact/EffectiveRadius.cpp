#include "core/contact/EffectiveRadius.h"

#include "core/contact/ContactStatus.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <cmath>

namespace asperity {

EffectiveRadius effectiveRadius(double tipRadius, double largest, double smallest) noexcept {
    constexpr double kMinFactor = 0.1;
    constexpr double kAnisotropicRatio = 2.0;
    if (!isWithin(tipRadius, kMinTipRadius, kMaxTipRadius) || !std::isfinite(largest) ||
        !std::isfinite(smallest)) {
        return {.radius = tipRadius, .tipFits = false};
    }
    const double sharper = 1.0 + (largest * tipRadius);
    const double blunter = 1.0 + (smallest * tipRadius);
    const double first = std::max(sharper, kMinFactor);
    const double second = std::max(blunter, kMinFactor);
    return {.radius = std::max(tipRadius / std::sqrt(first * second), kMinTipRadius),
            .tipFits = blunter >= kMinFactor,
            .anisotropic = first > kAnisotropicRatio * second};
}

}  // namespace asperity
