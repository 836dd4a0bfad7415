#pragma once

#include "vtkplugins/pictures/Color.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>

class vtkLookupTable;

namespace asperity {

namespace palette {

inline constexpr Color kPaper{255, 255, 255};
inline constexpr Color kInk{31, 41, 51};
inline constexpr Color kMuted{95, 107, 118};
inline constexpr Color kFaint{216, 222, 228};
inline constexpr Color kSide{178, 184, 191};       ///< cut faces of a block of sample
inline constexpr Color kBackdrop{234, 237, 240};   ///< behind the live view
inline constexpr Color kTip{96, 112, 128};         ///< the AFM tip
inline constexpr Color kTipBody{186, 194, 203};    ///< the same as a lit solid
inline constexpr Color kLever{196, 202, 208};      ///< its cantilever
inline constexpr Color kForce{200, 40, 60};        ///< forces
inline constexpr Color kMarker{222, 30, 90};       ///< the tip's place
inline constexpr Color kPath{31, 41, 51};          ///< the way the tip went
inline constexpr Color kZoom{213, 94, 0};          ///< frame of the zoomed view
inline constexpr Color kGuide{213, 94, 0};         ///< what helps the device to hold a target
inline constexpr Color kContact{20, 20, 24};       ///< the edge of the contact
inline constexpr Color kCommanded{0, 114, 178};    ///< ghost of the tip without forces
inline constexpr Color kTrueTip{0, 128, 92};       ///< ghost of the tip where it really is
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

/// From values below zero over zero to those above: what is pushed in is blue.
inline constexpr std::array<Color, 7> kDiverging = {{{179, 78, 8},
                                                     {229, 138, 52},
                                                     {250, 205, 150},
                                                     {240, 240, 240},
                                                     {160, 203, 228},
                                                     {62, 138, 192},
                                                     {14, 74, 134}}};

}  // namespace palette

/// Color of the n-th curve: told apart with any color vision. Source: Okabe and Ito (2008).
[[nodiscard]] Color seriesColor(std::size_t index);

/// Blue over near-white to orange, neutral at zero, over [-limit, limit]: what is pushed in is
/// blue.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> divergingTable(double limit);

/// Dark to light over [low, high], with lightness that grows evenly.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> heightTable(double low, double high);

}  // namespace asperity
