#pragma once

#include <bit>
#include <cstdint>

namespace asperity {

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
    /// Place of `value` in its cell, -1 .. 1.
    [[nodiscard]] double placeOf(double value) const noexcept {
        const std::uint64_t within = (std::bit_cast<std::uint64_t>(value) << bits_) & kMantissa;
        return (2.0 * std::bit_cast<double>(within | kOne)) - 3.0;
    }
    /// The value at a place in a cell.
    [[nodiscard]] double valueAt(std::int64_t cell, double place) const noexcept {
        const auto low = std::bit_cast<double>(cell << (kMantissaBits - bits_));
        const auto high = std::bit_cast<double>((cell + 1) << (kMantissaBits - bits_));
        return low + (0.5 * (1.0 + place) * (high - low));
    }

private:
    static constexpr int kMantissaBits = 52;
    static constexpr std::uint64_t kMantissa = (std::uint64_t{1} << kMantissaBits) - 1;
    static constexpr std::uint64_t kOne = std::bit_cast<std::uint64_t>(1.0);

    int bits_;
};

}  // namespace asperity
