#pragma once

#include "core/io/heightmap/SampleRows.h"

#include <string>
#include <vector>

namespace asperity {

/// A channel of an OpenEXR image.
struct ExrChannel {
    std::string name;
    SampleType type = SampleType::Float32;  ///< as it is decoded
    bool isHalf = false;                    ///< stored with 11 bits
    bool isWhole = true;                    ///< it has a sample for each pixel
};

/// Those of the first part, by name.
/// @param bytes whose headers have been checked
/// @throw InputError when the OpenEXR library refuses the file
[[nodiscard]] std::vector<ExrChannel> exrChannels(const ByteSource& bytes);

/// All samples of these channels, one channel after the other, row after row from the top, in the
/// processor's byte order. It unpacks all channels of the file, whichever are asked for. Any
/// threads. @throw InputError when the OpenEXR library cannot decode them
[[nodiscard]] std::string decodeExr(const ByteSource& bytes,
                                    const std::vector<ExrChannel>& channels);

}  // namespace asperity
