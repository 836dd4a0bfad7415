#pragma once

#include "core/io/heightmap/HeightMapWriter.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

/// Key of the count of pixels without data, beside Gwyddion's keys; Asperity's own.
inline constexpr std::string_view kNoDataKey = "Asperity::NoData";

/// Texts of an image by their keys, in order.
using ImageKeys = std::vector<std::pair<std::string, std::string>>;

/// Conversion of heights to counts of 16 bits, as even as the range allows. Where pixels hold no
/// data, they alone have the count 0, one step below the lowest height.
class HeightCounts {
public:
    explicit HeightCounts(const HeightRange& range);

    [[nodiscard]] std::uint16_t countOf(double height) const;
    /// The scale as Gwyddion's keys give it, and our own for pixels without data.
    /// @param unit of the heights
    [[nodiscard]] ImageKeys keys(const std::string& unit) const;

private:
    double zero_ = 0.0;  ///< height of the count 0 [m]
    double full_ = 0.0;  ///< height of the largest count [m]
    bool marksMissing_ = false;
};

}  // namespace asperity
