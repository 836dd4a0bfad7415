#pragma once

#include "core/io/heightmap/ImageScale.h"

namespace asperity {

/// What a PNG says about itself.
struct PngHeader {
    ImageSize size;
    int bits = 0;   ///< of a sample
    int color = 0;  ///< 0 gray, 2 color, 3 palette, 4 gray with transparency, 6 color with it
    std::uint64_t packedBytes = 0;     ///< of all pixels in the file
    BoundedTexts texts{kHeaderQuota};  ///< UTF-8
};

/// The signature of every PNG.
[[nodiscard]] bool isPng(const ByteSource& bytes);

/// Walks through all chunks up to the end mark, without a look at the pixels. Source: W3C,
/// Portable Network Graphics Specification, sections 5 and 11.
/// @throw InputError when one is not within the file, or the header is not valid
[[nodiscard]] PngHeader readPngChunks(const ByteSource& bytes);

}  // namespace asperity
