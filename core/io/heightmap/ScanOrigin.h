#pragma once

#include "core/io/heightmap/HeightMapFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// The point of a scan that its file gives the position of; docs/formats.md 0 lists which file
/// gives which.
enum class GivenPoint : std::uint8_t {
    Corner,     ///< the lower left one of the image
    Center,     ///< of the image
    FirstPixel  ///< the center of the lower left pixel
};

/// Sets the origin of a channel, always the lower left corner of its image in the instrument's
/// frame. Needs the channel's size: without one the corner is not known, and the origin stays 0,
/// unless the file gives the corner.
/// @param x of the given point [m]; a number that is not finite counts as 0
/// @param y likewise [m]
void setOrigin(ScanChannel& channel, double x, double y, GivenPoint point);

/// Adds a note, once, where the instrument turned its scan: images are shown as they were scanned,
/// and an origin is that of the image before it was turned about its center.
/// @param notes   on the file
/// @param degrees what is not finite counts as 0
void noteRotation(std::vector<std::string>& notes, double degrees);

}  // namespace asperity
