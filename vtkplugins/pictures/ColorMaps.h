#pragma once

#include "core/EnumTable.h"
#include "vtkplugins/pictures/Palette.h"

#include <cstdint>
#include <vector>

namespace asperity {

/// Colors from which those of values are taken.
enum class ColorMap : std::uint8_t {
    Standard,   ///< violet, green, yellow: that of the pictures
    Gray,       ///< black to white
    Gold,       ///< black, brown, gold, white: as AFM programs have it
    Viridis,    ///< violet, green, yellow
    Cividis,    ///< blue to yellow: looks the same without red or green vision
    Diverging,  ///< orange, near-white, blue: for values of either sign
};

template <>
inline constexpr auto kEnumTable<ColorMap> =
    std::to_array<EnumRow<ColorMap>>({{ColorMap::Standard, "standard", "Standard"},
                                      {ColorMap::Gray, "gray", "Gray"},
                                      {ColorMap::Gold, "gold", "AFM gold"},
                                      {ColorMap::Viridis, "viridis", "Viridis"},
                                      {ColorMap::Cividis, "cividis", "Cividis"},
                                      {ColorMap::Diverging, "diverging", "Diverging"}});

/// Colors of a table that is looked up; odd: one entry is exactly the middle.
inline constexpr int kColorTableSize = 511;

/// The colors of a map, evenly spaced from the lowest value to the highest, as many as its source
/// gives: in between they are interpolated.
[[nodiscard]] std::vector<Color> anchorsOf(ColorMap map);

/// A color map over a range of values. Cheap to look up.
class ColorTable {
public:
    ColorTable(ColorMap map, double low, double high);

    /// The color of a value; beyond the ends that of the nearer end.
    [[nodiscard]] Color of(double value) const;
    [[nodiscard]] ColorMap map() const { return map_; }
    [[nodiscard]] double low() const { return low_; }    ///< [unit of the values]
    [[nodiscard]] double high() const { return high_; }  ///< [unit of the values]

private:
    ColorMap map_;
    double low_;
    double high_;
    std::vector<Color> colors_;
};

/// Lightness L* of a color as it is seen, 0 (black) .. 100 (white), for sRGB under its own white.
/// Source: CIE 15 (2004), IEC 61966-2-1 (1999).
[[nodiscard]] double lightnessOf(const Color& color);

}  // namespace asperity
