#pragma once

#include "core/io/heightmap/SampleRows.h"

#include <limits>

namespace asperity {

/// Lowest and highest number of an image; infinite, the lowest above the highest, when it has none.
struct NumberRange {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool isFlat() const { return !(highest > lowest); }
};

/// Of all numbers that are finite.
[[nodiscard]] NumberRange numberRangeOf(const ReadRow& rows, ImageSize size);

}  // namespace asperity
