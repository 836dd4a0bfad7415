#pragma once

#include "app/reports/page/PageBlock.h"
#include "app/reports/page/PdfPiece.h"
#include "app/reports/page/PdfStyle.h"

#include <vector>

namespace asperity {

/// The rows of a table, each a piece; columns are as wide as their texts need and the sheet has.
[[nodiscard]] std::vector<PdfPiece> tablePieces(const PageTable& table, const PdfStyle& style);

}  // namespace asperity
