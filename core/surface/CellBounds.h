#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// Bounds of a rectangle of spline cells, known without looking into it; true everywhere in it.
struct BoxBounds {
    double lowest = 0.0;     ///< height, world [m]
    double highest = 0.0;    ///< height, world [m]
    double concavity = 0.0;  ///< no second derivative of the height is larger; >= 0 [1/m]
};

/// Bounds of every cell of a spline height field and of blocks of 8 x 8, 64 x 64 ... cells, in 4
/// bytes a cell. Cell (row, column) lies between the centers of the pixels (row, column) and
/// (row + 1, column + 1), rows from the bottom; the outermost cells reach to the scan's edge.
/// Immutable.
class CellBounds {
public:
    static constexpr int kFactor = 8;  ///< from one size of block to the next

    /// Each row of bounds may be read this far beyond its end.
    static constexpr std::size_t kReadAhead = 32;

    /// Bounds of one size of block: row-major, bottom row first, kReadAhead more at the end.
    struct Level {
        int columns = 0;
        int rows = 0;
        std::vector<std::uint32_t> codes;  ///< see BoxCode

        [[nodiscard]] std::size_t index(int row, int column) const noexcept {
            return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column);
        }
    };

    /// Units of the encoded numbers.
    struct Units {
        double base = 0.0;       ///< world height of `highest` 0 [m]
        float step = 0.0F;       ///< of `highest` [m]
        float drop = 0.0F;       ///< [m]
        float concavity = 0.0F;  ///< [1/m]
    };

    CellBounds(std::vector<Level> levels, const Units& units);

    /// Blocks of 8^level cells a side.
    [[nodiscard]] const Level& level(int level) const noexcept {
        return levels_[static_cast<std::size_t>(level)];
    }
    [[nodiscard]] int levels() const noexcept { return static_cast<int>(levels_.size()); }
    [[nodiscard]] const Units& units() const noexcept { return units_; }
    [[nodiscard]] BoxBounds at(int level, int row, int column) const noexcept;
    /// Bounds of the whole surface.
    [[nodiscard]] BoxBounds all() const noexcept { return at(levels() - 1, 0, 0); }

private:
    std::vector<Level> levels_;  ///< the last one has a single block
    Units units_;
};

/// A positive number in a byte: a float cut down to 5 bits of exponent and 3 of mantissa, rounded
/// up, so that bounds stay bounds. Reaches from 2^-31 to kMaxShortCode.
inline constexpr float kMaxShortCode = 1.875F;
inline constexpr std::uint32_t kShortCodeShift = 20U;
inline constexpr std::uint32_t kShortCodeBias = 96U << 23U;

[[nodiscard]] inline float decodedShort(std::uint8_t code) noexcept {
    return std::bit_cast<float>((static_cast<std::uint32_t>(code) << kShortCodeShift) +
                                kShortCodeBias);
}

/// @param value in 0..kMaxShortCode
[[nodiscard]] inline std::uint8_t encodedShort(float value) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    constexpr std::uint32_t kRoundUp = (1U << kShortCodeShift) - 1U;
    return bits <= kShortCodeBias
               ? std::uint8_t{0}
               : static_cast<std::uint8_t>((bits - kShortCodeBias + kRoundUp) >> kShortCodeShift);
}

/// The bounds of a box in four bytes, as multiples of CellBounds::Units.
struct BoxCode {
    std::uint16_t highest = 0;   ///< above the base
    std::uint8_t drop = 0;       ///< highest - lowest, short code
    std::uint8_t concavity = 0;  ///< short code

    static constexpr unsigned kMaxShift = 16U;
    static constexpr unsigned kDropShift = 8U;
    static constexpr std::uint32_t kByte = 0xffU;

    [[nodiscard]] static BoxCode of(std::uint32_t bits) noexcept {
        return {.highest = static_cast<std::uint16_t>(bits >> kMaxShift),
                .drop = static_cast<std::uint8_t>((bits >> kDropShift) & kByte),
                .concavity = static_cast<std::uint8_t>(bits & kByte)};
    }
    [[nodiscard]] std::uint32_t bits() const noexcept {
        return (static_cast<std::uint32_t>(highest) << kMaxShift) |
               (static_cast<std::uint32_t>(drop) << kDropShift) | concavity;
    }
};

}  // namespace asperity
