#pragma once

#include "core/io/HeightMapFile.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// An image that still lies in the file's bytes.
struct StoredChannel {
    ScanChannel channel;  ///< but for the heights and the mask of its map
    /// Writes the values of a row, 0 at the top, in the channel's unit; what is not finite holds no
    /// data. Needs the bytes; any threads.
    std::function<void(int row, double* values)> readRow;
};

struct StoredScan {
    std::vector<StoredChannel> channels;
    std::vector<std::string> notes;
};

/// A file type that can be read. A further format is one source file that defines such a constant,
/// its declaration below, and its line in the table of HeightMapFile.cpp.
struct HeightMapFormat {
    std::string_view name;  ///< for people
    /// Whether the content starts like this type, damaged or not.
    bool (*recognises)(std::string_view bytes);
    /// Checks the whole content, but leaves the values where they are; `file` is for messages.
    /// @throw InputError when anything is missing or does not fit together
    StoredScan (*read)(std::string_view bytes, const std::string& file);
};

extern const HeightMapFormat kGwyFormat;
extern const HeightMapFormat kNanoscopeFormat;
extern const HeightMapFormat kGsfFormat;

/// readHeightMapFile for a content that is in memory already.
/// @param file for messages
/// @throw InputError as readHeightMapFile
[[nodiscard]] HeightMapFile readHeightMapBytes(std::string_view bytes, const std::string& file);

}  // namespace asperity
