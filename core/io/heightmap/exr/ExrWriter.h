#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// Attribute: before the name of a channel, in a file of several: its unit.
inline constexpr const char* kExrUnitOf = "unit of ";

/// See HeightMapFormat::write.
void writeExr(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

/// Several images with the pixels of the first as the channels of one file, straight to `target`;
/// named by their titles, values without data NaN, each with its unit. Metadata, size and origin
/// are those of the first. @throw Canceled
void writeExrImages(const std::filesystem::path& target, std::span<const WrittenImage> images,
                    Progress* progress);

}  // namespace asperity
