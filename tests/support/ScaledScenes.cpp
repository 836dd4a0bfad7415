#include "tests/support/ScaledScenes.h"

#include "core/Units.h"
#include "tests/support/TestScenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::test {

namespace {

/// Two particles of 20 nm that stand side by side along x on a level ground, one 2 nm lower.
HeightMap particleMap() {
    constexpr int kPixels = 96;
    constexpr double kPitch = 1.0_nm;
    constexpr double kRadius = 20.0_nm;
    HeightMap map{.columns = kPixels, .rows = kPixels, .pitchX = kPitch, .pitchY = kPitch};
    const auto particle = [](double x, double y) {
        const double across = std::hypot(x, y);
        // A cone instead of the steep part, which a spline could not follow.
        return across < kRadius * std::numbers::sqrt2 / 2.0
                   ? std::sqrt(kRadius * kRadius - across * across)
                   : kRadius * std::numbers::sqrt2 - across;
    };
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            const double x = (column + 0.5 - kPixels / 2.0) * kPitch;
            const double y = (row + 0.5 - kPixels / 2.0) * kPitch;
            map.heights.push_back(
                std::max({0.0, particle(x - 22.0_nm, y), particle(x + 22.0_nm, y) - 2.0_nm}));
        }
    }
    return map;
}

/// Flanks of 20 degrees along y that meet in the middle.
HeightMap grooveMap() {
    constexpr int kColumns = 128;
    constexpr int kRows = 32;
    constexpr double kPitch = 20.0_nm;
    const double slope = std::tan(std::numbers::pi / 9.0);
    HeightMap map{.columns = kColumns, .rows = kRows, .pitchX = kPitch, .pitchY = kPitch};
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            map.heights.push_back(slope * kPitch * std::abs(column + 0.5 - kColumns / 2.0));
        }
    }
    return map;
}

struct Sample {
    ContactLaw law = ContactLaw::Maugis;
    double youngsModulus = 2e9;  ///< [Pa]
    double adhesion = 0.066;     ///< [J/m^2]
    double friction = 0.0;       ///< coefficient
    double stiffness = 14.0;     ///< of the lever [N/m]
    double radius = 15.0_nm;     ///< of the tip [m]
    double setpoint = 5.0_nN;    ///< [N]
};

SceneDescription sceneOf(const Sample& sample) {
    SceneDescription scene = plainScene();
    scene.choices.law = sample.law;
    scene.tip.radius = sample.radius;
    scene.setpoint = sample.setpoint;
    scene.sample.material.elastic.youngsModulus = sample.youngsModulus;
    scene.sample.material.workOfAdhesion = sample.adhesion;
    scene.sample.material.friction = {.coefficient = sample.friction, .shearStrength = 0.0};
    scene.truth.material = scene.sample.material;
    scene.probe.thickness = thicknessForStiffness(scene.probe, sample.stiffness);
    scene.truth.stiffness = sample.stiffness;
    return scene;
}

}  // namespace

ScaledScene scaled(ScaledScene scene, double scale) {
    SceneDescription& description = scene.description;
    description.tip.radius *= scale;
    description.cohesiveRange *= scale;
    description.setpoint *= scale * scale;
    description.probe.length *= scale;
    description.probe.width *= scale;
    description.probe.thickness *= scale;
    description.probe.tipHeight *= scale;
    description.truth.stiffness *= scale;
    for (SampleMaterial* const material :
         {&description.sample.material, &description.truth.material}) {
        material->workOfAdhesion *= scale;
        material->filmThickness *= scale;
    }
    scene.map.pitchX *= scale;
    scene.map.pitchY *= scale;
    for (double& height : scene.map.heights) {
        height *= scale;
    }
    scene.position *= scale;
    scene.reach *= scale;
    return scene;
}

std::vector<ScaledScene> scenesWithoutLengths() {
    const Vector2 middle(61.0_nm, 67.0_nm);
    const Vector2 groove(45.6_nm, 64.0_nm);
    const Sample soft{.law = ContactLaw::Jkr, .youngsModulus = 20e6, .stiffness = 0.5};
    Sample gel{.law = ContactLaw::Hertz, .youngsModulus = 10e3, .adhesion = 0.0, .stiffness = 0.1};
    gel.radius = 1.0_um;
    gel.setpoint = 0.3_nN;
    Sample film{.law = ContactLaw::HertzFilm, .adhesion = 0.0};
    std::vector<ScaledScene> scenes{
        {"flat", sceneOf({}), flatMap(), middle, 3.0_nm},
        {"flat, soft", sceneOf(soft), flatMap(), middle, 12.0_nm},
        {"slope with friction",
         sceneOf({.law = ContactLaw::Hertz, .adhesion = 0.0, .friction = 0.3}), slopedMap(0.5),
         middle, 3.0_nm},
        {"hills with friction", sceneOf({.friction = 0.3}), hillyMap(), middle, 3.0_nm},
        {"groove", sceneOf({}), ridgedMap(25.0_nm), groove, 4.0_nm},
        {"groove without adhesion", sceneOf({.law = ContactLaw::Hertz, .adhesion = 0.0}),
         ridgedMap(25.0_nm), groove, 4.0_nm},
        {"hollow, soft lever", sceneOf({.law = ContactLaw::Dmt, .stiffness = 0.4}),
         ridgedMap(8.0_nm), groove, 20.0_nm},
        {"film on hills", sceneOf(film), hillyMap(), middle, 3.0_nm},
        {"two particles", sceneOf({}), particleMap(), {47.0_nm, 48.5_nm}, 6.0_nm},
        {"bead in a groove of gel", sceneOf(gel), grooveMap(), {1290.0_nm, 320.0_nm}, 150.0_nm}};
    scenes[7].description.sample.material.filmThickness = 40.0_nm;
    scenes[7].description.truth.material.filmThickness = 40.0_nm;
    return scenes;
}

}  // namespace asperity::test
