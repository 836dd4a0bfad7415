#pragma once

#include "core/io/heightmap/HeightMapFile.h"

#include <cstdint>
#include <string_view>

namespace asperity {

/// What every reader does with the numbers that it found.

/// Pixels of an image after the check that they are between 1 and 65536 a side.
struct ImageSize {
    int columns = 0;
    int rows = 0;

    [[nodiscard]] std::uint64_t pixels() const {
        return static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
    }
};

/// @param place of the numbers in the file, for the message
/// @throw InputError when a side is not between 1 and 65536 pixels
[[nodiscard]] ImageSize checkedImageSize(long long columns, long long rows, const std::string& file,
                                         const std::string& place);

/// Instruments write up to 8 images into a file, some twice as many.
inline constexpr std::size_t kMaxImages = 128;
/// @throw InputError when there are more images than that
void requireImages(std::size_t count, const std::string& file, const std::string& place);

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

/// Of a channel without a lateral size.
inline constexpr std::string_view kNoSizeNote = "the file gives no lateral size";
/// Takes a height map that gives numbers for its size but no unit as one in meters, as Gwyddion's
/// own formats do.
void assumeMeters(ScanChannel& channel);

/// Says where the size stands, or that the file gives none; that of heights is none without a unit.
/// @param source place of the size in the file
void settleSize(ScanChannel& channel, const std::string& source);

/// Where the scale stands: "1.3e-10 m per stored number", and its place in the file.
[[nodiscard]] Provenance scaleProvenance(double factor, const std::string& unit,
                                         std::string source);

/// "forward" or "backward" when the channel's name says so, else empty.
[[nodiscard]] std::string directionFromName(std::string_view name);

}  // namespace asperity
