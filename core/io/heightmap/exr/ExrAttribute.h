#pragma once

#include "core/io/ByteReader.h"

#include <cstddef>
#include <string_view>

namespace asperity {

/// Whether the value of an attribute of a type that the OpenEXR library knows is as long as such
/// values are: the library reads that many bytes, and walks astray where the file lists others.
[[nodiscard]] bool fitsExrType(const ByteSource& bytes, std::string_view type,
                               const ByteSpan& value);

/// The number of channels that a list of them holds. @param value of an attribute that fits its
/// type, chlist
[[nodiscard]] std::size_t exrChannelCount(const ByteSource& bytes, const ByteSpan& value);

}  // namespace asperity
