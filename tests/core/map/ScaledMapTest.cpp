#include "core/contact/laws/ForceCurve.h"
#include "core/map/PixelCycle.h"
#include "tests/support/ScaledScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {
namespace {

using test::ScaledScene;

constexpr double kTolerance = 1e-3;

/// By which power of the scale a quantity grows.
int powerOf(const MapQuantityRow& quantity) {
    const std::string_view unit = quantity.unit;
    if (unit == "J") {
        return 3;
    }
    if (unit == "N") {
        return 2;
    }
    return unit == "m" || unit == "N/m" ? 1 : 0;
}

/// What a difference of a quantity is measured by where it is near zero itself.
double yardstickOf(const MapQuantityRow& quantity, const ScaledScene& scene) {
    switch (powerOf(quantity)) {
    case 3:
        return scene.description.setpoint * scene.reach;
    case 2:
        return scene.description.setpoint;
    case 1:
        return quantity.value == MapQuantity::Stiffness ? 0.0 : 0.1 * scene.reach;
    default:
        return 0.0;
    }
}

void expectSame(const MapValues& usual, const MapValues& other, const ScaledScene& scene,
                double scale, MapMode mode) {
    for (const MapQuantityRow& quantity : kEnumTable<MapQuantity>) {
        if (!hasQuantity(mode, quantity) || quantity.value == MapQuantity::Iterations ||
            quantity.value == MapQuantity::Validity) {
            continue;
        }
        const double expected = usual[quantity.value];
        const double value = other[quantity.value] / std::pow(scale, powerOf(quantity));
        EXPECT_EQ(std::isnan(value), std::isnan(expected)) << quantity.key;
        if (!std::isnan(expected)) {
            const double size = std::max(std::abs(expected), yardstickOf(quantity, scene));
            EXPECT_NEAR(value, expected, kTolerance * size) << quantity.key;
        }
    }
}

MapValues cycleOf(const ScaledScene& scene) {
    const Scene built = buildScene(scene.description, scene.map);
    return pixelCycle(MapInstrument(built, false), scene.position, scene.description.setpoint);
}

TEST(ScaledMap, HasTheSameCycleAtEveryScale) {
    for (const ScaledScene& scene : test::scenesWithoutLengths()) {
        const MapValues usual = cycleOf(scene);
        for (const double scale : {0.125, 0.5, 2.0, 8.0, 64.0}) {
            SCOPED_TRACE(scene.name + ", scale " + std::to_string(scale));
            expectSame(usual, cycleOf(test::scaled(scene, scale)), scene, scale, MapMode::Approach);
        }
    }
}

/// What `asperity curve` prints.
TEST(ScaledMap, HasTheSameCurveOfTheLawAtEveryScale) {
    const auto curveOf = [](const ScaledScene& scene) {
        const Scene built = buildScene(scene.description, scene.map);
        const double compliance = built.belief.cantilever.compliance()(2, 2);
        return forceCurve(built.belief.contact, compliance,
                          curvePlan(built.belief.contact, compliance));
    };
    for (const ScaledScene& scene : test::scenesWithoutLengths()) {
        const ForceCurve usual = curveOf(scene);
        for (const double scale : {0.125, 64.0}) {
            SCOPED_TRACE(scene.name + ", scale " + std::to_string(scale));
            const ForceCurve other = curveOf(test::scaled(scene, scale));
            ASSERT_EQ(other.approach.size(), usual.approach.size());
            const double largest = std::abs(usual.approach.back().state.force);
            for (std::size_t i = 0; i < usual.approach.size(); ++i) {
                ASSERT_NEAR(other.approach[i].state.force / (scale * scale),
                            usual.approach[i].state.force, 1e-6 * largest)
                    << i;
            }
            ASSERT_EQ(other.pullOff.has_value(), usual.pullOff.has_value());
            if (usual.pullOff) {
                EXPECT_NEAR(other.pullOff->before.force / (scale * scale),
                            usual.pullOff->before.force,
                            1e-6 * std::abs(usual.pullOff->before.force));
            }
        }
    }
}

}  // namespace
}  // namespace asperity
