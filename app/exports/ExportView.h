#pragma once

#include "core/EnumTable.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Content of a picture. The first ones are the large 3-D view of the window.
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

/// Returns whether it is the large 3-D view.
[[nodiscard]] constexpr bool isSpatial(ExportView view) { return view <= ExportView::Section; }
/// Returns true: every view can be drawn.
[[nodiscard]] constexpr bool isPicture(ExportView /*view*/) { return true; }
/// Returns whether a view is a surface with values at its points.
[[nodiscard]] constexpr bool isField(ExportView view) { return view == ExportView::Deformation; }
/// Returns whether it consists of lines and letters alone.
[[nodiscard]] constexpr bool isPlot(ExportView view) { return view >= ExportView::Forces; }
/// Returns whether a view is empty without a run.
[[nodiscard]] constexpr bool needsRun(ExportView view) { return view >= ExportView::Deformation; }

enum class ExportFormat : std::uint8_t { Png, Tiff, Svg, Pdf, Csv, Exr, Vtp, Vts };

/// A format of files, and the views that are written in it.
struct ExportFormatRow {
    ExportFormat value;
    const char* key;    ///< the extension of its files, without the dot
    const char* other;  ///< another extension of it; null: none
    bool (*holds)(ExportView view);
};

/// In the order in which a user is offered them: command line, dialog and refusals read this table.
template <>
inline constexpr auto kEnumTable<ExportFormat> =
    std::to_array<ExportFormatRow>({{ExportFormat::Png, "png", nullptr, isPicture},
                                    {ExportFormat::Tiff, "tif", "tiff", isPicture},
                                    {ExportFormat::Svg, "svg", nullptr, isPlot},
                                    {ExportFormat::Pdf, "pdf", nullptr, isPlot},
                                    {ExportFormat::Exr, "exr", nullptr, isField},
                                    {ExportFormat::Vtp, "vtp", nullptr, isField},
                                    {ExportFormat::Vts, "vts", nullptr, isField},
                                    {ExportFormat::Csv, "csv", nullptr, [](ExportView view) {
                                         return isPlot(view) || isField(view);
                                     }}});

/// Returns whether it holds pixels.
[[nodiscard]] constexpr bool isRaster(ExportFormat format) { return format <= ExportFormat::Tiff; }
/// Returns whether a file of the format is a picture; if not, it has the numbers of the plot.
[[nodiscard]] constexpr bool isDrawn(ExportFormat format) { return format <= ExportFormat::Pdf; }

/// The formats that a view is written in.
[[nodiscard]] std::vector<ExportFormat> formatsOf(ExportView view);

/// Returns the format of a file's extension.
/// @throw Error where a view is not written so, with the extensions that it is written with
[[nodiscard]] ExportFormat formatOf(const std::filesystem::path& file, ExportView view);

/// The extensions of all views, for help: ".png, .tif; of deformation .exr, .csv, too; ...".
[[nodiscard]] std::string extensionHelp();

}  // namespace asperity
