#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// As HeightMapFormat::write.
void writePng(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

}  // namespace asperity
