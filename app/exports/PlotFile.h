#pragma once

#include "app/exports/PictureFile.h"
#include "app/exports/PlotPage.h"

#include <filesystem>

namespace asperity {

/// Writes a page as SVG, with letters as text. Whole or not at all. @throw Error
void writeSvg(const std::filesystem::path& path, const PlotPage& page, bool transparent);

/// Writes a page as PDF, with its fonts. There is a QGuiApplication. Whole or not at all.
/// @throw Error
void writePdf(const std::filesystem::path& path, const PlotPage& page, bool transparent);

/// A page as pixels. There is a QGuiApplication.
[[nodiscard]] RasterImage drawnPage(const PlotPage& page, const PictureSpec& spec);

}  // namespace asperity
