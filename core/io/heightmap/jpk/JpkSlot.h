#pragma once

#include "core/io/heightmap/tiff/TiffDirectory.h"

#include <optional>
#include <string>

namespace asperity {

/// How the counts of a JPK channel become physical values.
struct JpkSlot {
    std::string name;  ///< "nominal", "calibrated", "force"; empty: there is none
    std::string unit;  ///< as written
    double multiplier = 1.0;
    double offset = 0.0;
    std::optional<double> noData;  ///< count of a pixel without data
};

/// The slot that a channel shows unless its user takes another one. Its factors turn counts into
/// values, and not those of the slot that it was calibrated from. Source: docs/formats.md 5.
/// @throw InputError when a value of it is missing, or of an unknown kind
[[nodiscard]] JpkSlot defaultJpkSlot(const TiffDirectory& channel);

}  // namespace asperity
