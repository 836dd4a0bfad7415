#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// As HeightMapFormat::write.
void writeTiff(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress);

/// The `write` of kTiffCountsFormat.
void writeTiffCounts(const std::filesystem::path& target, const HeightRows& map,
                     const HeightMapMeta& meta, Progress* progress);

}  // namespace asperity
