#include "core/surface/CellBoundsBuilder.h"

#include "core/Simd.h"
#include "core/surface/BezierCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <thread>
#include <utility>

namespace asperity {

namespace {

/// Bounds of one cell relative to the grid's datum, before they are encoded.
struct RawBounds {
    float lowest = 0.0F;     ///< [m]
    float highest = 0.0F;    ///< [m]
    float concavity = 0.0F;  ///< [1/m]
};

/// Single precision resolves a Bezier point to this share of the largest height that it is made of.
constexpr float kBoundRounding = 0x1p-20F;
/// Below this no scan's heights differ; keeps the scales away from zero [m].
constexpr float kMinReach = 1e-30F;

int cellsAlong(int pixels) { return std::max(pixels - 1, 1); }

/// Cells of one row, side by side in memory so that the compiler takes several at a time.
class CellRow {
public:
    static constexpr std::size_t kLanes = 64;
    using Lane = std::array<float, kLanes>;

    /// @param corner of the first cell's 4 x 4 control heights
    ASPERITY_INLINE void load(const float* corner, std::size_t stride, std::size_t cells) {
        std::array<std::array<Lane, 4>, 4> across;
        for (std::size_t r = 0; r < 4; ++r) {
            const float* c = corner + r * stride;
            for (std::size_t j = 0; j < cells; ++j) {
                toBezier({c[j], c[j + 1], c[j + 2], c[j + 3]}, j, across[r]);
            }
        }
        for (std::size_t k = 0; k < 4; ++k) {
            std::array<Lane, 4> up;
            for (std::size_t j = 0; j < cells; ++j) {
                toBezier({across[0][k][j], across[1][k][j], across[2][k][j], across[3][k][j]}, j,
                         up);
            }
            for (std::size_t s = 0; s < 4; ++s) {
                std::copy_n(up[s].begin(), cells, net_[s][k].begin());
            }
        }
    }

    ASPERITY_INLINE void heightRange(std::size_t cells, Lane& lowest, Lane& highest) const {
        lowest = net_[0][0];
        highest = net_[0][0];
        for (const auto& row : net_) {
            for (const Lane& point : row) {
                for (std::size_t j = 0; j < cells; ++j) {
                    lowest[j] = std::min(lowest[j], point[j]);
                    highest[j] = std::max(highest[j], point[j]);
                }
            }
        }
    }

    /// Largest second differences along x, along y, and the largest mixed one by magnitude.
    struct Bends {
        Lane xx;
        Lane yy;
        Lane xy;
    };
    ASPERITY_INLINE void bends(std::size_t cells, Bends& most) const {
        constexpr float kNone = std::numeric_limits<float>::lowest();
        most.xx.fill(kNone);
        most.yy.fill(kNone);
        most.xy.fill(0.0F);
        for (std::size_t s = 0; s < 4; ++s) {
            for (std::size_t k = 0; k < 2; ++k) {
                raise(net_[s][k], net_[s][k + 1], net_[s][k + 2], cells, most.xx);
                raise(net_[k][s], net_[k + 1][s], net_[k + 2][s], cells, most.yy);
            }
        }
        for (std::size_t s = 0; s < 3; ++s) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Lane& a = net_[s][k];
                const Lane& b = net_[s][k + 1];
                const Lane& c = net_[s + 1][k];
                const Lane& d = net_[s + 1][k + 1];
                for (std::size_t j = 0; j < cells; ++j) {
                    most.xy[j] = std::max(most.xy[j], std::abs((d[j] - c[j]) - (b[j] - a[j])));
                }
            }
        }
    }

private:
    ASPERITY_INLINE static void toBezier(const std::array<float, 4>& c, std::size_t j,
                                         std::array<Lane, 4>& points) {
        constexpr float kSixth = 1.0F / 6.0F;
        constexpr float kThird = 1.0F / 3.0F;
        points[0][j] = kSixth * (c[0] + 4.0F * c[1] + c[2]);
        points[1][j] = kThird * (2.0F * c[1] + c[2]);
        points[2][j] = kThird * (c[1] + 2.0F * c[2]);
        points[3][j] = kSixth * (c[1] + 4.0F * c[2] + c[3]);
    }

    ASPERITY_INLINE static void raise(const Lane& a, const Lane& b, const Lane& c,
                                      std::size_t cells, Lane& most) {
        for (std::size_t j = 0; j < cells; ++j) {
            most[j] = std::max(most[j], (a[j] - b[j]) + (c[j] - b[j]));
        }
    }

    std::array<std::array<Lane, 4>, 4> net_;  ///< Bezier points, [along y][along x][cell]
};

/// Factors that turn differences of Bezier points into second derivatives [1/m^2].
struct BendScale {
    float xx = 0.0F;
    float yy = 0.0F;
    float xy = 0.0F;
};

