#pragma once

#include "core/io/ByteSource.h"

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

/// Why a picture of this format is refused.
[[nodiscard]] std::string pictureRefusal(std::string_view name);

}  // namespace asperity
