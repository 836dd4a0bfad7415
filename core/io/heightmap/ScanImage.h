#pragma once

#include "core/io/heightmap/HeightMapFile.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Functions for every reader, applied to the numbers that it found.

/// Pixels of an image after the check that they are between 1 and 65536 a side.
struct ImageSize {
    int columns = 0;
    int rows = 0;

    [[nodiscard]] std::uint64_t pixels() const {
        return static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
    }
};

/// @param location of the numbers in the file, for the message
/// @throw InputError when a side is not between 1 and 65536 pixels
[[nodiscard]] ImageSize checkedImageSize(long long columns, long long rows, const std::string& file,
                                         const std::string& location);

/// Instruments write up to 8 images into a file, some twice as many.
inline constexpr std::size_t kMaxImages = 128;
/// @throw InputError when there are more images than that
void requireImages(std::size_t count, const std::string& file, const std::string& location);

/// Size of one pixel; 0 (unknown) unless the size is a positive finite number.
[[nodiscard]] double pixelPitch(double size, int pixels);

/// An origin that is no finite number is taken as 0.
[[nodiscard]] double finiteOrZero(double origin);

/// An image of this size and pitch whose values are still to come.
[[nodiscard]] HeightMap emptyMap(ImageSize size, double sizeX, double sizeY);

/// Marks a pixel as holding no data.
void invalidate(HeightMap& map, std::size_t pixel);

/// Marks what is NaN or infinite as holding no data.
void invalidateNonFinite(HeightMap& map);

[[nodiscard]] std::size_t countInvalid(const HeightMap& map);

/// Note on a channel without a lateral size.
inline constexpr std::string_view kNoSizeNote = "the file gives no lateral size";
/// Takes a height map that gives numbers for its size but no unit as one in meters, as Gwyddion's
/// own formats do.
void assumeMeters(ScanChannel& channel);

/// Notes the location of the size, or that the file gives none; heights without a unit have none.
/// @param source location of the size in the file
void settleSize(ScanChannel& channel, const std::string& source);

/// Returns the scale and its location in the file: "1.3e-10 m per stored number".
[[nodiscard]] Provenance scaleProvenance(double factor, const std::string& unit,
                                         std::string source);

/// "forward" or "backward" when the channel's name says so, else empty.
[[nodiscard]] std::string directionFromName(std::string_view name);

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
/// @param y the same [m]
void setOrigin(ScanChannel& channel, double x, double y, GivenPoint point);

/// Adds a note, once, where the instrument turned its scan: images are shown as they were scanned,
/// and an origin is that of the image before it was turned about its center.
/// @param notes   on the file
/// @param degrees what is not finite counts as 0
void noteRotation(std::vector<std::string>& notes, double degrees);

}  // namespace asperity
