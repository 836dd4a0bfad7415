#pragma once

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/surface/ScaleGap.h"

#include <filesystem>

namespace asperity {

/// A channel is no height map until the user says its scale.
class MissingScale : public InputError {
public:
    /// @param path as the user gave it
    /// @param gap  something is missing
    MissingScale(const std::filesystem::path& path, const ScaleGap& gap);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const ScaleGap& gap() const { return gap_; }

private:
    std::filesystem::path path_;
    ScaleGap gap_;
};

/// @throw MissingScale when size or unit of the channel are unknown; a unit that is no length is
///        none that is missing
void requireScale(const ScanChannel& channel, const std::filesystem::path& path);

}  // namespace asperity
