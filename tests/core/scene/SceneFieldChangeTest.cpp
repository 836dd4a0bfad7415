#include "core/scene/SceneFieldChange.h"

#include "core/Error.h"
#include "core/probe/CantileverModes.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

const SceneField& field(const std::string& name) {
    for (const SceneField& one : sceneFields()) {
        if (nameOf(one) == name) {
            return one;
        }
    }
    throw Error(name + " is no field");
}

SceneDescription changed(const SceneDescription& scene, const std::string& name,
                         const SceneValue& value,
                         LeverCalibration calibration = LeverCalibration::Stiffness) {
    return withValue(scene, field(name), value, calibration);
}

TEST(SceneFieldChange, TheTruthGoesAlongWhereItWasTheSame) {
    SceneDescription scene = test::plainScene();
    scene = changed(scene, "sample.youngs_modulus_pa", 3e9);
    scene = changed(scene, "probe.stiffness_n_m", 20.0);
    scene = changed(scene, "probe.signal_noise_rad", 2e-7);
    EXPECT_EQ(scene.truth.material, scene.sample.material);
    EXPECT_NEAR(scene.truth.stiffness, 20.0, 1e-9);
    EXPECT_EQ(scene.truth.signalNoise, 2e-7);
    EXPECT_NO_THROW(checkScene(scene));
}

/// The truth's stiffness changed by rounding, so that a setpoint took another run.
TEST(SceneFieldChange, ChangesNothingButTheKeyAndWhatFollows) {
    const SceneDescription scene = test::plainScene();
    SceneDescription expected = scene;
    expected.setpoint = 3e-9;
    EXPECT_EQ(changed(scene, "approach.setpoint_n", 3e-9), expected);
    expected = scene;
    expected.tip.radius = 2e-8;
    EXPECT_EQ(changed(scene, "tip.radius_m", 2e-8), expected);
}

TEST(SceneFieldChange, AChangedNumberHasNoSourceAnyMore) {
    SceneDescription scene = test::plainScene();
    scene.probeSource = "a curve";
    scene = changed(scene, "sample.source", std::string("a book"));
    EXPECT_EQ(scene.sample.material.source, "a book");
    EXPECT_EQ(scene.sample.material.name, test::plainScene().sample.material.name);
    EXPECT_EQ(changed(scene, "sample.name", std::string("x")).sample.material.source, "a book");
    EXPECT_EQ(changed(scene, "tip.radius_m", 2e-8).probeSource, "a curve");
    scene = changed(scene, "sample.youngs_modulus_pa", 3e9);
    EXPECT_EQ(scene.sample.material.source, "");
    EXPECT_EQ(scene.truth.material, scene.sample.material);
    EXPECT_EQ(changed(scene, "probe.stiffness_n_m", 20.0).probeSource, "");
}

TEST(SceneFieldChange, LeavesATruthOfItsOwn) {
    SceneDescription scene = test::plainScene();
    scene = changed(scene, "truth.work_of_adhesion_j_m2", 0.05);
    scene = changed(scene, "truth.stiffness_n_m", 12.0);
    EXPECT_EQ(scene.sample.material, test::plainScene().sample.material);
    scene = changed(scene, "sample.youngs_modulus_pa", 3e9);
    scene = changed(scene, "probe.stiffness_n_m", 20.0);
    EXPECT_EQ(scene.truth.material.elastic.youngsModulus, 2e9);
    EXPECT_EQ(scene.truth.stiffness, 12.0);
}

TEST(SceneFieldChange, AMapIsAFileAndItsChannel) {
    SceneDescription scene = test::plainScene();
    scene = changed(scene, "sample.youngs_modulus_map", std::string(" film.gwy  # Modulus"));
    const std::optional<MapSource> expected =
        MapSource{.file = "film.gwy", .channel = "Modulus", .sha256 = ""};
    EXPECT_EQ(scene.sample.material.maps.youngsModulus, expected);
    EXPECT_EQ(scene.truth.material, scene.sample.material);
    EXPECT_NE(whyIdle(field("sample.youngs_modulus_pa"), scene), "");
    EXPECT_EQ(whyIdle(field("sample.friction_coefficient"), scene), "");
    scene.sample.material.maps.youngsModulus->sha256 = "known";
    const SceneValue shown = field("sample.youngs_modulus_map").get(scene);
    EXPECT_EQ(changed(scene, "sample.youngs_modulus_map", shown), scene) << "the hash stays";
    scene = changed(scene, "sample.youngs_modulus_map", std::string(" "));
    EXPECT_FALSE(scene.sample.material.maps.any());
    scene.sample.material.maps.mask = MaterialMask{};
    EXPECT_NE(whyIdle(field("sample.friction_map"), scene), "");
}

TEST(SceneFieldChange, AChangedMaterialSaysSoOnce) {
    SceneDescription scene = test::plainScene();
    scene = changed(scene, "sample.hardness_pa", 1e9);
    scene = changed(scene, "sample.work_of_adhesion_j_m2", 0.0);
    EXPECT_EQ(scene.sample.material.name, "polystyrene (edited)");
    scene = changed(scene, "sample.name", std::string("mine"));
    EXPECT_EQ(scene.sample.material.name, "mine");
    EXPECT_EQ(changed(test::plainScene(), "tip.radius_m", 1e-8).sample.material.name,
              "polystyrene");
}

