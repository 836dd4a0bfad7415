#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// What a picture shows. The first ones are the large 3-D view of the window.
enum class ExportView : std::uint8_t {
    Spatial,
    Front,
    Back,
    Right,
    Left,
    Top,
    Bottom,
    Section,
    Overview,
    Deformation,
    Forces,
    Cycle,
};

template <>
inline constexpr auto kEnumTable<ExportView> = std::to_array<EnumRow<ExportView>>(
    {{ExportView::Spatial, "3d", "the window's large view"},
     {ExportView::Front, "front", "the same from the front"},
     {ExportView::Back, "back", "from behind"},
     {ExportView::Right, "right", "from the right"},
     {ExportView::Left, "left", "from the left"},
     {ExportView::Top, "top", "from above"},
     {ExportView::Bottom, "bottom", "from below"},
     {ExportView::Section, "section", "with the half before the tip cut away"},
     {ExportView::Overview, "overview", "the whole scan with tip and path"},
     {ExportView::Deformation, "deformation", "the deformed surface around the contact"},
     {ExportView::Forces, "forces", "forces, contact and signals over time"},
     {ExportView::Cycle, "cycle", "force-distance curve of the cycle of the moment"}});

/// Whether it is the large 3-D view.
[[nodiscard]] constexpr bool isSpatial(ExportView view) { return view <= ExportView::Section; }
/// Returns true: every view can be drawn.
[[nodiscard]] constexpr bool isPicture(ExportView /*view*/) { return true; }
/// Returns whether a view is a surface with values at its points.
[[nodiscard]] constexpr bool isField(ExportView view) { return view == ExportView::Deformation; }
/// Whether it consists of lines and letters alone.
[[nodiscard]] constexpr bool isPlot(ExportView view) { return view >= ExportView::Forces; }
/// Whether there is nothing to show without a run.
[[nodiscard]] constexpr bool needsRun(ExportView view) { return view >= ExportView::Deformation; }

}  // namespace asperity
