#include "core/contact/laws/ContactOptions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

double Meniscus::pull(double tipRadius) const noexcept {
    return 4.0 * std::numbers::pi * tipRadius * surfaceTension *
           std::max(0.0, std::cos(contactAngle));
}

double Meniscus::force(double tipRadius, double indentation) const noexcept {
    return -pull(tipRadius) * std::clamp(1.0 + (indentation / range), 0.0, 1.0);
}

double Meniscus::energy(double tipRadius, double indentation, bool bonded) const noexcept {
    if (bonded) {
        return -pull(tipRadius) * ((0.5 * range) + indentation);
    }
    const double within = std::clamp(range + indentation, 0.0, range);
    return -pull(tipRadius) * within * within / (2.0 * range);
}

}  // namespace asperity
