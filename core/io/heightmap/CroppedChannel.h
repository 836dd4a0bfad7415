#pragma once

#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/PixelRectangle.h"

#include <string>

namespace asperity {

/// Why a channel has no such part; empty: it has.
[[nodiscard]] std::string cropRefusal(const ScanChannel& channel, const PixelRectangle& part);

/// A part of an image that still lies in its source: as if the file held no more than that.
/// @param stored outlives the result
/// @param file   for messages
/// @throw InputError when the part is not wholly in the image
[[nodiscard]] StoredChannel croppedChannel(const StoredChannel& stored, const PixelRectangle& part,
                                           const std::string& file);

}  // namespace asperity
