#include "core/contact/halfspace/CohesiveZone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asperity {

namespace {

/// Over so much of the range at least, and twice the range at most, the stress falls off: a sharper
/// law would make pixels flicker, a blunter one leave a contact without all of its cohesion.
constexpr double kMinZone = 0.02;
constexpr double kMaxZone = 2.0;

double difference(std::span<const double> gaps, std::size_t before, std::size_t after) noexcept {
    return 0.5 * (gaps[after] - gaps[before]);
}

}  // namespace

void cohesiveShares(std::span<const double> gaps, int size, double range,
                    std::span<double> shares) noexcept {
    const auto width = static_cast<std::size_t>(size);
    for (std::size_t row = 0; row < width; ++row) {
        const std::size_t below = row > 0 ? row - 1 : row;
        const std::size_t above = std::min(row + 1, width - 1);
        for (std::size_t column = 0; column < width; ++column) {
            const std::size_t left = column > 0 ? column - 1 : column;
            const std::size_t right = std::min(column + 1, width - 1);
            const double across = difference(gaps, row * width + left, row * width + right);
            const double up = difference(gaps, below * width + column, above * width + column);
            const double blur =
                std::clamp(std::abs(across) + std::abs(up), kMinZone * range, kMaxZone * range);
            const std::size_t pixel = row * width + column;
            shares[pixel] = std::clamp(0.5 + (range - gaps[pixel]) / blur, 0.0, 1.0);
        }
    }
}

}  // namespace asperity