/// Bounds of cells side by side, none of which reaches to the scan's edge.
/// @param corner of the first one's 4 x 4 control heights
ASPERITY_WITH_AVX2 void innerBounds(const float* corner, std::size_t stride, const BendScale& scale,
                                    std::span<RawBounds> bounds) {
    CellRow cells;
    cells.load(corner, stride, bounds.size());
    CellRow::Lane lowest;
    CellRow::Lane highest;
    CellRow::Bends bends;
    cells.heightRange(bounds.size(), lowest, highest);
    cells.bends(bounds.size(), bends);
    const float noiseScale = scale.xx + scale.yy + scale.xy;
    for (std::size_t j = 0; j < bounds.size(); ++j) {
        const float noise = kBoundRounding * std::max(std::abs(lowest[j]), std::abs(highest[j]));
        const float xx = scale.xx * bends.xx[j];
        const float yy = scale.yy * bends.yy[j];
        const float xy = scale.xy * bends.xy[j];
        const float spread = std::sqrt(0.25F * (xx - yy) * (xx - yy) + xy * xy);
        const float most = 0.5F * (xx + yy) + spread;
        bounds[j] = {.lowest = lowest[j] - noise,
                     .highest = highest[j] + noise,
                     .concavity =
                         std::max(0.0F, most + spread * kBoundRounding) + noise * noiseScale};
    }
}

class Builder {
public:
    explicit Builder(const BSplineSurface::Grid& grid)
        : grid_(grid)
        , columns_(cellsAlong(grid.columns))
        , rows_(cellsAlong(grid.rows))
        , scale_{.xx = static_cast<float>(6.0 / (grid.pitchX * grid.pitchX)),
                 .yy = static_cast<float>(6.0 / (grid.pitchY * grid.pitchY)),
                 .xy = static_cast<float>(9.0 / (grid.pitchX * grid.pitchY))} {}

    CellBounds build(Progress* progress) {
        findUnits();
        std::vector<CellBounds::Level> levels;
        levels.push_back(emptyLevel(rows_, columns_));
        const auto fill = [&](int first, int last, const auto& beforeRow) {
            std::vector<RawBounds> row(static_cast<std::size_t>(columns_));
            for (int i = first; i < last && beforeRow(i - first, last - first); ++i) {
                rowBounds(i, row);
                encode(row, i, levels.front());
            }
        };
        fillByHalves(fill, progress);
        while (levels.back().rows > 1 || levels.back().columns > 1) {
            levels.push_back(blocksOf(levels.back()));
        }
        return {std::move(levels), units_};
    }

private:
    /// @param fill calls, before each row of a range, a function of the rows done and of all rows
    /// that says whether to go on
    template <class Fill>
    void fillByHalves(const Fill& fill, Progress* progress) const {
        const auto report = [progress](int done, int all) {
            if (done % (all / 32 + 1) == 0) {
                reportTo(progress, static_cast<double>(done) / all);
            }
            return true;
        };
        constexpr int kWorthAThread = 1 << 18;
        const bool alone = static_cast<long>(rows_) * columns_ < kWorthAThread;
        const int middle = alone ? rows_ : rows_ / 2;
        // Asked to stop and waited for at the end, when Canceled flies by, too.
        std::jthread other;
        if (!alone) {
            other = std::jthread([&](const std::stop_token& stop) {
                fill(middle, rows_, [&stop](int, int) { return !stop.stop_requested(); });
            });
        }
        fill(0, middle, report);
        if (!alone) {
            other.join();
        }
        reportTo(progress, 1.0);
    }

    static CellBounds::Level emptyLevel(int rows, int columns) {
        CellBounds::Level level{.columns = columns, .rows = rows, .codes = {}};
        level.codes.resize(level.index(rows, 0) + CellBounds::kReadAhead);
        return level;
    }

    /// Bounds of all cells of row `row`.
    void rowBounds(int row, std::vector<RawBounds>& bounds) const {
        const bool isBorder = row == 0 || row == rows_ - 1;
        if (isBorder || columns_ < 3) {
            for (int column = 0; column < columns_; ++column) {
                bounds[static_cast<std::size_t>(column)] = borderBounds(row, column);
            }
            return;
        }
        bounds.front() = borderBounds(row, 0);
        bounds.back() = borderBounds(row, columns_ - 1);
        for (int first = 1; first < columns_ - 1; first += static_cast<int>(CellRow::kLanes)) {
            const int cells = std::min(static_cast<int>(CellRow::kLanes), columns_ - 1 - first);
            innerBounds(corner(row, first), static_cast<std::size_t>(grid_.columns) + 2, scale_,
                        {bounds.data() + first, static_cast<std::size_t>(cells)});
        }
    }

    [[nodiscard]] const float* corner(int row, int column) const {
        return grid_.controlHeights.data() +
               static_cast<std::size_t>(row) * (static_cast<std::size_t>(grid_.columns) + 2) +
               static_cast<std::size_t>(column);
    }

