#pragma once

#include "core/Progress.h"
#include "core/io/FileBytes.h"
#include "core/io/HeightMapFormat.h"

namespace asperity {

/// Reads all rows of an image into its map, whose size is set already; marks pixels without data.
void readHeights(const StoredChannel& stored, HeightMap& map);

/// All rows of an image.
/// @param file where the image lies; what was read of it is given back
/// @throw Cancelled
[[nodiscard]] HeightMap readHeightMap(const StoredChannel& stored, const MappedFile& file,
                                      Progress* progress);

/// All rows of an image in single precision, about its first height.
/// @param file as for readHeightMap()
/// @throw Cancelled
[[nodiscard]] ScanMap readScanMap(const StoredChannel& stored, const MappedFile& file,
                                  Progress* progress);

}  // namespace asperity
