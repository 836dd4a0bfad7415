#pragma once

#include <algorithm>
#include <cmath>

namespace asperity {

/// A place among the pixel centers of a row or column.
struct BetweenPixels {
    int first = 0;
    int second = 0;
    double part = 0.0;  ///< of the way from the first to the second, 0 to below 1
};

/// @param place in pixels, 0 at the center of the first one; beyond the outermost ones it counts as
///              the nearest one @param pixels in all
[[nodiscard]] inline BetweenPixels betweenPixels(double place, int pixels) noexcept {
    const double inside = std::clamp(place, 0.0, pixels - 1.0);
    const int first = static_cast<int>(inside);
    return {.first = first, .second = std::min(first + 1, pixels - 1), .part = inside - first};
}

/// A place in pixels, or the pixel center that rounding parts it from.
[[nodiscard]] inline double onCenter(double place) noexcept {
    constexpr double kSame = 1e-6;
    const double center = std::round(place);
    return std::abs(place - center) < kSame ? center : place;
}

/// Linear between two values. A weight of zero takes nothing from a value that is no number; not
/// std::lerp(), which does.
[[nodiscard]] inline double mixed(double from, double to, double part) noexcept {
    return part > 0.0 ? from + part * (to - from) : from;
}

/// Linear between four pixels.
/// @param pixel as pixel(row, column)
template <class Pixel>
[[nodiscard]] double bilinear(const BetweenPixels& rows, const BetweenPixels& columns,
                              const Pixel& pixel) noexcept {
    const auto across = [&](int row) {
        return mixed(pixel(row, columns.first), pixel(row, columns.second), columns.part);
    };
    return mixed(across(rows.first), across(rows.second), rows.part);
}

}  // namespace asperity
