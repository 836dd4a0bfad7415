#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

// Names in the field data and the point data of our files.
inline constexpr const char* kVtiTitle = "title";
inline constexpr const char* kVtiUnit = "unit";
inline constexpr const char* kVtiOrigin = "scan_origin";
inline constexpr const char* kVtiValid = "valid";
/// Before the name of an array, in a file of several: its unit.
inline constexpr const char* kVtiUnitOf = "unit of ";

/// The `write` of kVtiFormat.
void writeVti(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

/// Several images with the pixels of the first as the arrays of one file, straight to `target`;
/// named by their titles, values without data NaN, each with its unit. Metadata and origin are
/// those of the first. @throw Error when not all could be written; Canceled
void writeVtiImages(const std::filesystem::path& target, std::span<const WrittenImage> images,
                    Progress* progress);

}  // namespace asperity
