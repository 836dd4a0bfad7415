#pragma once

#include "app/charts/ChartPage.h"
#include "vtkplugins/pictures/Palette.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

class QColor;
class QFont;
class QImage;
class QPageLayout;
class QPainter;
class QPdfWriter;

namespace asperity {

// Charts as SVG, PDF and pixels: texts stay texts, fonts are in the PDF, the same page gives the
// same bytes. What is painted needs a QGuiApplication.

/// Returns a text as XML and HTML show it, printable and without markup; also within quotes.
[[nodiscard]] std::string escaped(std::string_view text);
/// Returns a color as style sheets have it.
[[nodiscard]] std::string styleColor(const Color& color);
[[nodiscard]] QColor colorForQt(const Color& color);
/// Returns a font whose letters are never joined: a reader who copies "film" gets four of them.
[[nodiscard]] QFont drawnFont(const char* family = "DejaVu Sans");

/// Returns a page as an <svg> within HTML. @param description for those who do not see it
[[nodiscard]] std::string svgOf(const ChartPage& page, const std::string& description);
/// Returns the rules of a style sheet that give an <svg> the colors of a palette.
[[nodiscard]] std::string svgStyle(const Palette& colors);
/// Paints a page at the painter's origin. @param scale pixels of the device per pixel of the page
void paint(QPainter& painter, const ChartPage& page, double scale);
/// Returns a page as pixels. @param ratio pixels per pixel of the page
[[nodiscard]] QImage drawn(const ChartPage& page, double ratio = 1.0, bool isTransparent = false);

// Each file is written whole or not at all. @throw Error

void writeSvg(const std::filesystem::path& path, const ChartPage& page, bool isTransparent = false);
void writePng(const std::filesystem::path& path, const ChartPage& page);
void writePdf(const std::filesystem::path& path, const ChartPage& page, bool isTransparent = false);

inline constexpr int kPdfResolution = 1200;  ///< of positions and letters [dots an inch]

/// Writes what is drawn as PDF. @param layout of its sheets
void writePdf(const std::filesystem::path& path, const std::string& title,
              const QPageLayout& layout,
              const std::function<void(QPdfWriter& writer, QPainter& painter)>& draw);

}  // namespace asperity
