#include "core/io/loading/SceneOnSample.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;

/// A scan of 6 x 4 pixels of 2 nm, and a map of its modulus: half of it 1 GPa, half 3 GPa.
class SceneOnSampleTest : public testing::Test {
protected:
    SceneOnSampleTest() {
        writeHeightMap(scratch.file("scan.gsf"), ramp(6, 4), {});
        description.sample.file = scratch.file("scan.gsf").string();
    }

    static HeightMap ramp(int columns, int rows) {
        HeightMap map{.columns = columns,
                      .rows = rows,
                      .pitchX = 2e-9,
                      .pitchY = 2e-9,
                      .heights = {},
                      .invalid = {}};
        for (int i = 0; i < columns * rows; ++i) {
            map.heights.push_back(1e-10 * (i % columns));
        }
        return map;
    }

    /// @param content of a Gwyddion Simple Field of two pixels beside one another
    void putModulus(double width, double height) {
        std::string text = "Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 1\nXReal = " +
                           std::to_string(width * 1e9) +
                           "e-9\nYReal = " + std::to_string(height * 1e9) +
                           "e-9\nXYUnits = m\nZUnits = Pa\n";
        text.append(4 - text.size() % 4, '\0');
        for (const float value : {1e9F, 3e9F}) {
            text.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
        description.sample.material.maps.youngsModulus = MapSource{
            .file = scratch.write("modulus.gsf", text).string(), .channel = "", .sha256 = ""};
    }

    test::ScratchFolder scratch;
    SceneDescription description = test::plainScene();
};

TEST_F(SceneOnSampleTest, NamesWhatWasTaken) {
    description.sample.file =
        (scratch.path() / "." / "scan.gsf").string();  // as somebody may write it
    description.sample.crop = PixelRectangle{0, 0, 6, 4};
    const SceneOnSample result = sceneOnSample(description);
    const SampleDescription& sample = result.scene.description.sample;
    EXPECT_EQ(sample.file, scratch.file("scan.gsf").string());
    EXPECT_EQ(sample.channel, result.file->contents().channels.at(0).name);
    EXPECT_FALSE(sample.crop) << "all of the channel";
    EXPECT_EQ(result.scene.surface.grid().columns, 6);
    EXPECT_EQ(result.filledPixels, 0U);
}

TEST_F(SceneOnSampleTest, MapsOfItsMaterialLieOverTheScanOrItsPart) {
    putModulus(12e-9, 8e-9);
    EXPECT_EQ(sceneOnSample(description).scene.maps.sample.youngsModulus->columns(), 2);
    description.sample.crop = PixelRectangle{1, 1, 4, 3};
    EXPECT_THAT(test::refusalOf([&] { (void)sceneOnSample(description); }),
                HasSubstr("the scan's 6 x 4 pixels"));
    putModulus(8e-9, 6e-9);
    const SceneOnSample part = sceneOnSample(description);
    EXPECT_EQ(part.scene.surface.grid().columns, 4);
    EXPECT_EQ(part.originX, 2e-9);
    EXPECT_EQ(part.scene.description.sample.material.maps.youngsModulus->sha256.size(), 64U);
}

TEST_F(SceneOnSampleTest, OfAShapeHasNoFile) {
    description.sample.shape = ShapeDescription{};
    const SceneOnSample result = sceneOnSample(description);
    EXPECT_EQ(result.file, nullptr);
    EXPECT_EQ(result.format, "shape");
    EXPECT_TRUE(result.scene.shape);
}

TEST_F(SceneOnSampleTest, OtherHeightsAreTakenWhole) {
    putModulus(16e-9, 4e-9);
    description.sample.crop = PixelRectangle{1, 1, 4, 3};
    const Scene scene = sceneOnHeights(description, ramp(8, 2));
    EXPECT_EQ(scene.surface.grid().columns, 8);
    EXPECT_FALSE(scene.description.sample.crop);
    EXPECT_NE(scene.maps.sample.youngsModulus, nullptr);
    description.sample.shape = ShapeDescription{};
    EXPECT_THROW((void)sceneOnHeights(description, ramp(8, 2)), Error);
}

}  // namespace
}  // namespace asperity
