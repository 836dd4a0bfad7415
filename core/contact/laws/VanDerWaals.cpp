#include "core/contact/laws/VanDerWaals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// sum over n >= 1 of 2n / (2n+1) y^(2n+1) = y / (1 - y^2) - atanh(y), which cancels for small y.
double energyShapeBySeries(double y) noexcept {
    constexpr int kTerms = 16;  // enough for y < 0.3
    const double square = y * y;
    double power = y * square;
    double sum = 0.0;
    for (int n = 1; n <= kTerms; ++n) {
        sum += 2.0 * n / (2.0 * n + 1.0) * power;
        power *= square;
    }
    return sum;
}

double energyShape(double separation, double radius) noexcept {
    const double y = radius / (separation + radius);
    if (y < 0.3) {
        return energyShapeBySeries(y);
    }
    const double toFarSide = separation + (2.0 * radius);
    return ((radius / separation) * ((separation + radius) / toFarSide)) -
           (0.5 * std::log(toFarSide / separation));
}

}  // namespace

double VanDerWaals::energy(double separation) const noexcept {
    const double d = std::max(separation, kContactSeparation);
    return -hamaker_ / 3.0 * energyShape(d, radius_);
}

/// D (D + 2R) = q is a quadratic in D.
double VanDerWaals::separationAt(double force) const noexcept {
    const double q = radius_ * std::sqrt(-2.0 / 3.0 * hamaker_ * radius_ / force);
    return q / (radius_ + std::sqrt((radius_ * radius_) + q));
}

double hamakerConstant(double workOfAdhesion) noexcept {
    return 12.0 * std::numbers::pi * workOfAdhesion * kContactSeparation * kContactSeparation;
}

}  // namespace asperity
