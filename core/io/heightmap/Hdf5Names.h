#pragma once

#include "core/io/ByteSource.h"

#include <string_view>

namespace asperity {

/// Whether the file begins as HDF5 does.
[[nodiscard]] bool isHdf5(const ByteSource& bytes);

/// Whether a name, of at most 64 characters, of an attribute, group or dataset stands somewhere in
/// the file. A library that can be made to crash by the file is not asked.
[[nodiscard]] bool holdsName(const ByteSource& bytes, std::string_view name);

}  // namespace asperity
