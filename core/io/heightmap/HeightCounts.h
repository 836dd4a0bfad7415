#pragma once

#include "core/io/heightmap/HeightMapEncoders.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// Key of the count of pixels without data, beside Gwyddion's keys; Asperity's own.
inline constexpr std::string_view kNoDataKey = "Asperity::NoData";

/// Texts of an image by their keys, in order.
using ImageKeys = std::vector<std::pair<std::string, std::string>>;

/// How heights become counts of 16 bits: as evenly as the range allows. Where pixels hold no data,
/// the count 0 is theirs alone, one step below the lowest height.
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
