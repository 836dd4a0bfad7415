#pragma once

#include "app/exports/PictureFile.h"
#include "app/exports/PlotPage.h"

#include <filesystem>
#include <span>

namespace asperity {

/// Writes a page as SVG, with letters as text. Whole or not at all. @throw Error
void writeSvg(const std::filesystem::path& path, const PlotPage& page, bool transparent);

/// Writes a page as PDF, with its fonts. There is a QGuiApplication. Whole or not at all.
/// @throw Error
void writePdf(const std::filesystem::path& path, const PlotPage& page, bool transparent);

/// Writes charts as a page in any of the formats of a plot but a table: one of these, or pixels.
/// There is a QGuiApplication. @throw Error, also where the page is too small
void writePlotPage(const std::filesystem::path& path, std::span<const Chart> charts,
                   const PictureSpec& spec, ExportFormat format);

/// A page as pixels. There is a QGuiApplication.
[[nodiscard]] RasterImage drawnPage(const PlotPage& page, const PictureSpec& spec);

}  // namespace asperity
