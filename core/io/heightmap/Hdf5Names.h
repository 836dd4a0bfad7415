#pragma once

#include "core/io/ByteSource.h"

#include <string_view>

namespace asperity {

/// Returns whether a file begins as HDF5 files do.
[[nodiscard]] bool isHdf5(const ByteSource& bytes);

/// Returns whether the bytes of a file contain the name of an attribute, group or dataset, of at
/// most 64 characters. It does not ask the HDF5 library, which damaged files can crash.
[[nodiscard]] bool holdsName(const ByteSource& bytes, std::string_view name);

}  // namespace asperity
