#include "app/exports/PictureFile.h"

#include "core/Error.h"
#include "tests/app/exports/ReadPicture.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace asperity {
namespace {

/// 3 x 2 pixels; the first row from the top is red, green, blue.
RasterImage smallImage(std::uint8_t alpha) {
    return {.width = 3, .height = 2, .pixels = {255, 0, 0,   255, 0,   255, 0,  255,
                                                0,   0, 255, 255, 1,   2,   3,  255,
                                                4,   5, 6,   255, 200, 100, 50, alpha}};
}

class PictureFile : public ::testing::TestWithParam<ExportFormat> {
protected:
    [[nodiscard]] std::filesystem::path path() const {
        return scratch.path() / (GetParam() == ExportFormat::Png ? "a.png" : "a.tif");
    }
    test::ScratchFolder scratch;
};

TEST_P(PictureFile, HoldsPixelsAndResolution) {
    writePicture(path(), smallImage(255), GetParam(), 300.0);
    const test::ReadPicture picture = test::readPicture(path());
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.channels, 3);
    EXPECT_NEAR(picture.dpi, 300.0, 0.02);
    EXPECT_EQ(picture.pixels, smallImage(255).pixels);
}

TEST_P(PictureFile, KeepsAlphaUnmultiplied) {
    writePicture(path(), smallImage(128), GetParam(), 96.0);
    const test::ReadPicture picture = test::readPicture(path());
    EXPECT_EQ(picture.channels, 4);
    EXPECT_EQ(picture.pixels, smallImage(128).pixels);
}

TEST_P(PictureFile, LeavesNothingWhereItCannotBeWritten) {
    EXPECT_THROW(writePicture("/proc/none/a.png", smallImage(255), GetParam(), 96.0), Error);
    const test::FileSizeLimit limit(40);
    EXPECT_THROW(writePicture(path(), smallImage(255), GetParam(), 96.0), Error);
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

INSTANTIATE_TEST_SUITE_P(Formats, PictureFile,
                         ::testing::Values(ExportFormat::Png, ExportFormat::Tiff),
                         [](const auto& test) {
                             return test.param == ExportFormat::Png ? "Png" : "Tiff";
                         });

}  // namespace
}  // namespace asperity
