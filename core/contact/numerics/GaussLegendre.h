#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace asperity {

/// Integral of a smooth function from `low` to `high` by the 16-point rule of Gauss and Legendre,
/// exact for polynomials up to degree 31. Bounded, no allocation. A function may return several
/// numbers at once, of a type with +, += and a product with a number, whose default is zero.
template <typename Function>
auto gaussLegendre(const Function& function, double low, double high) noexcept {
    struct Node {
        double position;
        double weight;
    };
    constexpr std::array<Node, 8> kNodes{{{0.98940093499164993, 0.027152459411754095},
                                          {0.94457502307323258, 0.062253523938647893},
                                          {0.86563120238783174, 0.095158511682492785},
                                          {0.75540440835500303, 0.12462897125553387},
                                          {0.61787624440264375, 0.14959598881657673},
                                          {0.45801677765722739, 0.16915651939500254},
                                          {0.28160355077925891, 0.18260341504492359},
                                          {0.09501250983763744, 0.1894506104550685}}};
    const double center = 0.5 * (low + high);
    const double half = 0.5 * (high - low);
    decltype(function(low)) sum{};
    for (const Node& node : kNodes) {
        const double offset = half * node.position;
        sum += node.weight * (function(center - offset) + function(center + offset));
    }
    return half * sum;
}

/// Cells on the positive numbers, equally many and equally wide in each octave, so that their width
/// grows with the number; the cell is read off the bits of the number. Wait-free, no branch.
class GradedCells {
public:
    /// 2^`bits` cells an octave.
    constexpr explicit GradedCells(int bits) noexcept : bits_(bits) {}

    /// Number of the cell with `value` > 0; one more for each cell further up.
    [[nodiscard]] constexpr std::int64_t cellOf(double value) const noexcept {
        return std::bit_cast<std::int64_t>(value) >> (kMantissaBits - bits_);
    }
    /// Position of `value` in its cell, -1 .. 1.
    [[nodiscard]] double positionOf(double value) const noexcept {
        const std::uint64_t within = (std::bit_cast<std::uint64_t>(value) << bits_) & kMantissa;
        return (2.0 * std::bit_cast<double>(within | kOne)) - 3.0;
    }
    /// The value at a position in a cell.
    [[nodiscard]] double valueAt(std::int64_t cell, double position) const noexcept {
        const auto low = std::bit_cast<double>(cell << (kMantissaBits - bits_));
        const auto high = std::bit_cast<double>((cell + 1) << (kMantissaBits - bits_));
        return low + (0.5 * (1.0 + position) * (high - low));
    }

private:
    static constexpr int kMantissaBits = 52;
    static constexpr std::uint64_t kMantissa = (std::uint64_t{1} << kMantissaBits) - 1;
    static constexpr std::uint64_t kOne = std::bit_cast<std::uint64_t>(1.0);

    int bits_;
};

/// sqrt(large^2 - small^2) without cancellation; 0 where that is not real.
[[nodiscard]] inline double leg(double large, double small) noexcept {
    return std::sqrt(std::max(0.0, large - small) * (large + small));
}

}  // namespace asperity
