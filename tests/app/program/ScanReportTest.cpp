#include "app/loading/SceneLoader.h"
#include "app/program/LoadedScene.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity::test {
namespace {

using testing::HasSubstr;

TEST(ScanReport, TellsWhereTheScanComesFromAndWhatWasDoneToIt) {
    ScratchFolder folder;
    const std::filesystem::path scan = folder.file("scan.gwy");
    writeHeightMap(scan, bumpyMapWithHoles(40, 30), {.title = "Topography"});
    const LoadedScene loaded = loadScene(scan, {.leveling = LevelingSteps{LevelingStep::Rows},
                                                .crop = PixelRectangle{0, 0, 20, 10}});
    const std::string report = scanReport(loaded);
    for (const std::string& words :
         {"File: " + scan.string(), std::string("Format: Gwyddion .gwy"),
          "SHA-256: " + loaded.sha256, std::string("Channel: Topography"),
          std::string("Pixels: 20 x 10"), std::string("Size: 60 nm x 50 nm"),
          std::string("Pixel: 3 nm x 5 nm"), std::string("without data, filled in: 2"),
          std::string("crop: 20 x 10 pixels from column 0, row 0"), std::string("median"),
          std::string("imaging tip"), std::string("Where the numbers come from")}) {
        EXPECT_THAT(report, HasSubstr(words));
    }
    for (const std::string& note : notesOn(loaded)) {
        EXPECT_THAT(report, HasSubstr(note));
    }
}

TEST(ScanReport, OfAShapeNamesNoFile) {
    ScratchFolder folder;
    const auto scene = folder.write("sphere.toml", "[sample]\nshape = \"sphere\"\n");
    const std::string report = scanReport(loadScene(scene, {}));
    EXPECT_THAT(report, HasSubstr("an exact shape"));
    EXPECT_THAT(report, testing::Not(HasSubstr("SHA-256")));
}

}  // namespace
}  // namespace asperity::test
