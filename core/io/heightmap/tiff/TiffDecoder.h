#pragma once

#include "core/io/heightmap/tiff/TiffImage.h"

#include <string>

namespace asperity {

/// Whether the samples of this compression come back as they were, and the TIFF library knows it.
[[nodiscard]] bool isTiffCompressionRead(std::int64_t compression);

/// All samples of an image, row after row from the first stored one, in the processor's byte order.
/// Any threads. @throw InputError when the TIFF library cannot decode it
[[nodiscard]] std::string decodeTiff(const TiffDirectory& directory, const TiffImage& image);

}  // namespace asperity
