#include "core/deformation/SurfaceField.h"

#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

double valueAt(const SurfaceField& field, const BSplineSurface& surface, double x, double y) {
    const HeightSample sample = surface.at(x, y);
    return field.at({x, y, sample.height}, sample.normal());
}

TEST(SurfaceField, SlopeOfAPlaneIsItsAngleWhateverItsDirection) {
    const SurfaceField slope(SurfaceQuantity::Slope);
    EXPECT_EQ(slope.unit(), "rad");
    const BSplineSurface plane = fitSurface(test::slopedMap(0.75));
    EXPECT_NEAR(valueAt(slope, plane, 50.0_nm, 80.0_nm), std::atan(0.75), 1e-9);
    EXPECT_EQ(valueAt(slope, fitSurface(test::flatMap()), 50.0_nm, 80.0_nm), 0.0);
    EXPECT_NEAR(slope.at(Vector3::Zero(), Vector3(-0.6, -0.8, 1.0).normalized()), std::atan(1.0),
                1e-12);
}

TEST(SurfaceField, HeightIsThatOfThePlace) {
    const BSplineSurface hills = fitSurface(test::hillyMap());
    EXPECT_EQ(valueAt(SurfaceField(), hills, 33.0_nm, 21.0_nm), hills.at(33.0_nm, 21.0_nm).height);
    EXPECT_EQ(SurfaceField().unit(), "m");
}

TEST(SurfaceField, OfAQuantityThatChangesWithTheTipIsWhatItIsFarFromIt) {
    const Vector3 up = Vector3::UnitZ();
    EXPECT_EQ(SurfaceField(SurfaceQuantity::Pressure).at(up, up), 0.0);
    EXPECT_EQ(SurfaceField(SurfaceQuantity::Displacement).at(up, up), 0.0);
    EXPECT_TRUE(std::isnan(SurfaceField(SurfaceQuantity::Gap).at(up, up)));
    EXPECT_TRUE(SurfaceField(SurfaceQuantity::Gap).isLive());
    EXPECT_FALSE(SurfaceField(SurfaceQuantity::Slope).isLive());
}

TEST(SurfaceField, CertaintyIsThatOfTheMap) {
    const HeightMap map = test::flatMap();
    std::vector<std::uint8_t> certain(map.heights.size(), 1);
    certain[map.index(0, 0)] = 0;
    const CertaintyMap known(map, certain);
    const SurfaceField field(known);
    EXPECT_EQ(field.at({1.0_nm, 127.0_nm, 0.0}, Vector3::UnitZ()), 0.0);
    EXPECT_EQ(field.at({64.0_nm, 64.0_nm, 0.0}, Vector3::UnitZ()), 1.0);
    const CertaintyMap none;
    EXPECT_TRUE(std::isnan(SurfaceField(none).at(Vector3::Zero(), Vector3::UnitZ())));
}

TEST(SurfaceField, ChannelHasItsOwnNameUnitAndValues) {
    HeightMap map = test::flatMap();
    map.heights.assign(map.heights.size(), 0.25);
    const auto pixels = std::make_shared<const PixelField>(map, "V");
    const SurfaceField field(SurfaceQuantity::Channel, pixels, "Phase");
    EXPECT_EQ(field.name(), "Phase");
    EXPECT_EQ(field.unit(), "V");
    EXPECT_EQ(field.at({64.0_nm, 64.0_nm, 3.0}, Vector3::UnitZ()), 0.25);
}

TEST(SurfaceField, OfARegionCoversThatAlone) {
    const Vector3 up = Vector3::UnitZ();
    const float none = std::numeric_limits<float>::quiet_NaN();
    const auto region =
        std::make_shared<const RegionField>(RegionField::Area{20.0_nm, 20.0_nm, 40.0_nm, 20.0_nm},
                                            2, 1, std::vector<float>{3.0F, none}, "N");
    const SurfaceField field(SurfaceQuantity::ForceMap, region, "adhesion force");
    EXPECT_EQ(field.name(), "adhesion force");
    EXPECT_EQ(field.unit(), "N");
    EXPECT_TRUE(field.hasGaps());
    EXPECT_EQ(field.at({30.0_nm, 30.0_nm, 5.0}, up), 3.0);
    EXPECT_TRUE(std::isnan(field.at({50.0_nm, 30.0_nm, 5.0}, up)));
    EXPECT_TRUE(field.covers({50.0_nm, 30.0_nm, 5.0}));
    EXPECT_TRUE(std::isnan(field.at({70.0_nm, 30.0_nm, 5.0}, up)));
    EXPECT_FALSE(field.covers({70.0_nm, 30.0_nm, 5.0}));
    EXPECT_TRUE(SurfaceField().covers({70.0_nm, 30.0_nm, 5.0}));
}

TEST(SurfaceFieldRange, LeavesOutTheShareAtBothEnds) {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) {
        values.push_back((i * 389) % 1001);  // 0 .. 1000, mixed
    }
    EXPECT_EQ(rangeOf(values).low, 0.0);
    EXPECT_EQ(rangeOf(values).high, 1000.0);
    EXPECT_EQ(rangeOf(values, 0.01).low, 10.0);
    EXPECT_EQ(rangeOf(values, 0.01).high, 990.0);
    EXPECT_EQ(rangeOf(values, 0.001).low, 1.0);
    EXPECT_EQ(rangeOf(values, 0.001).high, 999.0);
    values.push_back(std::numeric_limits<double>::quiet_NaN());
    values.push_back(-std::numeric_limits<double>::infinity());
    EXPECT_EQ(rangeOf(values).low, 0.0);
    EXPECT_EQ(rangeOf({}).high, 0.0);
}

}  // namespace
}  // namespace asperity
