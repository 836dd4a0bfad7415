#pragma once

#include "core/Progress.h"
#include "core/io/ByteSource.h"

#include <string>

namespace asperity {

/// SHA-256 of a content, 64 lower-case hexadecimal digits.
/// @throw InputError when it cannot be read or changes meanwhile; Canceled
[[nodiscard]] std::string sha256Of(const ByteSource& source, Progress* progress = nullptr);

/// MD5 of a content, 32 such digits: file formats carry it against damage, it proves no origin.
/// Empty where the OpenSSL library is set up to refuse it. @throw InputError as sha256Of()
[[nodiscard]] std::string md5Of(const ByteSource& source);

}  // namespace asperity
