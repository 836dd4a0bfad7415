#pragma once

#include "core/io/ByteSource.h"

#include <string_view>

namespace asperity {

/// The name, with its article, of a format that is known but not read here: "an HDF5 file (...)".
/// Empty: the content is none of these.
[[nodiscard]] std::string_view unreadFormat(const ByteSource& bytes);

}  // namespace asperity
