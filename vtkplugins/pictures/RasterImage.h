#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// Pixels of a picture: red, green, blue and alpha, 8 bits each, the top row first. Colors are not
/// multiplied by alpha.
struct RasterImage {
    static constexpr int kChannels = 4;

    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;

    [[nodiscard]] std::size_t rowBytes() const {
        return static_cast<std::size_t>(width) * kChannels;
    }
    [[nodiscard]] const std::uint8_t* row(int row) const {
        return pixels.data() + static_cast<std::size_t>(row) * rowBytes();
    }
};

/// One picture above another of the same width.
[[nodiscard]] RasterImage stacked(RasterImage above, const RasterImage& below);

/// Size of a picture file [pixel].
struct PictureSize {
    int width = 1600;
    int height = 1000;
};

/// Parts of a picture besides its subject.
struct PictureParts {
    bool bars = true;          ///< scale bars, color bars, axes
    bool labels = true;        ///< title, legend, caption, names and values
    bool grid = true;          ///< lines behind the curves of a plot
    bool surfaceGrid = false;  ///< lines on the surface

    bool operator==(const PictureParts&) const = default;
};

}  // namespace asperity
