#pragma once

#include "app/reports/page/PdfPiece.h"
#include "app/reports/page/PdfStyle.h"
#include "app/reports/page/ReportPage.h"

#include <vector>

namespace asperity {

/// All of a page, title first, as pieces. Page and style live as long as these.
[[nodiscard]] std::vector<PdfPiece> pagePieces(const ReportPage& page, const PdfStyle& style);

}  // namespace asperity
