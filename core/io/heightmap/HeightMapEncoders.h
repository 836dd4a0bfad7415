#pragma once

#include "core/surface/HeightRows.h"

#include <cstddef>
#include <iosfwd>

// What the writers of single formats share.

namespace asperity {

/// Closes a stream. @throw Error when not all could be written
void finish(std::ofstream& stream);

/// What the pixels of a map hold.
struct HeightRange {
    double lowest = 0.0;      ///< of the pixels that hold data; 0 when none does [m]
    double highest = 0.0;     ///< as lowest [m]
    std::size_t missing = 0;  ///< pixels without data
};
/// @throw Canceled
[[nodiscard]] HeightRange heightRange(const HeightRows& map, Progress* progress);

}  // namespace asperity
