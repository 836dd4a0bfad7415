#include "core/contact/numerics/EllipticIntegrals.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kMaxDuplications = 600;  // each shrinks the spread by 4: more than doubles can hold
constexpr double kSpread = 2e-3;  // its sixth power, the error of the series below, is rounding

double duplicationShift(double x, double y, double z) noexcept {
    const double rx = std::sqrt(x);
    const double ry = std::sqrt(y);
    const double rz = std::sqrt(z);
    return (rx * ry) + (rx * rz) + (ry * rz);
}

double spread(double mean, double x, double y, double z) noexcept {
    return std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
}

}  // namespace

double carlsonRf(double x, double y, double z) noexcept {
    double mean = (x + y + z) / 3.0;
    for (int i = 0; i < kMaxDuplications && spread(mean, x, y, z) > kSpread * mean; ++i) {
        const double shift = duplicationShift(x, y, z);
        x = (x + shift) / 4.0;
        y = (y + shift) / 4.0;
        z = (z + shift) / 4.0;
        mean = (x + y + z) / 3.0;
    }
    const double dx = 1.0 - (x / mean);
    const double dy = 1.0 - (y / mean);
    const double dz = -(dx + dy);
    const double e2 = (dx * dy) - (dz * dz);
    const double e3 = dx * dy * dz;
    return (1.0 - (e2 / 10.0) + (e3 / 14.0) + (e2 * e2 / 24.0) - (3.0 / 44.0 * e2 * e3)) /
           std::sqrt(mean);
}

double carlsonRd(double x, double y, double z) noexcept {
    double mean = (x + y + (3.0 * z)) / 5.0;
    double sum = 0.0;
    double weight = 1.0;
    for (int i = 0; i < kMaxDuplications && spread(mean, x, y, z) > kSpread * mean; ++i) {
        const double shift = duplicationShift(x, y, z);
        sum += weight / (std::sqrt(z) * (z + shift));
        weight /= 4.0;
        x = (x + shift) / 4.0;
        y = (y + shift) / 4.0;
        z = (z + shift) / 4.0;
        mean = (x + y + (3.0 * z)) / 5.0;
    }
    const double dx = 1.0 - (x / mean);
    const double dy = 1.0 - (y / mean);
    const double dz = -(dx + dy) / 3.0;
    const double product = dx * dy;
    const double square = dz * dz;
    const double e2 = product - (6.0 * square);
    const double e3 = ((3.0 * product) - (8.0 * square)) * dz;
    const double e4 = 3.0 * (product - square) * square;
    const double e5 = product * square * dz;
    const double series = 1.0 - (3.0 / 14.0 * e2) + (e3 / 6.0) + (9.0 / 88.0 * e2 * e2) -
                          (3.0 / 22.0 * e4) - (9.0 / 52.0 * e2 * e3) + (3.0 / 26.0 * e5);
    return (3.0 * sum) + (weight * series / (mean * std::sqrt(mean)));
}

}  // namespace asperity
