#pragma once

#include "core/io/ByteReader.h"

#include <cstdint>
#include <string>

namespace asperity {

/// Returns whether a zlib stream of `packedBytes` can hold `bytes`: no stream packs better than
/// about 1032 times, and what promises more is damaged.
[[nodiscard]] bool mayUnpackTo(std::uint64_t packedBytes, std::uint64_t bytes);

/// Appends what a zlib stream holds to a text.
/// @param packed where the stream lies in the source
/// @param size   of what it holds [bytes]
/// @param owner for the message: what the stream belongs to
/// @throw InputError when it is damaged or holds more or less than that
void appendUnpacked(std::string& text, const ByteSource& source, const ByteSpan& packed,
                    std::uint64_t size, const std::string& owner);

}  // namespace asperity
