#include "core/surface/closest/CellSweep.h"

#include <limits>

namespace asperity {

bool CellSweep::settle(const WindowBlocks& blocks) noexcept {
    int around = BoundsWindow::kMaxBlocks;
    for (int row = blocks.rows.first; row < blocks.rows.end(); ++row) {
        for (int column = blocks.columns.first; column < blocks.columns.end(); ++column) {
            around = std::min(around, window_.settledAround(row, column));
        }
    }
    settled_.push_back({blocks, around});
    return around == BoundsWindow::kMaxBlocks;
}

bool CellSweep::isSettled(int row, int column) const noexcept {
    const auto farthest = [](const BlockRun& run, int at) {
        return std::max(std::abs(at - run.first), std::abs(at - (run.end() - 1)));
    };
    return std::ranges::any_of(settled_, [&](const Settled& settled) {
        return std::max(farthest(settled.blocks.rows, row),
                        farthest(settled.blocks.columns, column)) <= settled.around;
    });
}

double CellSweep::squaredDistance(int level, const CellIndex& block) const noexcept {
    const BoxBounds bounds = surface_.bounds().at(level, block.row, block.column);
    const double away = std::max({query_.z() - bounds.highest, bounds.lowest - query_.z(), 0.0});
    return blocksAlongX(surface_, level).squaredDistance(query_.x(), block.column) +
           blocksAlongY(surface_, level).squaredDistance(query_.y(), block.row) + away * away;
}

Vector2 CellSweep::likeliestPlace() const noexcept {
    constexpr int kFactor = CellBounds::kFactor;
    CellIndex nearest;
    for (int level = surface_.bounds().levels() - 2; level >= 0; --level) {
        const CellBounds::Level& parts = surface_.bounds().level(level);
        const CellIndex first{.row = nearest.row * kFactor, .column = nearest.column * kFactor};
        const CellIndex end{.row = std::min(first.row + kFactor, parts.rows),
                            .column = std::min(first.column + kFactor, parts.columns)};
        double least = std::numeric_limits<double>::infinity();
        for (CellIndex part = first; part.row < end.row; ++part.row) {
            for (part.column = first.column; part.column < end.column; ++part.column) {
                const double squared = squaredDistance(level, part);
                if (squared < least) {
                    least = squared;
                    nearest = part;
                }
            }
        }
    }
    const BlockAxis x = blocksAlongX(surface_, 0);
    const BlockAxis y = blocksAlongY(surface_, 0);
    return {0.5 * (x.low(nearest.column) + x.high(nearest.column)),
            0.5 * (y.low(nearest.row) + y.high(nearest.row))};
}

}  // namespace asperity
