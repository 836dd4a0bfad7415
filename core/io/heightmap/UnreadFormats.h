#pragma once

#include "core/io/ByteReader.h"

#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// A format that is known but not read here.
struct UnreadFormat {
    std::string_view mark;  ///< at the front; of an HDF5 file a name in it
    std::string_view name;  ///< with its article: "an HDF5 file (...)"; of a picture without it
    bool isPicture = false;
    bool byGwyddion = false;  ///< the Gwyddion program reads it
};

/// Empty: the content is of none of these.
[[nodiscard]] std::optional<UnreadFormat> unreadFormat(const ByteSource& bytes);

/// Returns why a picture of this format is refused.
[[nodiscard]] std::string pictureRefusal(std::string_view name);

/// Returns whether a file begins as HDF5 files do.
[[nodiscard]] bool isHdf5(const ByteSource& bytes);

/// Returns whether the bytes of a file contain the name of an attribute, group or dataset, of at
/// most 64 characters. It does not ask the HDF5 library, which damaged files can crash.
[[nodiscard]] bool holdsName(const ByteSource& bytes, std::string_view name);

}  // namespace asperity
