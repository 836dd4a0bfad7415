#include "core/Units.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/map/PixelCycle.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace asperity {
namespace {

using test::kSetpoint;

double strongestPullOf(const std::vector<PixelCurvePoint>& points) {
    return -std::ranges::min(points, {}, &PixelCurvePoint::force).force;
}

/// Area between the retract and zero force, over the base [J].
double pullingWork(const std::vector<PixelCurvePoint>& points) {
    double work = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double pull = std::max(0.0, -points[i - 1].force);
        const double next = std::max(0.0, -points[i].force);
        work += 0.5 * (pull + next) * (points[i].base - points[i - 1].base);
    }
    return work;
}

void expectSameValues(const MapValues& values, const MapValues& expected) {
    for (const MapQuantity quantity : kValues<MapQuantity>) {
        const bool isMissing = std::isnan(expected[quantity]);
        EXPECT_EQ(std::isnan(values[quantity]), isMissing) << keyOf(quantity);
        if (!isMissing) {
            EXPECT_EQ(values[quantity], expected[quantity]) << keyOf(quantity);
        }
    }
}

/// What is read off the curve is what the map has there, to the bit.
void expectCurveOfTheMap(const MapInstrument& instrument, const Vector2& position) {
    const PixelCurve curve = pixelCurve(instrument, position, kSetpoint);
    expectSameValues(curve.values, pixelCycle(instrument, position, kSetpoint));
    ASSERT_FALSE(curve.approach.empty());
    ASSERT_FALSE(curve.retract.empty());
    EXPECT_EQ(strongestPullOf(curve.retract), curve.values[MapQuantity::AdhesionForce]);
    if (!std::isnan(curve.values[MapQuantity::PullOffForce])) {
        ASSERT_TRUE(curve.pullOff);
        EXPECT_EQ(-curve.pullOff->force, curve.values[MapQuantity::PullOffForce]);
    }
    const double height = curve.values[MapQuantity::Height];
    EXPECT_EQ(curve.approach.back().tip, height);
    EXPECT_EQ(curve.retract.front().tip, height);
    EXPECT_NEAR(curve.approach.back().force, kSetpoint, 1e-9 * kSetpoint);
    EXPECT_NEAR(pullingWork(curve.retract), curve.values[MapQuantity::SeparationWork],
                0.05 * curve.values[MapQuantity::SeparationWork]);
}

TEST(PixelCurve, ShowsWhatTheMapHas) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    for (const bool truth : {false, true}) {
        const MapInstrument instrument(scene, truth);
        for (int i = 0; i < 12; ++i) {
            expectCurveOfTheMap(instrument,
                                Vector2((11.0 + 9.0 * i) * 1e-9, (97.0 - 7.0 * i) * 1e-9));
        }
    }
}

/// A lever that is soft beside the contact: long jumps.
TEST(PixelCurve, OfASoftLeverShowsWhatTheMapHas) {
    SceneDescription description = test::plainScene();
    description.probe.thickness = thicknessForStiffness(description.probe, 0.5);
    const Scene scene = buildScene(description, test::hillyMap());
    const MapInstrument instrument(scene, false);
    const Vector2 position(61.0_nm, 67.0_nm);
    expectCurveOfTheMap(instrument, position);
    const PixelCurve curve = pixelCurve(instrument, position, kSetpoint);
    ASSERT_TRUE(curve.snapIn && curve.pullOff);
    EXPECT_LT(curve.snapIn->base, curve.pullOff->base) << "hysteresis";
}

TEST(PixelCurve, GoesDownAndUp) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const PixelCurve curve = pixelCurve(MapInstrument(scene, false), {40.0_nm, 50.0_nm}, kSetpoint);
    EXPECT_TRUE(std::ranges::is_sorted(curve.approach, std::greater(), &PixelCurvePoint::base));
    EXPECT_TRUE(std::ranges::is_sorted(curve.retract, std::less(), &PixelCurvePoint::base));
    EXPECT_GE(curve.approach.front().base, curve.retract.back().base);
    for (const std::vector<PixelCurvePoint>& way : {curve.approach, curve.retract}) {
        for (const PixelCurvePoint& point : way) {
            EXPECT_TRUE(std::isfinite(point.tip) && std::isfinite(point.force));
        }
    }
}

/// On a flat scan it is the curve of the law, as `asperity curve` shows it.
TEST(PixelCurve, OnAFlatScanIsTheCurveOfTheLaw) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const PixelCurve curve = pixelCurve(MapInstrument(scene, false), {61.0_nm, 67.0_nm}, kSetpoint);
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    const auto snapIn = snapInOf(scene.belief.contact, compliance);
    ASSERT_TRUE(snapIn && curve.snapIn);
    EXPECT_NEAR(curve.snapIn->base, -snapIn->basePosition, 1e-9 * std::abs(snapIn->basePosition));
    EXPECT_NEAR(curve.snapIn->force, snapIn->before.force, 1e-9 * std::abs(snapIn->before.force));
    for (const PixelCurvePoint& point : curve.approach) {
        EXPECT_NEAR(point.tip, point.base + compliance * point.force, 1e-20);
    }
}

}  // namespace
}  // namespace asperity
