#pragma once

#include "core/io/HeightMapFile.h"

#include <string>
#include <string_view>

namespace asperity {

/// A file type that can be read. A further format is one source file that defines such a constant,
/// its declaration below, and its line in the table of HeightMapFile.cpp.
struct HeightMapFormat {
    std::string_view name;  ///< for people
    /// Whether the content starts like this type, damaged or not.
    bool (*recognises)(std::string_view bytes);
    /// Reads the whole content; `file` is for messages. Sets all but the format's name and the
    /// default channel. @throw InputError when anything is missing or does not fit together
    HeightMapFile (*read)(std::string_view bytes, const std::string& file);
};

extern const HeightMapFormat kGwyFormat;
extern const HeightMapFormat kNanoscopeFormat;
extern const HeightMapFormat kGsfFormat;

/// readHeightMapFile for a content that is in memory already.
/// @param file for messages
/// @throw InputError as readHeightMapFile
[[nodiscard]] HeightMapFile readHeightMapBytes(std::string_view bytes, const std::string& file);

}  // namespace asperity
