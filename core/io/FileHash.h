#pragma once

#include "core/Progress.h"
#include "core/io/ByteSource.h"

#include <string>

namespace asperity {

/// SHA-256 of a content, 64 lower-case hexadecimal digits.
/// @throw InputError when it cannot be read or changes meanwhile; Canceled
[[nodiscard]] std::string sha256Of(const ByteSource& source, Progress* progress = nullptr);

}  // namespace asperity
