#pragma once

#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/tiff/TiffDirectory.h"

#include <optional>
#include <string>

namespace asperity {

/// Conversion of the counts of a JPK channel to physical values.
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

/// Returns whether the content is an image of a JPK instrument: a file of its own, or a member of
/// the archive of a force map.
[[nodiscard]] bool isJpkImage(const ByteSource& bytes);

/// All channels of such an image, each in the unit of its default slot.
/// @param bytes must outlive the result
/// @throw InputError as HeightMapFormat::read
[[nodiscard]] StoredScan readJpkImage(const ByteSource& bytes);

}  // namespace asperity
