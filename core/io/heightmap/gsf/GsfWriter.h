#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

#include <cstddef>

namespace asperity {

/// The heights begin at a multiple of it, behind a header that ends with at least one zero [byte].
inline constexpr std::size_t kGsfAlignment = 4;

/// As HeightMapFormat::write.
void writeGsf(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

}  // namespace asperity
