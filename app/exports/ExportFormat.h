#pragma once

#include "app/exports/ExportView.h"

#include <filesystem>
#include <string>

namespace asperity {

enum class ExportFormat : std::uint8_t { Png, Tiff, Svg, Pdf, Csv, Exr, Vtp, Vts };

/// Whether it holds pixels.
[[nodiscard]] constexpr bool isRaster(ExportFormat format) { return format <= ExportFormat::Tiff; }

/// The format that a file's extension stands for.
/// @throw Error where a view is not written so, with the extensions that it is written with
[[nodiscard]] ExportFormat formatOf(const std::filesystem::path& file, ExportView view);

/// The extensions of a view's files: ".png, .tif, .tiff".
[[nodiscard]] std::string extensionsOf(ExportView view);

}  // namespace asperity
