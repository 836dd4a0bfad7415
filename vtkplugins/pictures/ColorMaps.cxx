#include "vtkplugins/pictures/ColorMaps.h"

#include "vtkplugins/pictures/ColorMapTables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace asperity {

namespace {

std::vector<Color> fromHex(std::span<const std::uint32_t> entries) {
    std::vector<Color> colors;
    for (const std::uint32_t entry : entries) {
        colors.push_back({static_cast<std::uint8_t>(entry >> 16U),
                          static_cast<std::uint8_t>(entry >> 8U),
                          static_cast<std::uint8_t>(entry)});
    }
    return colors;
}

Color between(const Color& from, const Color& to, double part) {
    const auto mix = [part](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(double(a), double(b), part)));
    };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

/// Interpolates between evenly spaced colors.
Color colorWithin(std::span<const Color> anchors, double share) {
    const double position = share * static_cast<double>(anchors.size() - 1);
    const std::size_t left = std::min(static_cast<std::size_t>(position), anchors.size() - 2);
    return between(anchors[left], anchors[left + 1], position - static_cast<double>(left));
}

/// Evenly spaced colors through a gradient whose colors are not.
std::vector<Color> goldAnchors() {
    struct Stop {
        double position;
        Color color;
    };
    // Source: Gwyddion 2.62, its gradient "Gwyddion.net".
    constexpr std::array<Stop, 4> kStops = {{{0.0, {0, 0, 0}},
                                             {0.344671, {168, 40, 15}},
                                             {0.687075, {243, 194, 93}},
                                             {1.0, {255, 255, 255}}}};
    std::vector<Color> colors;
    std::size_t left = 0;
    for (int entry = 0; entry < kColorTableSize; ++entry) {
        const double position = entry / (kColorTableSize - 1.0);
        while (left + 2 < kStops.size() && position > kStops.at(left + 1).position) {
            ++left;
        }
        const Stop& from = kStops.at(left);
        const Stop& to = kStops.at(left + 1);
        colors.push_back(between(from.color, to.color,
                                 (position - from.position) / (to.position - from.position)));
    }
    return colors;
}

/// sRGB's transfer function, backwards.
double linear(std::uint8_t part) {
    const double value = part / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

std::vector<Color> anchorsOf(ColorMap map) {
    switch (map) {
    case ColorMap::Gray:
        return {{0, 0, 0}, {255, 255, 255}};
    case ColorMap::Gold:
        return goldAnchors();
    case ColorMap::Viridis:
        return fromHex(colormaps::kViridis);
    case ColorMap::Cividis:
        return fromHex(colormaps::kCividis);
    case ColorMap::Diverging:
        return {palette::kDiverging.begin(), palette::kDiverging.end()};
    case ColorMap::Standard:
        break;
    }
    return {palette::kHeights.begin(), palette::kHeights.end()};
}

ColorTable::ColorTable(ColorMap map, double low, double high) : map_(map), low_(low), high_(high) {
    const std::vector<Color> anchors = anchorsOf(map);
    colors_.reserve(kColorTableSize);
    for (int entry = 0; entry < kColorTableSize; ++entry) {
        colors_.push_back(colorWithin(anchors, entry / (kColorTableSize - 1.0)));
    }
}

Color ColorTable::of(double value) const {
    const double extent = high_ - low_;
    const double share = extent > 0.0 ? std::clamp((value - low_) / extent, 0.0, 1.0) : 0.5;
    return colors_[static_cast<std::size_t>(share * (kColorTableSize - 1) + 0.5)];
}

double lightnessOf(const Color& color) {
    const double luminance =
        0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
    constexpr double kEpsilon = 216.0 / 24389.0;
    constexpr double kKappa = 24389.0 / 27.0;
    return luminance > kEpsilon ? 116.0 * std::cbrt(luminance) - 16.0 : kKappa * luminance;
}

}  // namespace asperity
