#pragma once

#include <cstddef>
#include <limits>

namespace asperity {

/// A square of pixels of a square grid; it may reach beyond the grid.
struct PixelWindow {
    int row = 0;     ///< first
    int column = 0;  ///< first
    int size = 0;    ///< pixels per side
};

/// The rectangle around some pixels, inclusive; empty at first.
struct PixelBounds {
    int lowRow = std::numeric_limits<int>::max();
    int lowColumn = std::numeric_limits<int>::max();
    int highRow = -1;
    int highColumn = -1;

    [[nodiscard]] bool empty() const noexcept { return highRow < 0; }
    void include(int row, int column) noexcept;
    void include(const PixelBounds& others) noexcept;
    /// Whether all lie inside of the window with `margin` pixels to spare.
    [[nodiscard]] bool within(const PixelWindow& window, int margin) const noexcept;
};

/// The window of a quickly transformed size around bounds that are not empty, with some room to
/// grow, inside of a grid of samples x samples as far as it fits.
[[nodiscard]] PixelWindow windowAround(const PixelBounds& bounds, int samples) noexcept;

/// Calls visit(pixel of the grid, pixel of the window), row-major, for each pixel of both.
template <class Visit>
void forEachInWindow(int samples, const PixelWindow& window, const Visit& visit) {
    const auto pixel = [](int row, int column, int width) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    for (int row = 0; row < window.size; ++row) {
        const int gridRow = window.row + row;
        for (int column = 0; column < window.size; ++column) {
            const int gridColumn = window.column + column;
            if (gridRow >= 0 && gridRow < samples && gridColumn >= 0 && gridColumn < samples) {
                visit(pixel(gridRow, gridColumn, samples), pixel(row, column, window.size));
            }
        }
    }
}

}  // namespace asperity
