#include "ui/view/OffscreenZoom.h"

#include "core/Error.h"
#include "core/Units.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ViewMoments.h"
#include "ui/widgets/Theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asperity::test {
namespace {

using Pixel = std::array<int, 4>;

Pixel pixelAt(const RasterImage& image, int column, int row) {
    const std::uint8_t* at = image.row(row) + static_cast<std::ptrdiff_t>(4) * column;
    return {at[0], at[1], at[2], at[3]};
}

Pixel pixelOf(const Color& color) { return {color.red, color.green, color.blue, 255}; }

OffscreenZoomLook smallLook() {
    return {.size = {.width = 480, .height = 360}, .look = {}, .parts = {}};
}

class OffscreenZoomTest : public ::testing::Test {
protected:
    const Scene scene = flatScene();
    const TickSample deep = momentsOf(scene).deep.sample;
};

TEST_F(OffscreenZoomTest, HasTheSizeThatIsAskedFor) {
    for (const PictureSize size : {PictureSize{480, 360}, {300, 200}, {901, 703}}) {
        OffscreenZoomLook look = smallLook();
        look.size = size;
        const RasterImage image = OffscreenZoom(scene, look).draw(deep, "caption");
        EXPECT_EQ(image.width, size.width);
        EXPECT_EQ(image.height, size.height);
        EXPECT_EQ(image.pixels.size(), image.rowBytes() * static_cast<std::size_t>(size.height));
    }
}

TEST_F(OffscreenZoomTest, HasColorBarsBelowSmallLetters) {
    OffscreenZoomLook look = smallLook();
    look.size = {.width = 700, .height = 440};
    look.look.pixelRatio = 0.5;
    const RasterImage image = OffscreenZoom(scene, look).draw(deep, {});
    EXPECT_EQ(image.height, 440);
    EXPECT_EQ(pixelAt(image, 2, 437), pixelOf(kLightPalette.paper));
}

TEST_F(OffscreenZoomTest, ATinyOneIsAllViewAndTooSmallOrLargeOnesAreNamed) {
    for (const PictureSize size : {PictureSize{32, 32}, {64, 40}, {200, 63}}) {
        OffscreenZoomLook look = smallLook();
        look.size = size;
        look.look.pixelRatio = 0.05;
        EXPECT_EQ(OffscreenZoom(scene, look).draw(deep, {}).height, size.height);
    }
    OffscreenZoomLook look = smallLook();
    look.size = {.width = 8193, .height = 40};
    try {
        const OffscreenZoom zoom(scene, look);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("8193 x 40 pixels"), std::string::npos)
            << error.what();
    }
}

TEST_F(OffscreenZoomTest, IsLightInADarkWindow) {
    theme::choose(ThemeChoice::Light);
    const RasterImage light = OffscreenZoom(scene, smallLook()).draw(deep, "caption");
    theme::choose(ThemeChoice::Dark);
    const RasterImage dark = OffscreenZoom(scene, smallLook()).draw(deep, "caption");
    EXPECT_TRUE(theme::isDark());
    EXPECT_EQ(theme::colors().paper, toQColor(kDarkPalette.paper));
    theme::choose(ThemeChoice::Light);
    EXPECT_EQ(pixelAt(dark, 470, 5), pixelOf(kLightPalette.backdrop));
    EXPECT_EQ(light.pixels, dark.pixels);
}

TEST_F(OffscreenZoomTest, HasNothingBehindWhereThatIsAskedFor) {
    OffscreenZoomLook look = smallLook();
    look.parts = {.bars = false, .labels = false, .grid = false};
    const RasterImage opaque = OffscreenZoom(scene, look).draw(deep, {});
    look.look.transparent = true;
    const RasterImage clear = OffscreenZoom(scene, look).draw(deep, {});
    EXPECT_EQ(pixelAt(clear, 470, 5), (Pixel{0, 0, 0, 0}));
    // Where all is drawn over, the colors are the same.
    EXPECT_EQ(pixelAt(clear, 240, 300), pixelAt(opaque, 240, 300));
    EXPECT_EQ(pixelAt(clear, 240, 300)[3], 255);
}

TEST_F(OffscreenZoomTest, IsColoredByTheQuantityThatIsAskedFor) {
    OffscreenZoomLook look = smallLook();
    const std::vector<std::uint8_t> usual = OffscreenZoom(scene, look).draw(deep, {}).pixels;
    look.color = SurfaceQuantity::Height;
    EXPECT_EQ(OffscreenZoom(scene, look).draw(deep, {}).pixels, usual);
    look.color = SurfaceQuantity::Displacement;
    const RasterImage dent = OffscreenZoom(scene, look).draw(deep, {});
    EXPECT_NE(dent.pixels, usual);
    EXPECT_NE(pixelAt(dent, 2, 359 - 70), pixelOf(kLightPalette.paper)) << "one row of bars";
}

