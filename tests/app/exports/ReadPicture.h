#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace asperity::test {

/// A picture of 8 bits a channel as another library reads it, top row first.
struct ReadPicture {
    int width = 0;
    int height = 0;
    int channels = 0;                  ///< of the file: 3 (RGB), or 4 with alpha
    double dpi = 0.0;                  ///< pixels an inch
    std::vector<std::uint8_t> pixels;  ///< RGBA, colors not multiplied by alpha
};

/// @throw std::runtime_error where it is no PNG in RGB (Qt) or no such TIFF (libtiff)
[[nodiscard]] ReadPicture readPicture(const std::filesystem::path& path);

}  // namespace asperity::test
