#pragma once

#include "app/reports/page/ReportPage.h"

#include <filesystem>

namespace asperity {

/// Writes the page as PDF: A4 sheets, text that can be selected and searched, fonts and pictures in
/// it, plots as vectors. No table row and no picture is cut; the titles of a table stand above each
/// of its parts. Links lead to files beside it. There is a QGuiApplication.
/// @throw Error when it cannot be written
void writePdfPage(const std::filesystem::path& path, const ReportPage& page);

}  // namespace asperity
