#pragma once

#include "app/commands/ConvertTargets.h"

#include <string>
#include <vector>

namespace asperity {

/// Result of a conversion, for people.
struct Converted {
    std::string summary;             ///< "'Height', 256 x 256 pixels"
    std::vector<std::string> notes;  ///< on the file that was read and what was done to it
};

/// Writes one height map of a file, or its residual, or the surface without the imaging tip.
/// @throw Error; Canceled
[[nodiscard]] Converted convertMap(const ConvertOptions& options, const ConvertedFile& file);

/// Writes all channels of a file, whatever they show, as they are. @throw Error; Canceled
[[nodiscard]] Converted convertAll(const ConvertOptions& options, const ConvertedFile& file);

}  // namespace asperity
