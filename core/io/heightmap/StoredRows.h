#pragma once

#include "core/Progress.h"
#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// All rows of an image.
/// @param bytes where the image lies
/// @throw InputError as ChannelRows; Canceled
[[nodiscard]] HeightMap readHeightMap(const StoredChannel& stored, const ByteSource& bytes,
                                      Progress* progress = nullptr);

/// All rows of an image in single precision, about its first height.
/// @throw as readHeightMap()
[[nodiscard]] ScanMap readScanMap(const StoredChannel& stored, const ByteSource& bytes,
                                  Progress* progress = nullptr);

}  // namespace asperity
