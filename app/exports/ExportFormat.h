#pragma once

#include "app/exports/ExportView.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

enum class ExportFormat : std::uint8_t { Png, Tiff, Svg, Pdf, Csv, Exr, Vtp, Vts };

/// A format of files, and the views that are written in it.
struct ExportFormatRow {
    ExportFormat value;
    const char* key;    ///< the extension of its files, without the dot
    const char* other;  ///< another extension that stands for it; null: none
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

/// Whether it holds pixels.
[[nodiscard]] constexpr bool isRaster(ExportFormat format) { return format <= ExportFormat::Tiff; }
/// Returns whether a file of the format is a picture; if not, it has the numbers of the plot.
[[nodiscard]] constexpr bool isDrawn(ExportFormat format) { return format <= ExportFormat::Pdf; }

/// The formats that a view is written in.
[[nodiscard]] std::vector<ExportFormat> formatsOf(ExportView view);

/// The format that a file's extension stands for.
/// @throw Error where a view is not written so, with the extensions that it is written with
[[nodiscard]] ExportFormat formatOf(const std::filesystem::path& file, ExportView view);

/// The extensions of all views, for help: ".png, .tif; of deformation .exr, .csv, too; ...".
[[nodiscard]] std::string extensionHelp();

}  // namespace asperity
