#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace asperity {

/// Statistics of the pixels that hold data; NaN when none does. In the unit of the values.
struct HeightStatistics {
    double lowest = 0.0;   ///< [unit of the values]
    double highest = 0.0;  ///< [unit of the values]
    double mean = 0.0;     ///< [unit of the values]
    double rms = 0.0;      ///< root mean square about the mean (population) [unit of the values]
    std::size_t invalidPixels = 0;
};

/// Takes the values of one row after the other; what is not finite holds no data.
using TakeRow = std::function<void(std::span<const double>)>;

/// @param giveRows gives all rows; it is called once, because reading a row may mean decoding the
///        whole image
[[nodiscard]] HeightStatistics
heightStatistics(const std::function<void(const TakeRow&)>& giveRows);

}  // namespace asperity
