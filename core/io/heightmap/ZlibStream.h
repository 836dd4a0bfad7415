#pragma once

#include "core/io/ByteReader.h"
#include "core/io/ByteSource.h"

#include <cstdint>
#include <string>

namespace asperity {

/// Whether a zlib stream of so many bytes can hold that many: no stream packs better than about
/// 1032 times, and what promises more is damaged.
[[nodiscard]] bool mayUnpackTo(std::uint64_t packedBytes, std::uint64_t bytes);

/// Appends what a zlib stream holds to a text.
/// @param packed where the stream lies in the source
/// @param size   of what it holds [bytes]
/// @param place  for the message: what the stream belongs to
/// @throw InputError when it is damaged or holds more or less than that
void appendUnpacked(std::string& text, const ByteSource& source, const ByteSpan& packed,
                    std::uint64_t size, const std::string& place);

}  // namespace asperity
