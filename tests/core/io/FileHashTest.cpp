#include "core/io/FileHash.h"

#include "core/Error.h"
#include "core/io/HeightStatistics.h"
#include "tests/core/io/BumpyMap.h"
#include "tests/core/io/RealScans.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {

TEST(FileHash, IsSha256) {
    const ScratchFolder folder;
    // The example messages of FIPS 180-4.
    EXPECT_EQ(sha256OfFile(folder.write("abc", "abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256OfFile(folder.write("empty", "")),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256OfFile(folder.write("million", std::string(1000000, 'a'))),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(FileHash, RefusesWhatItCannotRead) {
    const ScratchFolder folder;
    EXPECT_THROW((void)sha256OfFile(folder.file("none")), InputError);
    EXPECT_THROW((void)sha256OfFile(folder.path()), InputError);
}

TEST(FileHash, RealFilesAreThoseOfTheManifest) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable table(sharedData("afm/MANIFEST.csv"));
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& file = table.text(row, "file");
        EXPECT_EQ(sha256OfFile(sharedData("afm/" + file)), table.text(row, "sha256")) << file;
    }
}

TEST(HeightStatistics, SkipInvalidPixels) {
    HeightMap map = bumpyMap(3, 1);
    map.heights = {1.0, std::nan(""), 3.0};
    map.invalid = {0, 1, 0};
    const HeightStatistics statistics = heightStatistics(map);
    EXPECT_EQ(statistics.lowest, 1.0);
    EXPECT_EQ(statistics.highest, 3.0);
    EXPECT_EQ(statistics.mean, 2.0);
    EXPECT_EQ(statistics.rms, 1.0);
    EXPECT_EQ(statistics.invalidPixels, 1U);
}

TEST(HeightStatistics, OfNothingAreNotNumbers) {
    HeightMap map = bumpyMap(1, 1);
    map.invalid = {1};
    EXPECT_TRUE(std::isnan(heightStatistics(map).mean));
    EXPECT_EQ(heightStatistics(map).invalidPixels, 1U);
}

}  // namespace asperity::test
