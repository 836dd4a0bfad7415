#include "core/surface/foot/CellSweep.h"

namespace asperity {

bool CellSweep::settle(const WindowBlocks& blocks) noexcept {
    int around = BoundsWindow::kMostBlocks;
    for (int row = blocks.rows.first; row < blocks.rows.end(); ++row) {
        for (int column = blocks.columns.first; column < blocks.columns.end(); ++column) {
            around = std::min(around, window_.settledAround(row, column));
        }
    }
    settled_.push_back({blocks, around});
    return around == BoundsWindow::kMostBlocks;
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

bool CellSweep::reaches(int level, int row, int column, double distance) const noexcept {
    const BoxBounds bounds = surface_.bounds().at(level, row, column);
    const double away = std::max({query_.z() - bounds.highest, bounds.lowest - query_.z(), 0.0});
    return blocksAlongX(surface_, level).squaredDistance(query_.x(), column) +
               blocksAlongY(surface_, level).squaredDistance(query_.y(), row) + away * away <=
           distance * distance;
}

}  // namespace asperity
