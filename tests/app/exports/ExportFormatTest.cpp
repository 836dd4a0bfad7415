#include "app/exports/ExportView.h"
#include "app/exports/PictureFile.h"
#include "core/Error.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

TEST(ExportFormat, IsThatOfTheExtension) {
    EXPECT_EQ(formatOf("a/b.png", ExportView::Spatial), ExportFormat::Png);
    EXPECT_EQ(formatOf("b.TIF", ExportView::Overview), ExportFormat::Tiff);
    EXPECT_EQ(formatOf("b.tiff", ExportView::Cycle), ExportFormat::Tiff);
    EXPECT_EQ(formatOf("b.svg", ExportView::Forces), ExportFormat::Svg);
    EXPECT_EQ(formatOf("b.pdf", ExportView::Cycle), ExportFormat::Pdf);
    EXPECT_EQ(formatOf("b.csv", ExportView::Deformation), ExportFormat::Csv);
    EXPECT_EQ(formatOf("b.vts", ExportView::Deformation), ExportFormat::Vts);
}

TEST(ExportFormat, RefusesWhatAViewIsNotWrittenAs) {
    for (const char* file : {"a.svg", "a.exr", "a.csv", "a.jpg", "a", ""}) {
        EXPECT_THROW((void)formatOf(file, ExportView::Spatial), Error) << file;
    }
    for (const char* file : {"a.svg", "a.pdf"}) {
        EXPECT_THROW((void)formatOf(file, ExportView::Deformation), Error) << file;
    }
    EXPECT_THROW((void)formatOf("a.vtp", ExportView::Cycle), Error);
    try {
        (void)formatOf("a.jpg", ExportView::Front);
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(".png, .tif, .tiff"), std::string::npos);
    }
}

TEST(ExportFormat, AllThatAViewIsWrittenInIsTakenByItsExtension) {
    for (const ExportView view : kValues<ExportView>) {
        ASSERT_FALSE(formatsOf(view).empty());
        for (const ExportFormat format : formatsOf(view)) {
            EXPECT_EQ(formatOf(std::string("a.") + keyOf(format), view), format) << keyOf(view);
        }
    }
}

TEST(ExportFormat, HelpNamesWhatAllViewsHaveAndWhatSomeHave) {
    EXPECT_EQ(extensionHelp(), ".png, .tif; of deformation .exr, .vtp, .vts, .csv, too; of forces "
                               "and cycle .svg, .pdf, .csv, too");
}

TEST(JournalColumn, IsFoundByItsName) {
    EXPECT_EQ(journalColumn("single").width, 85.0);
    EXPECT_EQ(journalColumn("double").width, 174.0);
    EXPECT_THROW((void)journalColumn("triple"), Error);
}

}  // namespace
}  // namespace asperity
