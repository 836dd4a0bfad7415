#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// One row of numbers.
StoredChannel storedOf(const std::vector<double>& numbers, const std::string& unit = "") {
    StoredChannel stored;
    stored.channel.unit = unit;
    stored.channel.map.columns = static_cast<int>(numbers.size());
    stored.channel.map.rows = 1;
    stored.readRow = [numbers](int, RowRoom&, double* values) {
        std::ranges::copy(numbers, values);
    };
    return stored;
}

bool isMask(const std::vector<double>& numbers, const std::string& unit = "") {
    StoredChannel stored = storedOf(numbers, unit);
    noteMask(stored);
    EXPECT_EQ(stored.channel.notes.size(), stored.channel.isMask ? 1U : 0U);
    return stored.channel.isMask;
}

}  // namespace

TEST(MaskValues, AreZeroAndOneOrTheHighestNumberOfAnImage) {
    EXPECT_TRUE(isMask({0, 1, 1, 0}));
    EXPECT_TRUE(isMask({255, 0, 0, 0}));
    EXPECT_TRUE(isMask({0, 65535}));
    EXPECT_TRUE(isMask({0, NAN, 1})) << "a pixel without data is no other value";
}

TEST(MaskValues, AreSharesMostOfThemAtTheirEnds) {
    EXPECT_TRUE(isMask({0, 0, 0.3, 0.7, 1, 1}));
    EXPECT_FALSE(isMask({0, 0.2, 0.3, 0.7, 0.9, 1})) << "heights from 0 to 1";
    std::vector<double> particles(1000, 0.0);  // on a flat surface, the highest of which is 1
    particles[1] = 0.9;
    particles[2] = 1.0;
    EXPECT_FALSE(isMask(particles));
}

TEST(MaskValues, AreNoFewHeightsAndNothingOfAUnit) {
    EXPECT_FALSE(isMask({0, 1, 1, 0}, "m"));
    EXPECT_FALSE(isMask({0, 1, 1, 0}, "V"));
    EXPECT_FALSE(isMask({0, 1, 2, 1, 0})) << "heights in whole steps";
    EXPECT_FALSE(isMask({0, 30, 30, 0})) << "a grating";
    EXPECT_FALSE(isMask({0, 0, 128, 255, 255})) << "a flat-topped grating of 8 bits";
    EXPECT_FALSE(isMask({-1, 0, 1, 0}));
    EXPECT_FALSE(isMask({0, 0, 0}));
    EXPECT_FALSE(isMask({1, 1, 1}));
    EXPECT_FALSE(isMask({NAN, NAN}));
}

TEST(MaskValues, AreNotedInNumbers) {
    StoredChannel stored = storedOf({0, 0, 0.5, 1});
    noteMask(stored);
    EXPECT_THAT(stored.channel.notes, ElementsAre("this is a mask, not heights: its values have no "
                                                  "unit, and 75 % of them are 0 or 1"));
}

TEST(MaskValues, ThatCannotBeReadAreRefusedByWhoReadsThem) {
    StoredChannel stored = storedOf({0, 1});
    stored.readRow = [](int, RowRoom&, double*) { throw InputError("scan", "row 0", "damaged"); };
    noteMask(stored);
    EXPECT_FALSE(stored.channel.isMask);
}

TEST(MaskValues, OfTheSamplesOnlyTheMaskHas) {
    for (const auto& entry : std::filesystem::directory_iterator(dataFolder() / "samples")) {
        if (entry.path().extension() == ".gsf") {
            EXPECT_EQ(ScanFile(entry.path()).contents().channels.front().isMask,
                      entry.path().filename() == "particle_mask.gsf")
                << entry.path();
        }
    }
}

TEST(MaskValues, NoRealScanHas) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const std::string& file : realScans()) {
        const ScanFile scan(sharedData("afm/" + file));
        for (const ScanChannel& channel : scan.contents().channels) {
            EXPECT_FALSE(channel.isMask) << file << ", " << channel.name;
        }
    }
}

TEST(MaskValues, AreMarkedWhateverTheFormatAndOpenAsHeightsOnlyWhenSaidSo) {
    const ScratchFolder folder;
    const HeightMap mask{.columns = 2,
                         .rows = 2,
                         .pitchX = 1e-9,
                         .pitchY = 1e-9,
                         .heights = {0.0, 1.0, 1.0, 1.0},
                         .invalid = {}};
    for (const char* name : {"mask.gsf", "mask.gwy", "mask.vti", "mask.exr", "mask.tiff"}) {
        const auto file = folder.file(name);
        writeHeightMap(file, mask, {.title = "Grains", .unit = ""});
        EXPECT_TRUE(ScanFile(file).contents().channels.front().isMask) << name;
        EXPECT_THAT(refusalOf([&] { (void)readSceneScan(file, ""); }),
                    HasSubstr("channel 'Grains': this is a mask, not heights"));
        const SceneScan scan = ScanFile(file, {.heightPerValue = 1e-9}).readSceneScan("");
        EXPECT_THAT(scan.notes, testing::Contains(HasSubstr("'Grains': this is a mask")));
    }
}

}  // namespace asperity::test
