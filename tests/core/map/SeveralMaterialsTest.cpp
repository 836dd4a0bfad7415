#include "core/map/MapInstrument.h"
#include "core/map/PixelCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

// Maps of samples that are not the same everywhere.

namespace asperity {
namespace {

constexpr double kSetpoint = 5e-9;  // [N]

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

MapValues cycleOn(const Scene& scene, const Vector2& place, bool truth) {
    return pixelCycle(MapInstrument(scene, truth), place, kSetpoint);
}

/// What topography does to the curve is the same: a uniform sample of the material of the place
/// gives all of it.
TEST(SeveralMaterials, EachPixelIsThatOfAUniformSample) {
    constexpr std::array kQuantities{MapQuantity::PullOffForce,     MapQuantity::AdhesionForce,
                                     MapQuantity::SnapInDistance,   MapQuantity::SeparationWork,
                                     MapQuantity::DissipatedEnergy, MapQuantity::Height,
                                     MapQuantity::Indentation,      MapQuantity::ContactRadius,
                                     MapQuantity::Stiffness,        MapQuantity::LateralForce};
    const Scene halved = halvedScene(6e9, 1.5e9);
    for (const bool truth : {false, true}) {
        for (const Vector2& place : {Vector2(41e-9, 100e-9), Vector2(77e-9, 21e-9)}) {
            const Scene uniform = uniformScene(place.y() > 64e-9 ? 6e9 : 1.5e9);
            const MapValues values = cycleOn(halved, place, truth);
            const MapValues expected = cycleOn(uniform, place, truth);
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

}  // namespace
}  // namespace asperity
