#include "app/reports/page/PdfPieces.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace asperity {
namespace {

PdfPiece piece(double height, double space = 0.0, bool keepsNext = false) {
    return {.space = space, .height = height, .keepsNext = keepsNext, .draw = {}};
}

TEST(PdfPieces, FillOneSheetAfterTheOther) {
    const std::vector<PdfPiece> pieces{piece(40.0, 5.0), piece(40.0, 10.0), piece(20.0, 1.0)};
    const auto sheets = onSheets(pieces, 100.0);
    ASSERT_EQ(sheets.size(), 2U);
    ASSERT_EQ(sheets[0].size(), 2U);
    EXPECT_EQ(sheets[0][0].y, 0.0) << "no space at the top";
    EXPECT_EQ(sheets[0][1].y, 50.0);
    EXPECT_EQ(sheets[1][0].y, 0.0);
    EXPECT_EQ(sheets[1][0].piece, &pieces[2]);
}

TEST(PdfPieces, StayWithWhatTheyBelongTo) {
    const std::vector<PdfPiece> pieces{piece(60.0), piece(20.0, 0.0, true), piece(30.0)};
    const auto sheets = onSheets(pieces, 100.0);
    ASSERT_EQ(sheets.size(), 2U);
    EXPECT_EQ(sheets[0].size(), 1U) << "a heading is not the last of a sheet";
    EXPECT_EQ(sheets[1].size(), 2U);
}

TEST(PdfPieces, OfATableHaveItsTitlesOnEverySheet) {
    const auto head = std::make_shared<PdfPiece>(piece(10.0));
    std::vector<PdfPiece> pieces(12, piece(10.0));
    for (PdfPiece& row : pieces) {
        row.head = head;
    }
    const auto sheets = onSheets(pieces, 100.0);
    ASSERT_EQ(sheets.size(), 2U);
    ASSERT_EQ(sheets[1].size(), 3U);
    EXPECT_EQ(sheets[1][0].piece, head.get());
    EXPECT_EQ(sheets[1][1].y, 10.0);
}

TEST(PdfPieces, HigherThanASheetTogetherArePartedAtItsEnd) {
    const std::vector<PdfPiece> pieces{piece(60.0, 0.0, true), piece(60.0, 0.0, true), piece(60.0)};
    EXPECT_EQ(onSheets(pieces, 100.0).size(), 3U);
}

}  // namespace
}  // namespace asperity
