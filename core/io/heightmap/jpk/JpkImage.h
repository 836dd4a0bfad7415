#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// Whether the content is an image of a JPK instrument: a file of its own, or a member of the
/// archive of a force map.
[[nodiscard]] bool isJpkImage(const ByteSource& bytes);

/// All channels of such an image, each in the unit of its default slot.
/// @param bytes must outlive the result
/// @throw InputError as HeightMapFormat::read
[[nodiscard]] StoredScan readJpkImage(const ByteSource& bytes);

}  // namespace asperity
