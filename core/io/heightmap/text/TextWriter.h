#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// The `write` of kTextFormat.
void writeText(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress);

}  // namespace asperity
