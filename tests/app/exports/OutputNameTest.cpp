#include "app/exports/PictureExport.h"
#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

const OutputNameParts kParts{.file = "silicon", .view = "3d"};

TEST(OutputName, FillsPlaceholdersAndCountsToAFreeName) {
    const test::ScratchFolder folder;
    const std::string text = (folder.path() / "{view}-{file}-{n}.tif").string();
    EXPECT_EQ(outputPath(text, kParts, false), folder.path() / "3d-silicon-1.tif");
    (void)folder.write("3d-silicon-1.tif", "x");
    (void)folder.write("3d-silicon-2.tif", "x");
    EXPECT_EQ(outputPath(text, kParts, false), folder.path() / "3d-silicon-3.tif");
    EXPECT_EQ(outputPath(text, kParts, true), folder.path() / "3d-silicon-3.tif");
}

TEST(OutputName, OfAFolderIsANewFileInIt) {
    const test::ScratchFolder folder;
    EXPECT_EQ(outputPath(folder.path().string(), kParts, false),
              folder.path() / "silicon_3d_1.png");
    EXPECT_EQ(outputPath((folder.path() / "new/").string(), kParts, false),
              folder.path() / "new/silicon_3d_1.png");
}

TEST(OutputName, ReplacesNothingUnasked) {
    const test::ScratchFolder folder;
    const std::string file = folder.write("there.png", "x").string();
    EXPECT_THROW((void)outputPath(file, kParts, false), Error);
    EXPECT_EQ(outputPath(file, kParts, true), file);
    const std::string named = (folder.path() / "{file}.png").string();
    (void)folder.write("silicon.png", "x");
    EXPECT_THROW((void)outputPath(named, kParts, false), Error);
}

TEST(OutputName, OfAFolderWithBracesIsFilledInTheNameAlone) {
    const test::ScratchFolder folder;
    EXPECT_EQ(namedPath(folder.path() / "{x}", "{file}_{n}.png", kParts),
              folder.path() / "{x}/silicon_1.png");
    (void)folder.write("silicon.png", "x");
    EXPECT_EQ(namedPath(folder.path(), "{file}.png", kParts), folder.path() / "silicon.png");
    EXPECT_THROW((void)namedPath(folder.path(), "{time}", kParts), Error);
}

TEST(OutputName, FoldersOfOutAreAsTheyAre) {
    const test::ScratchFolder folder;
    const std::filesystem::path braces = folder.path() / "a {n} {b}";
    std::filesystem::create_directory(braces);
    EXPECT_EQ(outputPath(braces.string() + "/", kParts, false), braces / "silicon_3d_1.png");
    EXPECT_EQ(outputPath(braces.string(), kParts, false), braces / "silicon_3d_1.png");
    EXPECT_EQ(outputPath((braces / "{view}.png").string(), kParts, false), braces / "3d.png");
    EXPECT_EQ(filledPath(braces / "{file}_{n}.mp4", kParts), braces / "silicon_1.mp4");
}

TEST(OutputName, RefusesOtherPlaceholders) {
    EXPECT_THROW((void)outputPath("{time}.png", kParts, false), Error);
    EXPECT_THROW((void)outputPath("{file", kParts, false), Error);
    EXPECT_THROW((void)outputPath("{}.png", kParts, false), Error);
}

}  // namespace
}  // namespace asperity
