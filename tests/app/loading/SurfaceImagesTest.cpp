#include "app/loading/SceneLoader.h"
#include "core/Error.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

constexpr int kPixels = 32;

/// An image of a Gwyddion file: value(row, column).
template <class Value>
std::string image(int number, const char* title, const char* unit, int pixels, const Value& value) {
    const std::string key = "/" + std::to_string(number) + "/data";
    std::vector<double> values;
    for (int row = 0; row < pixels; ++row) {
        for (int column = 0; column < pixels; ++column) {
            values.push_back(value(row, column));
        }
    }
    const std::string field =
        gwyObjectBytes("GwyDataField", gwyInteger("xres", pixels) + gwyInteger("yres", pixels) +
                                           gwyNumber("xreal", 64e-9) + gwyNumber("yreal", 64e-9) +
                                           gwyUnit("si_unit_xy", "m") + gwyUnit("si_unit_z", unit) +
                                           gwyNumbers("data", values));
    return gwyComponent(key, field) + gwyText(key + "/title", title);
}

double roughness(int row, int column) { return 1e-9 * ((row * 7 + column * 13) % 5); }

std::filesystem::path scanIn(ScratchFolder& folder) {
    return folder.write("three.gwy",
                        gwyFile(image(0, "Height", "m", kPixels, roughness) +
                                image(1, "Phase", "V", kPixels,
                                      [](int row, int column) { return row + 0.01 * column; }) +
                                image(2, "Small", "V", 16, [](int, int) { return 1.0; })));
}

TEST(SurfaceImages, AreThoseWithThePixelsOfTheScan) {
    ScratchFolder folder;
    const LoadedScene loaded = loadScene(scanIn(folder), {.channel = "Height"});
    EXPECT_EQ(loaded.images, std::vector<std::string>{"Phase"});
}

TEST(SurfaceImages, AnotherImageLiesOverTheScanPixelByPixel) {
    ScratchFolder folder;
    const LoadedScene loaded = loadScene(scanIn(folder), {.channel = "Height"});
    const PixelField phase =
        imageBeside(loaded.scene.description.sample, loaded.scene.surface, "Phase");
    EXPECT_EQ(phase.unit(), "V");
    EXPECT_NEAR(phase.at(1e-9, 63e-9), 0.0, 1e-6) << "the top left pixel";
    EXPECT_NEAR(phase.at(5e-9, 63e-9), 0.02, 1e-6);
    EXPECT_NEAR(phase.at(1e-9, 1e-9), 31.0, 1e-6) << "the bottom row";
    EXPECT_THROW((void)imageBeside(loaded.scene.description.sample, loaded.scene.surface, "Small"),
                 Error);
    EXPECT_THROW((void)imageBeside(loaded.scene.description.sample, loaded.scene.surface, "None"),
                 Error);
}

TEST(SurfaceImages, TheResidualIsWhatSmoothingLeftOut) {
    ScratchFolder folder;
    const std::filesystem::path file = scanIn(folder);
    const LoadedScene exact =
        loadScene(file, {.channel = "Height", .leveling = LevelingSteps{}, .smoothingPixels = 0.0});
    const LoadedScene smooth =
        loadScene(file, {.channel = "Height", .leveling = LevelingSteps{}, .smoothingPixels = 1.0});
    const PixelField none = residualImage(exact.scene.description.sample, exact.scene.surface);
    const PixelField some = residualImage(smooth.scene.description.sample, smooth.scene.surface);
    EXPECT_EQ(some.unit(), "m");
    double largest = 0.0;
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            const double x = (column + 0.5) * 2e-9;
            const double y = (kPixels - row - 0.5) * 2e-9;
            EXPECT_NEAR(none.at(x, y), 0.0, 1e-14);
            EXPECT_NEAR(some.at(x, y),
                        roughness(row, column) - smooth.scene.surface.at(x, y).height, 1e-15);
            largest = std::max(largest, std::abs(some.at(x, y)));
        }
    }
    EXPECT_GT(largest, 1e-9);
}

}  // namespace
}  // namespace asperity::test
