#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// See HeightMapFormat::writeAll.
void writeGwyImages(const std::filesystem::path& target, std::span<const WrittenImage> images,
                    Progress* progress);

/// See HeightMapFormat::write.
void writeGwy(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

}  // namespace asperity
