#include "core/io/heightmap/WholeImages.h"

#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

const SampleLayout kFourBytes{.size = {1, 1}};

}  // namespace

TEST(WholeImages, NoteNamesThoseThatTheFileLostWithItsEnd) {
    const MemoryBytes bytes("12345", "scan");
    WholeImages images;
    SampleLayout layout = kFourBytes;
    EXPECT_TRUE(images.holds(bytes, layout, "image 1", "Height"));
    EXPECT_TRUE(images.areAll());
    layout.offset = 4;
    EXPECT_FALSE(images.holds(bytes, layout, "image 2", "Phase"));
    layout.offset = 8;
    EXPECT_FALSE(images.holds(bytes, layout, "image 3", "Error"));
    EXPECT_FALSE(images.areAll());
    StoredScan scan;
    scan.channels.resize(1);
    images.finish(scan);
    EXPECT_THAT(scan.notes,
                testing::ElementsAre(testing::HasSubstr("'Phase', 'Error', which are")));
}

TEST(WholeImages, FileWithoutAWholeOneIsRefusedForItsFirst) {
    const MemoryBytes bytes("123", "scan");
    WholeImages images;
    EXPECT_FALSE(images.holds(bytes, kFourBytes, "image 1", "Height"));
    EXPECT_FALSE(images.holds(bytes, kFourBytes, "image 2", "Phase"));
    StoredScan scan;
    EXPECT_THAT(refusalOf([&] { images.finish(scan); }),
                testing::StartsWith("scan: image 1: its data end at byte 4"));
}

TEST(WholeImages, FileOfWholeImagesGetsNoNote) {
    const MemoryBytes bytes("1234", "scan");
    WholeImages images;
    EXPECT_TRUE(images.holds(bytes, kFourBytes, "image 1", "Height"));
    StoredScan scan;
    images.finish(scan);
    EXPECT_TRUE(scan.notes.empty());
}

}  // namespace asperity::test