    /// Bounds of a cell that reaches to the scan's edge.
    [[nodiscard]] RawBounds borderBounds(int row, int column) const {
        const SpanPart across = cellExtent(column, grid_.columns);
        const SpanPart up = cellExtent(row, grid_.rows);
        const Eigen::Matrix4d net =
            bezierOfSpan(up) * cellControls(grid_, row, column) * bezierOfSpan(across).transpose();
        const BendRange bends =
            bendsOf(net, {across.length() * grid_.pitchX, up.length() * grid_.pitchY});
        const auto lowest = static_cast<float>(net.minCoeff());
        const auto highest = static_cast<float>(net.maxCoeff());
        const float noise = kBoundRounding * std::max(std::abs(lowest), std::abs(highest));
        const auto concavity = static_cast<float>(std::max(0.0, largestBend(bends)));
        return {.lowest = lowest - noise,
                .highest = highest + noise,
                .concavity = concavity * (1.0F + kBoundRounding) + noise * scale_.xx};
    }

    /// Scales in which every bound has a code: from the control heights, which bound them all.
    void findUnits() {
        const auto [low, high] = std::ranges::minmax(grid_.controlHeights);
        // At the scan's edge the outer span is continued by half a pixel: by less than the range.
        // Where heights hardly differ, their rounding is what there is to tell.
        const float least = std::max(std::abs(low), std::abs(high)) * 0x1p-12F;
        const float reach = std::max({high - low, least, kMinReach});
        const float base = low - 2.0F * reach;
        constexpr float kSteps = 65000.0F;
        units_.base = grid_.datum + static_cast<double>(base);
        units_.step = 5.0F * reach / kSteps;
        units_.drop = 5.0F * reach;
        // A second difference of Bezier points is at most four times their range.
        units_.concavity = 8.0F * reach * (scale_.xx + scale_.yy + scale_.xy);
        base_ = base;
    }

    void encode(const std::vector<RawBounds>& bounds, int row, CellBounds::Level& level) const {
        const float perStep = 1.0F / units_.step;
        const float perDrop = 1.0F / units_.drop;
        const float perConcavity = 1.0F / units_.concavity;
        const std::size_t first = level.index(row, 0);
        for (std::size_t j = 0; j < bounds.size(); ++j) {
            // One step more covers the rounding of the division.
            const float steps = (bounds[j].highest - base_) * perStep + 2.0F;
            const auto highest = static_cast<std::uint16_t>(steps);
            const float top = static_cast<float>(highest) * units_.step;
            const float drop = (top - (bounds[j].lowest - base_) + units_.step) * perDrop;
            const BoxCode code{.highest = highest,
                               .drop = encodedShort(drop),
                               .concavity = encodedShort(bounds[j].concavity * perConcavity)};
            level.codes[first + j] = code.bits();
        }
    }

    /// Bounds of the blocks of kFactor x kFactor boxes of a level.
    [[nodiscard]] CellBounds::Level blocksOf(const CellBounds::Level& parts) const {
        constexpr int kFactor = CellBounds::kFactor;
        CellBounds::Level blocks = emptyLevel((parts.rows + kFactor - 1) / kFactor,
                                              (parts.columns + kFactor - 1) / kFactor);
        for (int row = 0; row < blocks.rows; ++row) {
            for (int column = 0; column < blocks.columns; ++column) {
                joinParts(parts, row, column, blocks);
            }
        }
        return blocks;
    }

    void joinParts(const CellBounds::Level& parts, int row, int column,
                   CellBounds::Level& blocks) const {
        constexpr int kFactor = CellBounds::kFactor;
        BoxCode joined;
        float lowest = std::numeric_limits<float>::max();
        for (int i = row * kFactor; i < std::min((row + 1) * kFactor, parts.rows); ++i) {
            for (int j = column * kFactor; j < std::min((column + 1) * kFactor, parts.columns);
                 ++j) {
                const BoxCode part = BoxCode::of(parts.codes[parts.index(i, j)]);
                lowest = std::min(lowest, top(part) - decodedShort(part.drop) * units_.drop);
                joined.highest = std::max(joined.highest, part.highest);
                joined.concavity = std::max(joined.concavity, part.concavity);
            }
        }
        joined.drop = encodedShort((top(joined) - lowest + units_.step) / units_.drop);
        blocks.codes[blocks.index(row, column)] = joined.bits();
    }

    /// Upper height bound above that of code 0 [m].
    [[nodiscard]] float top(const BoxCode& code) const {
        return static_cast<float>(code.highest) * units_.step;
    }

    const BSplineSurface::Grid& grid_;
    int columns_;  ///< cells
    int rows_;     ///< cells
    BendScale scale_;
    CellBounds::Units units_;
    float base_ = 0.0F;  ///< height of code 0 above the datum [m]
};

}  // namespace

CellBounds cellBoundsOf(const BSplineSurface::Grid& grid, Progress* progress) {
    return Builder(grid).build(progress);
}

}  // namespace asperity
