#include "core/FormattedText.h"
#include "core/map/JumpSearch.h"
#include "core/map/PixelCycle.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

// Maps of samples that are not the same everywhere.

namespace asperity {
namespace {

using test::cycleOn;
using test::kSetpoint;

/// Hills whose upper half is of another material.
Scene halvedScene(double upperModulus, double lowerModulus) {
    const HeightMap scan = test::hillyMap();
    HeightMap modulus = scan;
    for (int row = 0; row < modulus.rows; ++row) {
        for (int column = 0; column < modulus.columns; ++column) {
            modulus.heights[modulus.index(row, column)] =
                2 * row < modulus.rows ? upperModulus : lowerModulus;
        }
    }
    const MaterialMaps maps{.youngsModulus = std::make_shared<const PixelField>(modulus, "Pa"),
                            .workOfAdhesion = nullptr,
                            .friction = nullptr};
    SceneDescription description = test::plainScene();
    description.sample.material.maps.youngsModulus =
        MapSource{.file = "modulus.gwy", .channel = "", .sha256 = ""};
    description.truth.material = description.sample.material;
    return buildScene(description, scan, nullptr, {.sample = maps, .truth = maps});
}

Scene uniformScene(double modulus) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic.youngsModulus = modulus;
    description.truth.material = description.sample.material;
    return buildScene(description, test::hillyMap());
}

/// What topography does to the curve is the same: a uniform sample of the material of the position
/// gives all of it.
TEST(SeveralMaterials, EachPixelIsThatOfAUniformSample) {
    constexpr std::array kQuantities{MapQuantity::PullOffForce,     MapQuantity::AdhesionForce,
                                     MapQuantity::SnapInDistance,   MapQuantity::SeparationWork,
                                     MapQuantity::DissipatedEnergy, MapQuantity::Height,
                                     MapQuantity::Indentation,      MapQuantity::ContactRadius,
                                     MapQuantity::Stiffness,        MapQuantity::LateralForce};
    const Scene halved = halvedScene(6e9, 1.5e9);
    for (const bool truth : {false, true}) {
        for (const Vector2& position : {Vector2(41e-9, 100e-9), Vector2(77e-9, 21e-9)}) {
            const Scene uniform = uniformScene(position.y() > 64e-9 ? 6e9 : 1.5e9);
            const MapValues values = cycleOn(halved, position, truth);
            const MapValues expected = cycleOn(uniform, position, truth);
            for (const MapQuantity quantity : kQuantities) {
                EXPECT_NEAR(values[quantity], expected[quantity],
                            1e-6 * std::abs(expected[quantity]))
                    << nameOf(quantity);
            }
        }
    }
}

TEST(SeveralMaterials, TheModulusOfAFlatTwinTellsThemApart) {
    const Scene halved = halvedScene(6e9, 1.5e9);
    const double hard = cycleOn(halved, {41e-9, 100e-9}, false)[MapQuantity::Stiffness];
    const double soft = cycleOn(halved, {41e-9, 28e-9}, false)[MapQuantity::Stiffness];
    EXPECT_GT(hard, 2.0 * soft);
}

/// A flat sample whose work of adhesion changes along x, under a lever of this stiffness [N/m].
Scene slopedAdhesion(double left, double right, double stiffness) {
    const HeightMap scan = test::flatMap();
    HeightMap adhesion = scan;
    for (int row = 0; row < scan.rows; ++row) {
        for (int column = 0; column < scan.columns; ++column) {
            adhesion.heights[scan.index(row, column)] =
                std::lerp(left, right, (column + 0.5) / scan.columns);
        }
    }
    const MaterialMaps maps{.youngsModulus = nullptr,
                            .workOfAdhesion = std::make_shared<const PixelField>(adhesion, "J/m^2"),
                            .friction = nullptr};
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Jkr;
    description.probe.thickness = thicknessForStiffness(description.probe, stiffness);
    description.truth.stiffness = stiffness;
    description.sample.material.maps.workOfAdhesion =
        MapSource{.file = "adhesion.gwy", .channel = "", .sha256 = ""};
    description.truth.material = description.sample.material;
    return buildScene(description, scan, nullptr, {.sample = maps, .truth = maps});
}

/// A lever that pulls bends, and its tip goes to the side: JKR's pull-off is that of the work of
/// adhesion where the tip then stands.
TEST(SeveralMaterials, ATipPullsHardestWhereTheLeverHasTakenIt) {
    for (const double stiffness : {0.1, 1.0}) {  // levers that pull off near the strongest pull
        for (const auto& [left, right] : {std::pair(0.03, 0.09), std::pair(0.09, 0.03)}) {
            const Scene scene = slopedAdhesion(left, right, stiffness);
            const MapInstrument instrument(scene, false);
            const Vector2 position(64e-9, 64e-9);
            const double aside = instrument.system().cantilever.compliance()(0, 2);
            double pull = 0.0;
            for (int i = 0; i < 200; ++i) {
                const double share = (position.x() - aside * pull) / 128e-9;
                pull = 1.5 * std::numbers::pi * instrument.system().tipRadius() *
                       std::lerp(left, right, share);
            }
            const MapValues values = pixelCycle(instrument, position, kSetpoint);
            const std::string where = formatted("%g N/m, %g to %g J/m^2", stiffness, left, right);
            EXPECT_NEAR(values[MapQuantity::AdhesionForce], pull, 1e-3 * pull) << where;
            EXPECT_NEAR(values[MapQuantity::PullOffForce], pull, 6e-3 * pull) << where;
        }
    }
}

}  // namespace
}  // namespace asperity
