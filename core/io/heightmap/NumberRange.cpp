#include "core/io/heightmap/NumberRange.h"

#include <algorithm>
#include <vector>

namespace asperity {

NumberRange numberRangeOf(const ReadRow& rows, ImageSize size) {
    NumberRange range;
    RowRoom room;
    std::vector<double> numbers(static_cast<std::size_t>(size.columns));
    for (int row = 0; row < size.rows; ++row) {
        rows(row, room, numbers.data());
        for (const double number : numbers) {
            if (isFiniteHeight(number)) {
                range.lowest = std::min(range.lowest, number);
                range.highest = std::max(range.highest, number);
            }
        }
    }
    return range;
}

}  // namespace asperity
