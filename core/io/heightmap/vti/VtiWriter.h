#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

// Names in the field data and the point data of our files.
inline constexpr const char* kVtiTitle = "title";
inline constexpr const char* kVtiUnit = "unit";
inline constexpr const char* kVtiOrigin = "scan_origin";
inline constexpr const char* kVtiValid = "valid";

/// The `write` of kVtiFormat.
void writeVti(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

}  // namespace asperity
