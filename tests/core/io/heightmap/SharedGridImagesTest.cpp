#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/exr/ExrWriter.h"
#include "core/io/heightmap/vti/VtiWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Several images of the same pixels in one .vti or .exr.

namespace asperity::test {

namespace {

/// Lengths without data at two pixels, and forces.
struct SameGrid {
    HeightMap lengths = bumpyMapWithHoles(7, 4);
    HeightMap forces = bumpyMap(7, 4);
    std::vector<WrittenImage> all = {
        {rowsOf(lengths), {.title = "snap_in_distance", .metadata = {{"setpoint", "5 nN"}}}},
        {rowsOf(forces), {.title = "pull_off_force", .unit = "N"}}};
};

const ScanChannel& channelNamed(const HeightMapFile& file, const std::string& name) {
    const auto found = std::ranges::find(file.channels, name, &ScanChannel::name);
    EXPECT_NE(found, file.channels.end()) << name;
    return *found;
}

void expectSame(const HeightMapFile& file, const SameGrid& images, double tolerance) {
    ASSERT_EQ(file.channels.size(), 2U);
    const ScanChannel& lengths = channelNamed(file, "snap_in_distance");
    const ScanChannel& forces = channelNamed(file, "pull_off_force");
    EXPECT_EQ(lengths.unit, "m");
    EXPECT_EQ(forces.unit, "N");
    EXPECT_EQ(lengths.lateralUnit, "m");
    EXPECT_NEAR(forces.map.pitchX, images.forces.pitchX, 1e-12 * images.forces.pitchX);
    EXPECT_EQ(lengths.map.invalid, images.lengths.invalid);
    for (std::size_t i = 0; i < images.forces.heights.size(); ++i) {
        const double expected = images.forces.heights[i];
        EXPECT_NEAR(forces.map.heights[i], expected, tolerance * std::abs(expected));
    }
    EXPECT_EQ(lengths.metadata.at("setpoint"), "5 nN");
}

}  // namespace

TEST(SharedGridImages, ComeBackFromVtiWithNamesAndUnits) {
    const ScratchFolder folder;
    const SameGrid images;
    writeVtiImages(folder.file("map.vti"), images.all, nullptr);
    expectSame(readHeightMapFile(folder.file("map.vti"), {}), images, 0.0);
}

TEST(SharedGridImages, ComeBackFromExrWithNamesAndUnits) {
    const ScratchFolder folder;
    const SameGrid images;
    writeExrImages(folder.file("map.exr"), images.all, nullptr);
    expectSame(readHeightMapFile(folder.file("map.exr"), {}), images, 1e-7);
}

TEST(SharedGridImages, OneAloneHasItsNameToo) {
    const ScratchFolder folder;
    const SameGrid images;
    writeVtiImages(folder.file("map.vti"), {&images.all[1], 1}, nullptr);
    writeExrImages(folder.file("map.exr"), {&images.all[1], 1}, nullptr);
    for (const char* name : {"map.vti", "map.exr"}) {
        const HeightMapFile file = readHeightMapFile(folder.file(name), {});
        ASSERT_EQ(file.channels.size(), 1U);
        EXPECT_EQ(channelNamed(file, "pull_off_force").unit, "N");
    }
}

}  // namespace asperity::test
