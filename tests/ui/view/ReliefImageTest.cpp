#include "ui/view/ReliefImage.h"

#include "tests/ui/view/MapSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace asperity {
namespace {

ReliefImage reliefImage(const BSplineSurface& surface) {
    ReliefImage relief;
    relief.setSurface(surface);
    return relief;
}

TEST(ReliefImage, IsAtMost512PixelsAndCoversTheHeights) {
    const ReliefImage relief = reliefImage(test::wideSurface());
    EXPECT_EQ(relief.image().size(), QSize(512, 256));
    EXPECT_EQ(relief.heights().size(), 512U * 256U);
    EXPECT_NEAR(relief.colors().high, 10.0_nm, 0.1_nm);
    EXPECT_NEAR(relief.colors().low, 0.0, 0.1_nm);
}

TEST(ReliefImage, IsLitFromTheUpperLeft) {
    const BSplineSurface surface = fitSurface(test::hillyMap());
    const ReliefImage relief = reliefImage(surface);
    const auto lightness = [&](double x, double y) {
        const int column = static_cast<int>(x / surface.sizeX() * relief.image().width());
        const int row = static_cast<int>((1.0 - y / surface.sizeY()) * relief.image().height());
        return relief.image().pixelColor(column, row).lightness();
    };
    // A hill's flanks at equal height, on either side of its top at 15 nm, 15 nm.
    EXPECT_GT(lightness(8.0_nm, 22.0_nm), lightness(22.0_nm, 8.0_nm) + 20);
}

TEST(ReliefImage, TakesTheQuantityAndItsColors) {
    ReliefImage relief = reliefImage(test::wideSurface());
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Slope;
    look.of(SurfaceQuantity::Slope).map = ColorMap::Gray;
    relief.setLook(look, SurfaceField(SurfaceQuantity::Slope));
    EXPECT_EQ(relief.colors().quantity, QStringLiteral("slope"));
    const auto colorAt = [&relief](double x, double y) {
        return relief.image().pixelColor(static_cast<int>(2.0 * x / 1.0_nm),
                                         static_cast<int>(256.0 - 2.0 * y / 1.0_nm));
    };
    EXPECT_LT(colorAt(200.0_nm, 40.0_nm).lightness(), 10) << "level: black";
    EXPECT_EQ(colorAt(40.0_nm, 104.0_nm).saturation(), 0);
    EXPECT_GT(colorAt(40.0_nm, 104.0_nm).lightness(), 60) << "the hill's flank";
}

TEST(ReliefImage, ShowsHeightsForWhatChangesWithTheTip) {
    ReliefImage relief = reliefImage(test::wideSurface());
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Pressure;
    relief.setLook(look, SurfaceField(SurfaceQuantity::Pressure));
    EXPECT_EQ(relief.colors().quantity, QStringLiteral("height"));
}

/// On a flat scan, where nothing is shaded: what the bar says a pixel of the map has is its color,
/// a pixel without data is hatched, and beside the map it is plain.
TEST(ReliefImage, AMapOfAPartIsColoredAsItsBarSays) {
    ReliefImage relief = reliefImage(fitSurface(test::flatMap()));
    const float none = std::numeric_limits<float>::quiet_NaN();
    const auto region =
        std::make_shared<const RegionField>(RegionField::Area{0.0, 0.0, 64.0_nm, 128.0_nm}, 2, 2,
                                            std::vector<float>{1e-9F, 2e-9F, none, 3e-9F}, "N");
    SurfaceLook look;
    look.quantity = SurfaceQuantity::ForceMap;
    relief.setLook(look, SurfaceField(SurfaceQuantity::ForceMap, region, "adhesion force"));
    const auto colorAt = [&relief](double x, double y) {
        const double pixel = 128.0 / relief.image().width();
        return relief.image().pixelColor(static_cast<int>(x / pixel),
                                         static_cast<int>((128.0 - y) / pixel));
    };
    const ColorScale& bar = relief.colors();
    EXPECT_EQ(bar.quantity, QStringLiteral("adhesion force"));
    EXPECT_EQ(bar.unit, QStringLiteral("N"));
    EXPECT_FLOAT_EQ(static_cast<float>(bar.low), 1e-9F);
    EXPECT_FLOAT_EQ(static_cast<float>(bar.high), 3e-9F);
    EXPECT_EQ(colorAt(16, 96), bar.colors.front());
    EXPECT_EQ(colorAt(48, 32), bar.colors.back());
    EXPECT_TRUE(relief.hasGaps());
    for (const double x : {10.0, 12.0, 14.0, 16.0, 18.0}) {
        const QColor missing = colorAt(x, 32);
        EXPECT_LT(missing.saturation(), 3) << "gray";
        EXPECT_NE(missing, bar.colors.front()) << "the low end is no gray";
        EXPECT_NE(missing, colorAt(100, 32)) << "beside the map";
    }
    EXPECT_EQ(colorAt(100, 32), colorAt(100, 96));
    EXPECT_EQ(colorAt(100, 32), colorAt(77, 13)) << "no stripes";
}

TEST(ReliefImage, KeepsAPinnedRangeOverAnotherScan) {
    ReliefImage relief = reliefImage(test::wideSurface());
    SurfaceLook look;
    look.of(SurfaceQuantity::Height).pinned = true;
    relief.setLook(look, SurfaceField());
    const double high = relief.colors().high;
    relief.setSurface(fitSurface(test::slopedMap(0.5)));
    EXPECT_EQ(relief.colors().high, high);
    EXPECT_TRUE(relief.colors().clipsHigh()) << "and says so";
    look.of(SurfaceQuantity::Height).pinned = false;
    relief.setLook(look, SurfaceField());
    EXPECT_GT(relief.colors().high, 2.0 * high);
}

TEST(ReliefImage, ALevelScanHasOneColor) {
    const ReliefImage relief = reliefImage(fitSurface(test::flatMap()));
    EXPECT_EQ(relief.image().pixel(0, 0), relief.image().pixel(300, 200));
}

TEST(ReliefImage, IsGrayWhereTheScanHoldsNoData) {
    EXPECT_FALSE(reliefImage(fitSurface(test::hillyMap())).hasFilled());
    const ReliefImage relief = reliefImage(fitSurface(test::holedMap()));
    EXPECT_TRUE(relief.hasFilled());
    const auto colorfulness = [&](double x, double y) {
        const QColor color =
            relief.image().pixelColor(static_cast<int>(x * relief.image().width()),
                                      static_cast<int>(y * relief.image().height()));
        return std::max({color.red(), color.green(), color.blue()}) -
               std::min({color.red(), color.green(), color.blue()});
    };
    EXPECT_EQ(colorfulness(0.2, 0.5), 0);
    EXPECT_EQ(colorfulness(0.8, 0.01), 0) << "the rows without data lie at the top";
    EXPECT_GT(colorfulness(0.8, 0.5), 40);
    EXPECT_GT(colorfulness(0.8, 0.99), 40);
}

}  // namespace
}  // namespace asperity
