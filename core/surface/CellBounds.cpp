#include "core/surface/CellBounds.h"

#include <utility>

namespace asperity {

CellBounds::CellBounds(std::vector<Level> levels, const Units& units)
    : levels_(std::move(levels)), units_(units) {}

BoxBounds CellBounds::at(int level, int row, int column) const noexcept {
    const Level& blocks = this->level(level);
    const BoxCode code = BoxCode::of(blocks.codes[blocks.index(row, column)]);
    const double highest = units_.base + static_cast<double>(units_.step) * code.highest;
    const double drop = static_cast<double>(units_.drop) * decodedShort(code.drop);
    return {.lowest = highest - drop,
            .highest = highest,
            .concavity = static_cast<double>(units_.concavity) * decodedShort(code.concavity)};
}

}  // namespace asperity
