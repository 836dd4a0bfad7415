#pragma once

#include "core/io/heightmap/png/PngChunks.h"

#include <string>

namespace asperity {

/// All samples of a gray image of 16 bits, row after row from the top, the highest byte first;
/// transparency is left out. Any threads.
/// @throw InputError when the PNG library cannot decode it, or a checksum is wrong
[[nodiscard]] std::string decodePng(const ByteSource& bytes, const PngHeader& header);

}  // namespace asperity
