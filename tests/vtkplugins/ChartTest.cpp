#include "core/Error.h"
#include "core/Units.h"
#include "tests/vtkplugins/NeedsDisplay.h"
#include "tests/vtkplugins/PictureFixture.h"
#include "vtkplugins/pictures/Charts.h"
#include "vtkplugins/pictures/ShareMaps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

namespace {

using test::Image;
using test::kSize;

class Charts : public test::Pictures {};

TEST_F(Charts, ChartsShowEveryCurveAndItsPeak) {
    ASPERITY_NEEDS_DISPLAY();
    Curve spike{.label = "spike", .color = Color{255, 0, 0}};
    Curve wave{.label = "wave", .color = Color{0, 0, 255}, .dashed = true};
    for (int i = 0; i < 50000; ++i) {
        spike.x.push_back(i * 1e-3);
        spike.y.push_back(i == 31234 ? 10.0_nN : 0.0);
        wave.x.push_back(i * 1e-3);
        wave.y.push_back(2.0_nN * std::sin(i * 1e-3));
    }
    Chart chart{.title = "Force", .xLabel = "time", .yLabel = "force", .curves = {spike, wave}};
    chart.xUnit = "s";
    chart.yUnit = "N";
    const std::vector<Chart> page(4, chart);
    const Image image =
        drawn([&](const std::filesystem::path& path) { writeCharts(path, page, 2, kSize); });
    // The spike is one sample wide; in each chart it must be a line of most of the plot's height.
    std::array<int, 2> redRows{};
    for (int y = 0; y < kSize.height; ++y) {
        for (int half = 0; half < 2; ++half) {
            bool red = false;
            for (int x = half * kSize.width / 2; x < (half + 1) * kSize.width / 2; ++x) {
                const auto rgb = image.at(x, y);
                red = red || (rgb[0] > 200 && rgb[1] < 150 && rgb[2] < 150);
            }
            redRows.at(static_cast<std::size_t>(half)) += red ? 1 : 0;
        }
    }
    EXPECT_GT(redRows[0], kSize.height / 3);
    EXPECT_GT(redRows[1], kSize.height / 3);
    EXPECT_GT(image.count([](const auto& rgb) { return rgb[2] > 200 && rgb[0] < 100; }), 500);
}

TEST_F(Charts, ShowValuesFarFromZero) {
    ASPERITY_NEEDS_DISPLAY();
    const auto redOf = [&](double from, double step) {
        Curve line{.label = {}, .x = {}, .y = {}, .color = Color{255, 0, 0}};
        for (int i = 0; i <= 20; ++i) {
            line.x.push_back(from + step * i);
            line.y.push_back(from + step * i);
        }
        const Chart chart{.title = "", .xLabel = "x", .yLabel = "y", .curves = {line}};
        return drawn([&](const std::filesystem::path& path) {
                   writeCharts(path, std::array{chart}, 1, kSize);
               })
            .count([](const auto& rgb) { return rgb[0] > 200 && rgb[1] < 100; });
    };
    const int near = redOf(1.0, 1.0);
    EXPECT_GT(near, 500);
    EXPECT_NEAR(redOf(1000.0, 0.1), near, 0.2 * near);
    EXPECT_NEAR(redOf(-1e6, 0.1), near, 0.2 * near);
}

TEST_F(Charts, ScatterOnLogarithmicAxesHasNamedDots) {
    ASPERITY_NEEDS_DISPLAY();
    Curve dots{.label = "tiers", .x = {1e-7, 1e-5, 1e-2, 0.0}, .y = {40.0, 3.0, 0.2, 1.0}};
    dots.points = true;
    Chart chart{.title = "Cost", .xLabel = "time", .yLabel = "error [%]", .curves = {dots}};
    chart.xUnit = "s";
    chart.logX = true;
    chart.logY = true;
    const Image bare = drawn(
        [&](const std::filesystem::path& path) { writeCharts(path, std::array{chart}, 1, kSize); });
    chart.curves[0].pointLabels = {"Hertz", "Maugis", "half space", "nowhere"};
    const Image named = drawn(
        [&](const std::filesystem::path& path) { writeCharts(path, std::array{chart}, 1, kSize); });
    const auto isInk = [](const auto& rgb) { return rgb[0] < 120 && rgb[1] < 120; };
    EXPECT_GT(named.count(isInk), bare.count(isInk) + 200);
}

TEST_F(Charts, ShareMapsDivideTheirCellsAsTheSharesSay) {
    ASPERITY_NEEDS_DISPLAY();
    const std::filesystem::path path = folder / "maps.png";
    const Color first{0, 158, 115};
    const Color second{213, 94, 0};
    const ShareMap map{.title = "A law",
                       .xLabel = "tip radius",
                       .yLabel = "modulus",
                       .columns = {"1 nm", "10 nm"},
                       .rows = {"1 kPa"},
                       .cells = {{3.0, 1.0}, {}}};
    writeShareMaps(
        path, {.title = "Maps", .keys = {{first, "good"}, {second, "bad"}}, .maps = {map}}, kSize);
    const Image image(path);
    const auto counts = [&](const Color& color) {
        return image.count([&](const auto& rgb) {
            return rgb == std::array<int, 3>{color.red, color.green, color.blue};
        });
    };
    EXPECT_NEAR(static_cast<double>(counts(first)) / counts(second), 3.0, 0.05);
    EXPECT_LT(counts(first) + counts(second), kSize.width * kSize.height / 2) << "an empty cell";
    ShareMap uneven = map;
    uneven.cells.pop_back();
    EXPECT_THROW(writeShareMaps(path, {.maps = {uneven}}, kSize), Error);
    EXPECT_THROW(writeShareMaps(path, {}, kSize), Error);
}

}  // namespace
}  // namespace asperity