TEST(SceneFieldChange, WhatWasMeasuredOfALeverStays) {
    const SceneDescription scene = test::plainScene();
    const double stiffness = Cantilever(scene.probe).stiffness();
    const double resonance = flexuralMode(scene.probe, 1).frequency();
    const auto longer = [&](LeverCalibration calibration) {
        return changed(scene, "probe.length_m", 200e-6, calibration).probe;
    };
    EXPECT_EQ(longer(LeverCalibration::Thickness).thickness, scene.probe.thickness);
    EXPECT_NEAR(Cantilever(longer(LeverCalibration::Stiffness)).stiffness(), stiffness, 1e-9);
    EXPECT_NEAR(flexuralMode(longer(LeverCalibration::Resonance), 1).frequency(), resonance,
                1e-9 * resonance);
    const CantileverGeometry both = longer(LeverCalibration::StiffnessAndResonance);
    EXPECT_NEAR(Cantilever(both).stiffness(), stiffness, 1e-9);
    EXPECT_NEAR(flexuralMode(both, 1).frequency(), resonance, 1e-9 * resonance);
    EXPECT_EQ(longer(LeverCalibration::Stiffness).youngsModulus, scene.probe.youngsModulus);
}

TEST(SceneFieldChange, StiffnessAndResonanceTogetherGiveTheModulus) {
    SceneDescription scene = test::plainScene();
    const auto calibration = LeverCalibration::StiffnessAndResonance;
    scene = changed(scene, "probe.stiffness_n_m", 2.8, calibration);
    scene = changed(scene, "probe.resonance_hz", 75e3, calibration);
    EXPECT_NEAR(Cantilever(scene.probe).stiffness(), 2.8, 1e-9);
    EXPECT_NEAR(flexuralMode(scene.probe, 1).frequency(), 75e3, 1e-4);
    EXPECT_NE(scene.probe.youngsModulus, test::plainScene().probe.youngsModulus);
    const SceneDescription one = changed(test::plainScene(), "probe.resonance_hz", 75e3);
    EXPECT_EQ(one.probe.youngsModulus, test::plainScene().probe.youngsModulus);
    EXPECT_NEAR(flexuralMode(one.probe, 1).frequency(), 75e3, 1e-4);
}

TEST(SceneFieldChange, DefaultsFollowWhatTheyDependOn) {
    SceneDescription scene = defaultScene();
    for (const SceneField& one : sceneFields()) {
        EXPECT_TRUE(isSame(one, scene, defaultsOf(scene))) << nameOf(one);
    }
    scene = changed(scene, "tip.radius_m", 3e-8);
    scene = changed(scene, "probe.stiffness_n_m", 2.0);
    const SceneDescription defaults = defaultsOf(scene);
    EXPECT_FALSE(isSame(field("tip.radius_m"), scene, defaults));
    EXPECT_TRUE(isSame(field("truth.stiffness_n_m"), scene, defaults)) << "that of the probe";
    const SceneDescription reset =
        changed(scene, "tip.radius_m", field("tip.radius_m").get(defaults));
    EXPECT_EQ(reset.tip.radius, defaultScene().tip.radius);
    SceneDescription ball = defaultScene();
    ball.sample.shape = ShapeDescription{.radius = 2e-7, .size = 2e-7};
    EXPECT_TRUE(isSame(field("sample.shape_size_m"), ball, defaultsOf(ball))) << "the radius";
}

TEST(SceneFieldChange, SaysWhichKeysMeanNothing) {
    SceneDescription scene = defaultScene();
    EXPECT_EQ(whyIdle(field("sample.level"), scene), "");
    EXPECT_NE(whyIdle(field("sample.shape_radius_m"), scene), "");
    EXPECT_NE(whyIdle(field("sample.erode"), scene), "");
    scene.sample.imagingTipRadius = 1e-8;
    EXPECT_EQ(whyIdle(field("sample.erode"), scene), "");
    scene.choices.law = ContactLaw::Hertz;
    EXPECT_NE(whyIdle(field("fidelity.adhesion"), scene), "");
    EXPECT_EQ(whyIdle(field("fidelity.friction"), scene), "");
    scene.sample.shape = ShapeDescription{.kind = ShapeKind::Plane};
    EXPECT_NE(whyIdle(field("sample.level"), scene), "");
    EXPECT_NE(whyIdle(field("sample.shape_radius_m"), scene), "");
    EXPECT_EQ(whyIdle(field("sample.shape_slope_rad"), scene), "");
    EXPECT_EQ(whyIdle(field("sample.shape_size_m"), scene), "");
}

TEST(SceneWithDescription, HasTheSameSurfaceUnderAnotherTip) {
    const Scene before = buildScene(test::plainScene(), test::hillyMap());
    const double height = before.surface.at(50e-9, 50e-9).height;
    const Scene after = withDescription(before, changed(test::plainScene(), "tip.radius_m", 40e-9));
    EXPECT_EQ(after.surface.at(50e-9, 50e-9).height, height);
    EXPECT_EQ(after.belief.contact.pair().tipRadius, 40e-9);
    EXPECT_THROW((void)withDescription(before, changed(test::plainScene(), "tip.radius_m", -1.0)),
                 Error);
}

}  // namespace
}  // namespace asperity
