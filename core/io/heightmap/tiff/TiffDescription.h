#pragma once

#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/tiff/TiffDirectory.h"

namespace asperity {

/// What an image's description and its resolution say about its scale: Gwyddion's keys, a line
/// each, as our own files have them; ImageJ's, or those of tifffile in braces. The resolution
/// stands for the lateral size, but not that of a print. Source: docs/formats.md 9.
/// @param type of the samples
/// @throw InputError when a number of Gwyddion's keys is none
[[nodiscard]] ImageScale tiffScale(const TiffDirectory& directory, ImageSize size, SampleType type);

/// The metadata of our own files: the description's lines besides the scale.
[[nodiscard]] ImageTexts tiffMetadata(const TiffDirectory& directory);

}  // namespace asperity
