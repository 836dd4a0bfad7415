#include "core/scene/Scene.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace asperity {
namespace {

TEST(Scene, DefaultIsThePapersPolystyreneUnderA14NewtonPerMeterLever) {
    const Scene scene = buildScene(defaultScene(), test::hillyMap());
    EXPECT_NEAR(scene.belief.cantilever.stiffness(), 14.0, 1e-12);
    EXPECT_DOUBLE_EQ(scene.belief.tipRadius(), 15.0_nm);
    EXPECT_NEAR(scene.belief.contact.pair().reducedModulus, 2.350_GPa, 0.001_GPa);
}

TEST(Scene, TruthIsWhatTheSceneSaysUnlessSaidOtherwise) {
    SceneDescription description = defaultScene();
    const Scene same = buildScene(description, test::hillyMap());
    EXPECT_EQ(truthOf(same).system.contact.pair().reducedModulus,
              same.belief.contact.pair().reducedModulus);
    EXPECT_EQ(truthOf(same).system.cantilever.stiffness(), same.belief.cantilever.stiffness());
    description.truth.material.elastic.youngsModulus *= 2.0;
    description.truth.stiffness = 20.0;
    const Scene other = buildScene(description, test::hillyMap());
    EXPECT_GT(truthOf(other).system.contact.pair().reducedModulus,
              1.9 * other.belief.contact.pair().reducedModulus);
    EXPECT_NEAR(truthOf(other).system.cantilever.stiffness(), 20.0, 1e-12);
    EXPECT_NEAR(other.belief.cantilever.stiffness(), 14.0, 1e-12);
}

TEST(Scene, LevelsTheMapAndKeepsWhatItRemoved) {
    SceneDescription description = test::plainScene();
    description.sample.leveling = {LevelingStep::Plane};
    const HeightMap map = test::slopedMap(0.05);
    const Scene scene = buildScene(description, map);
    // The scan is kept in single precision about the middle of its heights.
    const double rounding = 0x1p-24 * 0.5 * 0.05 * map.sizeX();
    EXPECT_NEAR(scene.removedPlane.slopeX, 0.05, 3.0 * rounding / map.sizeX());
    EXPECT_NEAR(scene.surface.at(60.0_nm, 60.0_nm).height, 0.0, 2.0 * rounding);
    EXPECT_NEAR(scene.surface.at(60.0_nm, 60.0_nm).dx, 0.0, 3.0 * rounding / map.pitchX);
}

/// What pictures hatch and the flag filled_pixel means.
TEST(Scene, ScarsThatLevelingRemovedHoldNoData) {
    HeightMap map = test::slopedMap(0.0);
    ASSERT_GE(map.columns, 16);
    const int row = map.rows / 2;
    for (int column = 0; column < map.columns; ++column) {
        map.heights[map.index(row, column)] += 20.0_nm;
    }
    SceneDescription description = test::plainScene();
    description.sample.leveling = {LevelingStep::Scars, LevelingStep::Zero};
    const Scene scene = buildScene(description, map);
    ASSERT_EQ(scene.removedBySteps.size(), 2U);
    EXPECT_EQ(scene.removedBySteps[0].pixels, static_cast<std::size_t>(map.columns));
    const double x = 0.5 * map.sizeX();
    const double y = (map.rows - row - 0.5) * map.pitchY;
    EXPECT_FALSE(scene.surface.isMeasured(x, y));
    EXPECT_TRUE(scene.surface.isMeasured(x, y + map.pitchY));
    EXPECT_NEAR(scene.surface.at(x, y).height, 0.0, 1e-15);
}

TEST(Scene, SmoothsByALengthAlongBothAxesWhateverThePixels) {
    HeightMap map = test::hillyMap();
    map.pitchY = 2.0 * map.pitchX;
    SceneDescription description = test::plainScene();
    description.sample.smoothingLength = 2.0 * map.pitchX;
    const Scene scene = buildScene(description, map);
    const BSplineSurface expected = fitSurface(map, {.x = 2.0, .y = 1.0});
    EXPECT_EQ(scene.surface.control(7, 9), expected.control(7, 9));
    EXPECT_NE(scene.surface.control(7, 9), fitSurface(map).control(7, 9));
    description.sample.smoothingLength = 1000.0 * map.pitchX;
    EXPECT_THROW((void)buildScene(description, map), Error);
}

/// Half of kB T to each mode: the end of a spring of 2 N/m moves by 45 pm.
TEST(Scene, TakesHeatForNoiseOfBending) {
    SceneDescription description = test::plainScene();
    description.probe.thickness = thicknessForStiffness(description.probe, 2.0);
    const LeverSignals cold = buildScene(description, test::flatMap()).signalSigma;
    description.truth.temperature = 296.0;
    const LeverSignals warm = buildScene(description, test::flatMap()).signalSigma;
    EXPECT_EQ(cold.bending, description.signalSigma);
    EXPECT_EQ(warm.torsion, cold.torsion);
    const double heat = std::sqrt(std::pow(warm.bending, 2.0) - std::pow(cold.bending, 2.0));
    // The fundamental is a little stiffer than the beam, 1.03 k, and its end slopes by 1.377 / l.
    const double expected =
        1.3765 / description.probe.length * std::sqrt(1.380649e-23 * 296.0 / (1.0302 * 2.0));
    EXPECT_NEAR(heat, expected, 1e-3 * expected);
}

TEST(Scene, RefusesWhatIsNoScan) {
    HeightMap high = test::flatMap();
    high.heights[5] = 1e30;
    EXPECT_THROW((void)buildScene(test::plainScene(), high), Error);
    HeightMap wide = test::flatMap();
    wide.pitchX = 1e300;
    EXPECT_THROW((void)buildScene(test::plainScene(), wide), Error);
    HeightMap narrow = test::flatMap();
    narrow.pitchY = 1e-300;
    EXPECT_THROW((void)buildScene(test::plainScene(), narrow), Error);
}

TEST(Scene, RefusesEachValueOutsideItsRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::function<void(SceneDescription&)> mistakes[] = {
        [](SceneDescription& s) { s.sample.material.elastic.youngsModulus = 0.0; },
        [nan](SceneDescription& s) { s.sample.material.elastic.youngsModulus = nan; },
        [](SceneDescription& s) { s.sample.material.elastic.poissonRatio = 0.6; },
        [nan](SceneDescription& s) { s.sample.material.elastic.poissonRatio = nan; },
        [](SceneDescription& s) { s.sample.material.workOfAdhesion = -0.1; },
        [](SceneDescription& s) { s.sample.material.friction.coefficient = -1.0; },
        [](SceneDescription& s) { s.truth.material.friction.shearStrength = INFINITY; },
        [](SceneDescription& s) { s.truth.stiffness = 0.0; },
        [](SceneDescription& s) { s.truth.signalNoise = -1.0; },
        [](SceneDescription& s) { s.truth.material.workOfAdhesion = 2000.0; },
        [](SceneDescription& s) { s.tip.radius = 0.0; },
        [](SceneDescription& s) { s.tip.coneHalfAngle = -0.1; },
        [](SceneDescription& s) { s.tip.coneHalfAngle = 1.6; },
        [nan](SceneDescription& s) { s.tip.coneHalfAngle = nan; },
        [](SceneDescription& s) { s.tip.elastic.youngsModulus = -1.0; },
        [](SceneDescription& s) { s.tip.elastic.poissonRatio = 0.7; },
        [nan](SceneDescription& s) { s.probe.length = nan; },
        [](SceneDescription& s) { s.probe.thickness = 0.0; },
        [](SceneDescription& s) { s.signalSigma = 0.0; },
        [](SceneDescription& s) { s.uncertainty.tipRadius = -0.1; },
        [](SceneDescription& s) { s.uncertainty.heightNoise = 1.0; },
        [nan](SceneDescription& s) { s.uncertainty.stiffness = nan; },
        [](SceneDescription& s) { s.tickRate = 0.0; },
        [](SceneDescription& s) { s.tickRate = 1e6; },
        [](SceneDescription& s) { s.meniscus = {.surfaceTension = 0.072}; },
        [](SceneDescription& s) { s.meniscus = {.range = 1.0_nm}; },
        [](SceneDescription& s) {
            s.meniscus = {0.072, 3.0, 1.0_nm};
        },
        [](SceneDescription& s) { s.cohesiveRange = 0.0; },
        [](SceneDescription& s) { s.sample.material.hardness = -1.0; },
        [](SceneDescription& s) { s.sample.material.filmThickness = -1.0_nm; },
        [](SceneDescription& s) { s.settings.positionGain = 0.0; },
        [nan](SceneDescription& s) { s.settings.forceGain = nan; },
        [](SceneDescription& s) { s.settings.correctionBandwidth = -1.0; },
        [](SceneDescription& s) { s.zoomHalfWidth = -1.0; },
        [](SceneDescription& s) { s.setpoint = 0.0; },
        [nan](SceneDescription& s) { s.setpoint = nan; },
        [](SceneDescription& s) { s.sample.smoothingPixels = -1.0; },
    };
    int index = 0;
    for (const auto& mistake : mistakes) {
        SceneDescription description = test::plainScene();
        mistake(description);
        EXPECT_THROW((void)buildScene(description, test::flatMap()), Error) << "mistake " << index;
        ++index;
    }
}

/// What a scene with a cone says under a law; empty: it is accepted.
std::string refusalOfCone(std::optional<ContactLaw> law, double filmThickness = 0.0) {
    SceneDescription description = test::plainScene();
    description.tip.coneHalfAngle = 0.3;
    description.choices.law = law;
    description.sample.material.filmThickness = filmThickness;
    if (filmThickness > 0.0) {
        description.sample.material.workOfAdhesion = 0.0;
    }
    try {
        checkScene(description);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Scene, RefusesAConeUnderALawOfAParaboloid) {
    EXPECT_EQ(refusalOfCone(ContactLaw::Hertz),
              "[tip]: cone_half_angle_rad must be 0 under the law hertz, which takes the tip for a "
              "paraboloid; [physics] law sneddon has the cone");
    EXPECT_TRUE(refusalOfCone(ContactLaw::Jkr).ends_with("law jkr_sphere has the cone"));
    EXPECT_TRUE(refusalOfCone(ContactLaw::Maugis).ends_with("law md_sphere has the cone"));
    EXPECT_TRUE(refusalOfCone(ContactLaw::Split).ends_with("law split_sphere has the cone"));
    EXPECT_TRUE(refusalOfCone(ContactLaw::Dmt).ends_with("no law of its kind has a cone"));
    EXPECT_TRUE(refusalOfCone({}, 1e-8).ends_with("no law of its kind has a cone")) << "hertz_film";
    for (const ContactLaw law : {ContactLaw::Sneddon, ContactLaw::SphereJkr,
                                 ContactLaw::SphereMaugis, ContactLaw::SphereSplit}) {
        EXPECT_EQ(refusalOfCone(law), "") << keyOf(law);
    }
    EXPECT_EQ(refusalOfCone({}), "") << "auto";
}

/// Far in soft rubber the model, what is true and the drawn tip have the same cone.
TEST(Scene, HasOneConeForLawTruthAndPictures) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5};
    description.sample.material.workOfAdhesion = 0.022;
    description.truth.material = description.sample.material;
    description.tip.coneHalfAngle = 0.3;
    const Scene scene = buildScene(description, test::flatMap());
    EXPECT_EQ(scene.model.law, ContactLaw::SphereSplit);
    EXPECT_EQ(scene.belief.contact.coneHalfAngle(), 0.3);
    EXPECT_EQ(truthOf(scene).system.contact.coneHalfAngle(), 0.3);
    EquilibriumMemory memory;
    TipState state;
    const double start = scene.surface.at(64.0_nm, 64.0_nm).height;
    for (int i = 0; i <= 60; ++i) {
        const BaseMotion base{.position = {64.0_nm, 64.0_nm, start - i * 1.0_nm}};
        state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        ASSERT_TRUE(state.converged) << i;
    }
    EXPECT_GT(state.contact.contactRadius, scene.belief.tipRadius());
    const ContactState expected =
        scene.belief.contact.equilibrium(state.contact.indentation, 0.0, kBondedMemory);
    EXPECT_NEAR(state.force.z(), expected.force, 1e-6 * expected.force);
}

