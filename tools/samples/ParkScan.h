#pragma once

#include "core/surface/HeightMap.h"

#include <filesystem>

namespace asperity {

/// The heights of a Park Systems TIFF. @throw InputError
[[nodiscard]] HeightMap readParkScan(const std::filesystem::path& path);

/// A square part of a map. @param row, column of its upper left pixel
[[nodiscard]] HeightMap cropped(const HeightMap& map, int row, int column, int pixels);

/// The sample of the default scene: of a measured granular film, the 256 x 256 pixels with one of
/// its highest grains in the middle.
/// @param film the whole film, 512 x 512 pixels
[[nodiscard]] HeightMap granularFilm(const HeightMap& film);
inline constexpr const char* kGranularFilmTitle = "Granular film, measured";

}  // namespace asperity
