#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>

class vtkLookupTable;

namespace asperity {

struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    // Written out for files that are compiled as C++17.
    friend constexpr bool operator==(const Color& a, const Color& b) {
        return a.red == b.red && a.green == b.green && a.blue == b.blue;
    }

    /// As VTK's properties take it: 0 ... 1 each.
    [[nodiscard]] std::array<double, 3> fractions() const {
        return {red / 255.0, green / 255.0, blue / 255.0};
    }
};

/// Colors by what they are for, of pictures and window. Text has a contrast of at least 4.5 : 1 to
/// what is behind it, as WCAG 2.1 asks.
/// @tparam Value Color, or what a toolkit paints with
template <typename Value>
struct PaletteOf {
    Value paper;      ///< behind panels and plots
    Value window;     ///< between the panels
    Value backdrop;   ///< behind the live view
    Value ink;        ///< text
    Value muted;      ///< captions, axes
    Value faint;      ///< frames, grids
    Value accent;     ///< what is chosen or running
    Value wash;       ///< behind what is chosen
    Value onAccent;   ///< text upon the accent
    Value fault;      ///< forces are off because of a fault; refused text
    Value caution;    ///< a result holds with a reservation
    Value refused;    ///< behind text that is refused
    Value side;       ///< cut faces of a block of sample
    Value tip;        ///< the AFM tip and cantilever, flat
    Value tipBody;    ///< the tip as a lit solid
    Value lever;      ///< its cantilever as a lit solid
    Value force;      ///< forces
    Value marker;     ///< the tip's position
    Value path;       ///< the way the tip went
    Value zoom;       ///< frame of the zoomed view
    Value guide;      ///< what helps the device to hold a target
    Value target;     ///< where the tip shall be
    Value commanded;  ///< ghost of the tip without forces
    Value trueTip;    ///< ghost of the tip where it really is

    // Colors of curves, told apart with any color vision.
    Value blue;
    Value orange;
    Value green;
    Value purple;
    Value sky;
    Value yellow;
    Value gray;
};

using Palette = PaletteOf<Color>;

/// Ink on white paper: of pictures, and of the light window.
extern const Palette kLightPalette;
/// Light ink on dark paper: of the dark window. The hues of its curves are those of the light one.
extern const Palette kDarkPalette;

/// Color of the n-th curve.
template <typename Value>
[[nodiscard]] const Value& seriesColor(const PaletteOf<Value>& colors, std::size_t index) {
    const std::array<const Value*, 7> all{&colors.blue,   &colors.orange, &colors.green,
                                          &colors.purple, &colors.sky,    &colors.yellow,
                                          &colors.gray};
    return *all.at(index % all.size());
}

/// Colors on top of a surface's own, the same whatever is around them.
namespace palette {

inline constexpr Color kContact{20, 20, 24};       ///< the edge of the contact
inline constexpr Color kSurfaceLine{31, 41, 51};   ///< of a grid
inline constexpr Color kNoData{150, 150, 150};     ///< of a surface where the scan holds no data
inline constexpr Color kUndefined{206, 210, 214};  ///< where a quantity has no value

/// Heights from low to high: dark to light, evenly spaced, with lightness that grows evenly.
inline constexpr std::array<Color, 9> kHeights = {{{45, 22, 74},
                                                   {60, 57, 125},
                                                   {50, 96, 142},
                                                   {39, 130, 142},
                                                   {38, 164, 134},
                                                   {86, 192, 108},
                                                   {156, 214, 78},
                                                   {222, 226, 74},
                                                   {252, 238, 160}}};

/// Colors from values below zero over zero to those above: what is pushed in is blue.
inline constexpr std::array<Color, 7> kDiverging = {{{179, 78, 8},
                                                     {229, 138, 52},
                                                     {250, 205, 150},
                                                     {240, 240, 240},
                                                     {160, 203, 228},
                                                     {62, 138, 192},
                                                     {14, 74, 134}}};

}  // namespace palette

/// Blue over near-white to orange, neutral at zero, over [-limit, limit]: what is pushed in is
/// blue.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> divergingTable(double limit);

/// Dark to light over [low, high], with lightness that grows evenly.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> heightTable(double low, double high);

}  // namespace asperity
