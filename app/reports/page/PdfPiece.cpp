#include "app/reports/page/PdfPiece.h"

namespace asperity {

namespace {

/// Of the piece and all that are kept with it.
double heightTogether(const std::vector<PdfPiece>& pieces, std::size_t first) {
    double height = pieces[first].height;
    for (std::size_t i = first; pieces[i].keepsNext && i + 1 < pieces.size(); ++i) {
        height += pieces[i + 1].space + pieces[i + 1].height;
    }
    return height;
}

}  // namespace

std::vector<std::vector<PlacedPiece>> onSheets(const std::vector<PdfPiece>& pieces, double height) {
    std::vector<std::vector<PlacedPiece>> sheets(1);
    double y = 0.0;
    bool isKept = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PdfPiece& piece = pieces[i];
        const bool isFull =
            !isKept && y > 0.0 && y + piece.space + heightTogether(pieces, i) > height;
        // What is kept together may be higher than a sheet.
        const bool isOver = isKept && y + piece.space + piece.height > height;
        if (isFull || isOver) {
            sheets.emplace_back();
            y = 0.0;
            if (piece.head) {
                sheets.back().push_back({y, piece.head.get()});
                y += piece.head->height;
            }
        }
        y += y > 0.0 ? piece.space : 0.0;
        sheets.back().push_back({y, &piece});
        y += piece.height;
        isKept = piece.keepsNext;
    }
    return sheets;
}

}  // namespace asperity