/// The tip fades away below the upper edge instead of being cut by it.
TEST_F(OffscreenZoomTest, NoTipIsCutByTheUpperEdge) {
    const ViewMoments moments = momentsOf(scene);
    const auto isEmpty = [](const RasterImage& image, int row) {
        for (int column = 0; column < image.width; ++column) {
            if (pixelAt(image, column, row) != pixelAt(image, 0, row)) {
                return false;
            }
        }
        return true;
    };
    for (const PictureSize size : {PictureSize{640, 400}, {640, 360}, {300, 500}, {700, 240}}) {
        for (const double higher : {0.0, 10.0_nm, 30.0_nm}) {
            for (const Snapshot& moment : {moments.away, moments.deep, moments.neck}) {
                OffscreenZoomLook look = smallLook();
                look.size = size;
                look.parts = {.bars = false, .labels = false};
                const Snapshot shown = movedBy(moment, higher * Vector3::UnitZ());
                const RasterImage image = OffscreenZoom(scene, look).draw(shown.sample, {});
                EXPECT_TRUE(isEmpty(image, 0)) << size.width << " " << higher;
                EXPECT_TRUE(isEmpty(image, 1)) << size.width << " " << higher;
            }
        }
    }
}

TEST_F(OffscreenZoomTest, LeavesOutBarsLabelsAndGrid) {
    const std::vector<std::uint8_t> all = OffscreenZoom(scene, smallLook()).draw(deep, "a").pixels;
    for (const PictureParts parts :
         {PictureParts{.bars = false}, {.labels = false}, {.surfaceGrid = true}}) {
        OffscreenZoomLook look = smallLook();
        look.parts = parts;
        EXPECT_NE(OffscreenZoom(scene, look).draw(deep, "a").pixels, all);
    }
    OffscreenZoomLook look = smallLook();
    look.parts.labels = false;
    EXPECT_EQ(OffscreenZoom(scene, look).draw(deep, "a").pixels,
              OffscreenZoom(scene, look).draw(deep, "b").pixels);
}

TEST_F(OffscreenZoomTest, IsAsWideAsAskedForOrRefuses) {
    OffscreenZoomLook look = smallLook();
    std::vector<double> scales;
    for (const double width : {40e-9, 80e-9}) {
        look.width = width;
        OffscreenZoom zoom(scene, look);
        (void)zoom.draw(deep, {});
        scales.push_back(zoom.metersPerPixel());
    }
    EXPECT_GT(scales[1], 1.3 * scales[0]);
    look.width = 1.0;
    EXPECT_THROW(OffscreenZoom(scene, look), Error);
    look.width = 1e-12;
    EXPECT_THROW(OffscreenZoom(scene, look), Error);
}

/// The same part of the scene has the same size in pixels at any resolution.
TEST_F(OffscreenZoomTest, ShowsTheSameAtAnyResolution) {
    OffscreenZoomLook look = smallLook();
    OffscreenZoom coarse(scene, look);
    (void)coarse.draw(deep, {});
    look.size = {.width = 1440, .height = 1080};
    look.look.pixelRatio = 3.0;
    OffscreenZoom fine(scene, look);
    (void)fine.draw(deep, {});
    EXPECT_NEAR(coarse.metersPerPixel(), fine.metersPerPixel(), 1e-3 * coarse.metersPerPixel());
}

/// A tip that goes over hills and out of the frame, in contact and without.
TEST(OffscreenZoomFilm, HasOneScaleThrough) {
    const Scene scene = hillyScene();
    const ViewMoments moments = momentsOf(scene);
    std::vector<TickSample> frames;
    for (const double way : {0.0, 10e-9, 20e-9, 30e-9, 20e-9, 0.0, -25e-9}) {
        for (const Snapshot& moment : {moments.away, moments.deep}) {
            frames.push_back(movedBy(moment, {way, 0.4 * way, 0.0}).sample);
        }
    }
    OffscreenZoomLook look = smallLook();
    look.width = 40e-9;
    OffscreenZoom zoom(scene, look);
    for (const TickSample& frame : frames) {
        zoom.foresee(frame);
    }
    zoom.keepScales();
    std::vector<double> scales;
    std::vector<std::uint8_t> bars;
    for (const TickSample& frame : frames) {
        const RasterImage image = zoom.draw(frame, {});
        scales.push_back(zoom.metersPerPixel());
        const std::vector<std::uint8_t> below(image.row(image.height - 60),
                                              image.row(image.height - 1));
        EXPECT_TRUE(bars.empty() || below == bars);
        bars = below;
    }
    EXPECT_EQ(*std::ranges::min_element(scales), *std::ranges::max_element(scales));
}

}  // namespace
}  // namespace asperity::test
