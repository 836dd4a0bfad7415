#include "core/surface/closest/BoundsWindow.h"

#include "core/Simd.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace asperity {

namespace {

/// Share by which single precision may miss a squared distance, with room to spare.
constexpr float kRelativeRounding = 1e-5F;
/// Single precision resolves a difference of heights to this share of the larger one.
constexpr double kHeightRounding = 4e-7;
/// Said of a block that is not known to bend up at all.
constexpr float kBendsDown = -1e6F;

using Word8 [[gnu::vector_size(32)]] = std::uint32_t;

ASPERITY_INLINE Float8 decodedShorts(Word8 codes) {
    const Word8 bits = (codes << kShortCodeShift) + kShortCodeBias;
    return loaded<Float8>(&bits);
}

/// Bit k: lane k is set.
ASPERITY_INLINE std::uint32_t bitsOfEight(Int8 lanes) {
    Int8 bits = lanes & Int8{1, 2, 4, 8, 16, 32, 64, 128};
    bits |= __builtin_shufflevector(bits, bits, 4, 5, 6, 7, 0, 1, 2, 3);
    bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1, 6, 7, 4, 5);
    bits |= __builtin_shufflevector(bits, bits, 1, 0, 3, 2, 5, 4, 7, 6);
    return static_cast<std::uint32_t>(bits[0]);
}

/// A row of blocks as the query meets it.
struct RowQuery {
    CellBounds::Units units;
    float height = 0.0F;  ///< of the query above the bounds' base [m]
    float limit = 0.0F;   ///< squared distance [m^2]
    float ball = 0.0F;    ///< by how much the query may move [m]
};

/// The encoded bounds of some rows of blocks.
struct CodedRows {
    const std::uint32_t* codes = nullptr;
    std::size_t stride = 0;
    int rows = 0;
    int columns = 0;
};

/// Squared distances of blocks from the query along the two axes [m^2].
struct AxisDistances {
    std::array<float, BoundsWindow::kMaxBlocks> x{};
    std::array<float, BoundsWindow::kMaxBlocks> y{};
};

/// Storage of the bounds of a window's blocks.
struct WindowRows {
    float* nearest = nullptr;
    float* bend = nullptr;
    BoundsWindow::Bits* reaching = nullptr;
};

ASPERITY_WITH_AVX2 void boundRows(const CodedRows& coded, const RowQuery& query,
                                  const AxisDistances& away, const WindowRows& window) {
    const Float8 zero{};
    for (int row = 0; row < coded.rows; ++row) {
        BoundsWindow::Bits reaching = 0;
        // Whole groups of lanes: what lies beyond the window is there to be read, and masked.
        for (int i = 0; i < coded.columns; i += kFloatLanes) {
            const std::size_t at =
                static_cast<std::size_t>(row) * coded.stride + static_cast<std::size_t>(i);
            const auto code = loaded<Word8>(coded.codes + at);
            const Word8 highest = code >> BoxCode::kMaxShift;
            const Float8 steps = __builtin_convertvector(loaded<Int8>(&highest), Float8);
            const Float8 below = query.height - query.units.step * steps;
            const Float8 depth =
                below +
                query.units.drop * decodedShorts((code >> BoxCode::kDropShift) & BoxCode::kByte);
            const Float8 outside = below > -depth ? below : -depth;
            const Float8 off = outside > zero ? outside : zero;
            const Float8 nearest = loaded<Float8>(away.x.data() + i) +
                                   away.y[static_cast<std::size_t>(row)] + off * off;
            const Float8 concavity = ((1.0F + kRelativeRounding) * query.units.concavity) *
                                     decodedShorts(code & BoxCode::kByte);
            const Float8 bend = (1.0F - kRelativeRounding) - concavity * (depth + query.ball);
            const Float8 known = below >= query.ball ? bend : Float8{} + kBendsDown;
            const int to = row * BoundsWindow::kMaxBlocks + i;
            std::memcpy(window.nearest + to, &nearest, sizeof nearest);
            std::memcpy(window.bend + to, &known, sizeof known);
            reaching |= BoundsWindow::Bits{bitsOfEight(nearest <= query.limit)}
                        << static_cast<unsigned>(i);
        }
        const auto beyond = static_cast<unsigned>(BoundsWindow::kMaxBlocks - coded.columns);
        window.reaching[row] = reaching & (~BoundsWindow::Bits{0} >> beyond);
    }
}

}  // namespace

