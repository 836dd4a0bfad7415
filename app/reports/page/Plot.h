#pragma once

#include "core/EnumTable.h"
#include "vtkplugins/pictures/Palette.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// A color of a plot: each palette has its own.
enum class PlotInk : std::uint8_t { Ink, Muted, Faint, Blue, Orange, Green, Purple, Sky, Yellow };

/// What an ink is called in style sheets, and where a palette has it.
struct PlotInkRow {
    PlotInk value;
    const char* key;
    Color Palette::*color;
};

template <>
inline constexpr auto kEnumTable<PlotInk> =
    std::to_array<PlotInkRow>({{PlotInk::Ink, "ink", &Palette::ink},
                               {PlotInk::Muted, "muted", &Palette::muted},
                               {PlotInk::Faint, "faint", &Palette::faint},
                               {PlotInk::Blue, "blue", &Palette::blue},
                               {PlotInk::Orange, "orange", &Palette::orange},
                               {PlotInk::Green, "green", &Palette::green},
                               {PlotInk::Purple, "purple", &Palette::purple},
                               {PlotInk::Sky, "sky", &Palette::sky},
                               {PlotInk::Yellow, "yellow", &Palette::yellow}});

inline constexpr std::size_t kCurveInks = 6;  ///< of curves that differ, from Blue on

/// The ink of the n-th curve.
[[nodiscard]] constexpr PlotInk curveInk(std::size_t index) {
    return static_cast<PlotInk>(static_cast<std::size_t>(PlotInk::Blue) + index % kCurveInks);
}

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

struct PlotCurve {
    std::string name;               ///< in the legend; empty: it is not there
    std::vector<PlotPoint> points;  ///< SI units; one that is not finite parts the curve
    PlotInk ink = PlotInk::Blue;
    double width = 1.0;  ///< [pt]
};

/// A ring.
struct PlotMark {
    PlotPoint place;  ///< SI units
    PlotInk ink = PlotInk::Blue;
};

/// A quantity along an axis.
struct PlotAxis {
    std::string title;
    std::string unit;  ///< SI, without prefix
};

/// Curves over one quantity, as vectors: how they are laid out is decided by layOut() alone.
struct Plot {
    std::string description;  ///< for those who do not see it
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks;
    double low = 0.0;   ///< smallest x that is shown [SI]; as large as `high`: all is shown
    double high = 0.0;  ///< largest x that is shown [SI]
};

}  // namespace asperity
