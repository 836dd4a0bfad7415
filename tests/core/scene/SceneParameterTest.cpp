#include "core/scene/SceneParameter.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(SceneParameter, IsReadAndSetWithTheTruthAsItWasTheSame) {
    for (const SceneParameterTraits& traits : kEnumTable<SceneParameter>) {
        const SceneDescription scene = test::plainScene();
        const double value = 1.5 * parameterOf(scene, traits.value);
        const SceneDescription changed = withParameter(scene, traits.value, value);
        EXPECT_NEAR(parameterOf(changed, traits.value), value, 1e-12 * value) << traits.key;
        for (const SceneParameter other : kValues<SceneParameter>) {
            if (other != traits.value) {
                EXPECT_EQ(parameterOf(changed, other), parameterOf(scene, other)) << traits.key;
            }
        }
        EXPECT_EQ(changed.truth.material, changed.sample.material) << traits.key;
        EXPECT_NEAR(changed.truth.stiffness, Cantilever(changed.probe).stiffness(), 1e-9);
        EXPECT_NO_THROW(checkScene(changed));
    }
}

TEST(SceneParameter, LeavesATruthOfItsOwn) {
    SceneDescription scene = test::plainScene();
    scene.truth.material.workOfAdhesion = 0.05;
    scene.truth.stiffness = 12.0;
    scene = withParameter(scene, SceneParameter::YoungsModulus, 3e9);
    scene = withParameter(scene, SceneParameter::SpringConstant, 20.0);
    EXPECT_EQ(scene.truth.material.elastic.youngsModulus, 2e9);
    EXPECT_EQ(scene.truth.stiffness, 12.0);
}

TEST(SceneParameter, AChangedMaterialSaysSoOnce) {
    SceneDescription scene = test::plainScene();
    scene = withParameter(scene, SceneParameter::Hardness, 1e9);
    scene = withParameter(scene, SceneParameter::WorkOfAdhesion, 0.0);
    EXPECT_EQ(scene.sample.material.name, "polystyrene (edited)");
    EXPECT_EQ(
        withParameter(test::plainScene(), SceneParameter::TipRadius, 1e-8).sample.material.name,
        "polystyrene");
}

TEST(SceneWithDescription, HasTheSameSurfaceUnderAnotherTip) {
    const Scene before = buildScene(test::plainScene(), test::hillyMap());
    const double height = before.surface.at(50e-9, 50e-9).height;
    const Scene after =
        withDescription(buildScene(test::plainScene(), test::hillyMap()),
                        withParameter(test::plainScene(), SceneParameter::TipRadius, 40e-9));
    EXPECT_EQ(after.surface.at(50e-9, 50e-9).height, height);
    EXPECT_EQ(after.belief.contact.pair().tipRadius, 40e-9);
    EXPECT_THROW(
        (void)withDescription(buildScene(test::plainScene(), test::hillyMap()),
                              withParameter(test::plainScene(), SceneParameter::TipRadius, -1.0)),
        std::exception);
}

}  // namespace
}  // namespace asperity