BoundsWindow::BoundsWindow(const BSplineSurface& surface, const Vector3& query, double distance,
                           double ball) noexcept {
    const auto fits = [](const BlockRun& run) { return run.count <= kMaxBlocks; };
    for (;; ++level_) {
        x_ = blocksAlongX(surface, level_);
        y_ = blocksAlongY(surface, level_);
        rows_ = y_.within(query.y(), distance);
        columns_ = x_.within(query.x(), distance);
        if ((fits(rows_) && fits(columns_)) || level_ + 1 == surface.bounds().levels()) {
            break;
        }
    }
    const CellBounds& bounds = surface.bounds();
    const double height = query.z() - bounds.units().base;
    constexpr double kMaxCode = std::numeric_limits<std::uint16_t>::max();
    rounding_ =
        kHeightRounding * (std::abs(height) + kMaxCode * static_cast<double>(bounds.units().step));
    AxisDistances away;
    for (int column = 0; column < columns_.count; ++column) {
        away.x[static_cast<std::size_t>(column)] =
            static_cast<float>(x_.squaredDistance(query.x(), columns_.first + column));
    }
    for (int row = 0; row < rows_.count; ++row) {
        away.y[static_cast<std::size_t>(row)] =
            static_cast<float>(y_.squaredDistance(query.y(), rows_.first + row));
    }
    const CellBounds::Level& level = bounds.level(level_);
    const std::size_t first = level.index(rows_.first, columns_.first);
    boundRows({.codes = level.codes.data() + first,
               .stride = static_cast<std::size_t>(level.columns),
               .rows = rows_.count,
               .columns = columns_.count},
              {.units = bounds.units(),
               .height = static_cast<float>(height),
               .limit = squaredWithRounding(distance),
               // Depths are off by rounding, too.
               .ball = static_cast<float>(ball + rounding_)},
              away,
              {.nearest = nearest_.data(), .bend = bend_.data(), .reaching = reaching_.data()});
}

float BoundsWindow::squaredWithRounding(double distance) const noexcept {
    const double limit = distance + rounding_;
    return static_cast<float>(limit * limit) * (1.0F + kRelativeRounding);
}

int BoundsWindow::rowAt(double y) const noexcept { return y_.at(y) - rows_.first; }

int BoundsWindow::columnAt(double x) const noexcept { return x_.at(x) - columns_.first; }

WindowBlocks BoundsWindow::blocksAround(double x, double y, double reach) const noexcept {
    const int row = rowAt(y - reach);
    const int column = columnAt(x - reach);
    return {.rows = {.first = row, .count = rowAt(y + reach) - row + 1},
            .columns = {.first = column, .count = columnAt(x + reach) - column + 1}};
}

int BoundsWindow::widestOffset(int row, int column) const noexcept {
    int widest = 0;
    for (int i = 0; i < rows_.count; ++i) {
        if (const Bits blocks = reaching(i); blocks != 0) {
            const int first = std::countr_zero(blocks);
            const int last = kMaxBlocks - 1 - std::countl_zero(blocks);
            widest = std::max({widest, std::abs(i - row), column - first, last - column});
        }
    }
    return widest;
}

/// Least bend of the window's blocks at this offset from one of them, at most 1.
float BoundsWindow::leastBend(int row, int column, int offset) const noexcept {
    float least = 1.0F;
    const auto take = [&](int i, int j) {
        if (i >= 0 && i < rows_.count && j >= 0 && j < columns_.count) {
            least = std::min(least, bend_[index(i, j)]);
        }
    };
    for (int j = column - offset; j <= column + offset; ++j) {
        take(row - offset, j);
        take(row + offset, j);
    }
    for (int i = row - offset + 1; i < row + offset; ++i) {
        take(i, column - offset);
        take(i, column + offset);
    }
    return least;
}

int BoundsWindow::settledAround(int row, int column) const noexcept {
    // Nothing is known of the way from a minimum outside the window into it.
    if (row < 0 || row >= rows_.count || column < 0 || column >= columns_.count) {
        return -1;
    }
    const int widest = widestOffset(row, column);
    // On the way to a block at offset k the slope of the squared distance, zero at the closest
    // point, grows by the bends of the blocks that it passes.
    float slope = 0.0F;
    float here = leastBend(row, column, 0);
    for (int k = 0; k <= widest; ++k) {
        if ((k > 0 && slope <= 0.0F) || slope + here <= 0.0F) {
            return k - 1;
        }
        const float next = k < widest ? leastBend(row, column, k + 1) : 1.0F;
        slope += std::min(here, next);
        here = next;
    }
    return kMaxBlocks;
}

}  // namespace asperity
