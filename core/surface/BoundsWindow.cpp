#include "core/surface/BoundsWindow.h"

#include "core/surface/BlockAxis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Share by which single precision may miss a squared distance, with room to spare.
constexpr float kRelativeRounding = 1e-5F;
/// Single precision tells a difference of heights to this share of the larger one.
constexpr double kHeightRounding = 4e-7;
/// Said of a block that is not known to bend up at all.
constexpr float kBendsDown = -1e6F;

}  // namespace

BoundsWindow::BoundsWindow(const BSplineSurface& surface, const Vector3& query,
                           double reach) noexcept
    : surface_(surface) {
    const CellBounds& bounds = surface.bounds();
    const auto fits = [](const BlockRun& run) { return run.count <= kMostBlocks; };
    for (level_ = 0;; ++level_) {
        rows_ = blocksAlongY(surface, level_).within(query.y(), reach);
        columns_ = blocksAlongX(surface, level_).within(query.x(), reach);
        if ((fits(rows_) && fits(columns_)) || level_ + 1 == bounds.levels()) {
            break;
        }
    }
    const double height = query.z() - bounds.units().base;
    queryHeight_ = static_cast<float>(height);
    constexpr double kHighestCode = std::numeric_limits<std::uint16_t>::max();
    rounding_ = kHeightRounding * (std::abs(height) + kHighestCode * bounds.units().step);
    Lane across{};
    const BlockAxis x = blocksAlongX(surface, level_);
    for (int column = 0; column < columns_.count; ++column) {
        across[static_cast<std::size_t>(column)] =
            static_cast<float>(x.squaredDistance(query.x(), columns_.first + column));
    }
    const BlockAxis y = blocksAlongY(surface, level_);
    for (int row = 0; row < rows_.count; ++row) {
        boundRow(row, across, static_cast<float>(y.squaredDistance(query.y(), rows_.first + row)));
    }
}

void BoundsWindow::boundRow(int row, const Lane& across, float up) noexcept {
    const CellBounds::Units& units = surface_.bounds().units();
    const CellBounds::Level& level = surface_.bounds().level(level_);
    const std::size_t first = level.index(rows_.first + row, columns_.first);
    const std::uint16_t* highest = level.highest.data() + first;
    const std::uint8_t* drop = level.drop.data() + first;
    const std::uint8_t* concavity = level.concavity.data() + first;
    float* nearest = nearest_.data() + index(row, 0);
    float* bend = bend_.data() + index(row, 0);
    // Whole groups of lanes: what lies beyond the window is there to be read and never asked for.
    const int lanes = (columns_.count + 7) / 8 * 8;
    for (int i = 0; i < lanes; ++i) {
        const float below = queryHeight_ - units.step * static_cast<float>(highest[i]);
        const float depth = below + units.drop * decodedShort(drop[i]);
        const float away = std::max(std::max(below, -depth), 0.0F);
        nearest[i] = across[static_cast<std::size_t>(i)] + up + away * away;
        const float bendsUp = (1.0F - kRelativeRounding) - (1.0F + kRelativeRounding) *
                                                               units.concavity *
                                                               decodedShort(concavity[i]) * depth;
        bend[i] = below >= 0.0F ? bendsUp : kBendsDown;
    }
}

float BoundsWindow::squaredWithRounding(double distance) const noexcept {
    const double limit = distance + rounding_;
    return static_cast<float>(limit * limit) * (1.0F + kRelativeRounding);
}

int BoundsWindow::rowAt(double y) const noexcept {
    return blocksAlongY(surface_, level_).at(y) - rows_.first;
}

int BoundsWindow::columnAt(double x) const noexcept {
    return blocksAlongX(surface_, level_).at(x) - columns_.first;
}

int BoundsWindow::settledAround(double x, double y, double distance) const noexcept {
    const int row = std::clamp(rowAt(y), 0, rows_.count - 1);
    const int column = std::clamp(columnAt(x), 0, columns_.count - 1);
    const float limit = squaredWithRounding(distance);
    int widest = 0;
    for (int i = 0; i < rows_.count; ++i) {
        for (int j = 0; j < columns_.count; ++j) {
            if (nearest_[index(i, j)] <= limit) {
                widest = std::max({widest, std::abs(i - row), std::abs(j - column)});
            }
        }
    }
    // Least bend of all blocks at the same offset from the foot's block. On the way to a block at
    // offset k the slope of the squared distance, zero at the foot, grows by these.
    std::array<float, kMostBlocks + 1> least;
    least.fill(1.0F);
    for (int i = std::max(0, row - widest); i <= std::min(rows_.count - 1, row + widest); ++i) {
        const int offset = std::abs(i - row);
        for (int j = std::max(0, column - widest);
             j <= std::min(columns_.count - 1, column + widest); ++j) {
            float& bend = least[static_cast<std::size_t>(std::max(offset, std::abs(j - column)))];
            bend = std::min(bend, bend_[index(i, j)]);
        }
    }
    float slope = 0.0F;
    for (int k = 0; k <= widest; ++k) {
        const float here = least[static_cast<std::size_t>(k)];
        if ((k > 0 && slope <= 0.0F) || slope + here <= 0.0F) {
            return k - 1;
        }
        slope += std::min(here, least[static_cast<std::size_t>(k) + 1]);
    }
    return kMostBlocks;
}

}  // namespace asperity