TEST(Scene, ChoosesTheContactLawAndSaysWhy) {
    SceneDescription description = test::plainScene();
    EXPECT_EQ(buildScene(description, test::flatMap()).model.law, ContactLaw::Split);
    description.sample.material.elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5};
    description.sample.material.workOfAdhesion = 0.022;
    const Scene rubber = buildScene(description, test::flatMap());
    EXPECT_EQ(rubber.belief.contact.law(), ContactLaw::SphereSplit);
    EXPECT_EQ(usualLaw(rubber.description).reason, LawReason::WideContact);
    EXPECT_NEAR(usualLaw(rubber.description).unloadedRatio, 2.5, 0.05);
    description.sample.material.workOfAdhesion = 0.0;
    EXPECT_EQ(buildScene(description, test::flatMap()).belief.contact.law(), ContactLaw::Hertz);
    description.choices.law = ContactLaw::Jkr;
    EXPECT_EQ(buildScene(description, test::flatMap()).belief.contact.law(), ContactLaw::Jkr);
}

TEST(Scene, EveryLawBalancesTheTipOnHills) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(keyOf(law));
        SceneDescription description = test::plainScene();
        description.choices.law = law;
        description.sample.material.filmThickness = 100.0_nm;
        description.truth.material = description.sample.material;
        const Scene scene = buildScene(description, test::hillyMap());
        EquilibriumMemory memory;
        TipState state;
        for (int i = 0; i < 5; ++i) {
            const BaseMotion base{.position = {20.0_nm, 18.0_nm, 8.0_nm - i * 1.0_nm}};
            state = tipEquilibrium(scene.surface, scene.belief, base, memory);
            EXPECT_TRUE(state.converged);
            EXPECT_TRUE(state.contact.solved());
        }
        EXPECT_GT(state.contact.contactRadius, 0.5_nm);
    }
}

}  // namespace
}  // namespace asperity
