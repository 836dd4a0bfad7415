#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Steps that level the heights of a scan; a scene names any number of them, in order. Pixels
/// without data take part in none, and each exists in both precisions. Definitions:
/// docs/surface.md.
enum class LevelingStep : std::uint8_t {
    Plane,                ///< least-squares plane removed
    Rows,                 ///< median of each row removed, then the mean of all
    ThreePoint,           ///< plane through three positions removed
    Facet,                ///< plane of the prevailing slope removed, and the mean
    Quadratic,            ///< least-squares polynomial of second degree removed
    MedianOfDifferences,  ///< rows shifted to a median step of 0 between them; their trend is kept
    Scars,                ///< short rows that stand out are interpolated and marked
    Zero,                 ///< lowest height set to 0
};

template <>
inline constexpr auto kEnumTable<LevelingStep> = std::to_array<EnumRow<LevelingStep>>(
    {{LevelingStep::Plane, "plane", "plane"},
     {LevelingStep::Rows, "rows", "median of each row"},
     {LevelingStep::ThreePoint, "three_point", "three points"},
     {LevelingStep::Facet, "facet", "facets"},
     {LevelingStep::Quadratic, "quadratic", "quadratic"},
     {LevelingStep::MedianOfDifferences, "median_of_differences", "median of differences"},
     {LevelingStep::Scars, "scars", "scars"},
     {LevelingStep::Zero, "zero", "minimum to zero"}});

/// In the order in which they are done; empty: heights as the file gives them.
using LevelingSteps = std::vector<LevelingStep>;

/// Name for no step at all, in files and options.
inline constexpr const char* kNoLeveling = "none";

/// Positions of three_point, world frame [m].
using LevelPoints = std::array<Vector2, 3>;

/// "plane, zero"; "none" where there is no step.
[[nodiscard]] std::string textOf(const LevelingSteps& steps);

/// The steps of "plane,zero" or "none", with any spaces; none where a word is no step.
[[nodiscard]] std::optional<LevelingSteps> levelingSteps(std::string_view text);

/// All keys for people: "plane, rows, ... or none".
[[nodiscard]] std::string levelingKeys();

/// Returns why three positions cannot be a plane's; empty where they can: they must be finite and
/// span a triangle.
[[nodiscard]] std::string refusalOf(const LevelPoints& points);

}  // namespace asperity
