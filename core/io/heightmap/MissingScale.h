#pragma once

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"

#include <filesystem>
#include <string>

namespace asperity {

/// What a file does not say of an image that could be a height map.
struct ScaleGap {
    std::string channel;
    int columns = 0;
    int rows = 0;
    bool size = false;    ///< the size of the scan is unknown
    bool height = false;  ///< the values are numbers without unit

    bool operator==(const ScaleGap&) const = default;
};

/// A channel is no height map until the user says its scale.
class MissingScale : public InputError {
public:
    /// @param path as the user gave it
    /// @param gap  something is missing
    MissingScale(const std::filesystem::path& path, const ScaleGap& gap);

    [[nodiscard]] const ScaleGap& gap() const { return gap_; }

private:
    ScaleGap gap_;
};

/// @throw MissingScale when size or unit of the channel are unknown; a unit that is no length is
///        none that is missing
void requireScale(const ScanChannel& channel, const std::filesystem::path& path);

}  // namespace asperity
