#include "core/haptics/HapticTick.h"

#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "core/surface/imaging/TipErosion.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace asperity {
namespace {

/// Runs a vertical approach to `depth` below touch and back, in the middle of a scene.
std::vector<TickSample> approachAndRetract(const Scene& scene, double depth) {
    const double x = 0.5 * scene.surface.sizeX();
    const double y = 0.5 * scene.surface.sizeY();
    const double height = scene.surface.at(x, y).height;
    const DevicePath path{{0.0, {x, y, height + 4.0_nm}},
                          {1.0, {x, y, height - depth}},
                          {2.0, {x, y, height + 4.0_nm}}};
    SimulatedAfm afm(scene.surface, truthOf(scene));
    std::vector<TickSample> samples;
    runVirtually(scene, path, afm, 2001, [&](const TickSample& s) { samples.push_back(s); });
    return samples;
}

TickInput inputAt(const Vector3& device) {
    return {.device = {.position = device}, .timeStep = 1e-3};
}

TEST(HapticTick, LoadsTheLeverOnAFlatSample) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const auto samples = approachAndRetract(scene, 2.0_nm);
    const TickOutput& deepest = samples[1000].output;
    EXPECT_EQ(deepest.region(), TipRegion::Contact);
    EXPECT_GT(deepest.model.contact.indentation, 0.0);
    // Base displacement is shared between lever and sample: force = k (base - indentation).
    const double lever = 14.0 * (2.0_nm - deepest.model.contact.indentation);
    EXPECT_NEAR(deepest.model.contact.force, lever, 1e-6 * lever);
    EXPECT_NEAR(deepest.model.force.z(), deepest.model.contact.force, 1e-20);
}

/// A doubtful normal moves nothing but the estimate, and widens its covariance across the normal by
/// the load's part along it.
TEST(HapticTick, EstimatesLessSurelyOnADoubtfulNormal) {
    SceneDescription description = test::plainScene();
    description.uncertainty.surfaceNormal = 0.0;
    const auto exact = approachAndRetract(buildScene(description, test::flatMap()), 2.0_nm);
    description.uncertainty.surfaceNormal = 0.05;
    const auto doubtful = approachAndRetract(buildScene(description, test::flatMap()), 2.0_nm);
    const TickOutput& before = exact[1000].output;
    const TickOutput& after = doubtful[1000].output;
    EXPECT_EQ(after.model.force, before.model.force);
    EXPECT_GT(after.estimate.covariance(0, 0), before.estimate.covariance(0, 0));
    EXPECT_TRUE(after.estimate.plausibility.holds());
}

/// One number for estimate and budgets; without uncertainty the normal is exact.
TEST(HapticTick, TakesTheNormalAsUncertainAsTheSceneSays) {
    SceneDescription description = test::plainScene();
    EXPECT_EQ(buildScene(description, test::flatMap()).normalDeviation, 0.02);
    description.uncertainty.surfaceNormal = 0.03;
    EXPECT_EQ(buildScene(description, test::flatMap()).normalDeviation, 0.03);
    description.uncertainty.enabled = false;
    EXPECT_EQ(buildScene(description, test::flatMap()).normalDeviation, 0.0);
}

TEST(HapticTick, AChangedGainMovesNothingByItself) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    TickMemory memory;
    TickInput input = inputAt({50.0_nm, 50.0_nm, 20.0_nm});
    const Vector3 start = tick(scene, input, memory).base.position;
    input.settings.positionGain = 0.25;
    const BaseMotion still = tick(scene, input, memory).base;
    EXPECT_EQ(still.position, start);
    EXPECT_EQ(still.velocity, Vector3::Zero());
    input.device.position.x() += 4.0_nm;
    EXPECT_NEAR(tick(scene, input, memory).base.position.x() - start.x(), 1.0_nm, 1e-18);
}

TEST(HapticTick, ALostDeviceIsAFaultUntilAPersonTakesItBack) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    TickMemory memory;
    TickInput input = inputAt({50.0_nm, 50.0_nm, -1.0_nm});
    EXPECT_NE(tick(scene, input, memory).deviceForce, Vector3::Zero());
    input.device.connected = false;
    EXPECT_EQ(tick(scene, input, memory).fault, Fault::DeviceLost);
    input.settings.rearms = 1;
    EXPECT_EQ(tick(scene, input, memory).fault, Fault::DeviceLost) << "it is still lost";
    input.device.connected = true;
    EXPECT_EQ(tick(scene, input, memory).deviceForce, Vector3::Zero()) << "latched";
    input.settings.rearms = 2;
    EXPECT_EQ(tick(scene, input, memory).fault, Fault::None);
    EXPECT_NE(tick(scene, input, memory).deviceForce, Vector3::Zero());
}

TEST(HapticTick, SnapsInAndPullsOffWithHysteresis) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const auto samples = approachAndRetract(scene, 2.0_nm);
    double snapInHeight = 0.0;
    double pullOffHeight = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const auto before = samples[i - 1].output.model.contact.branch;
        const auto now = samples[i].output.model.contact.branch;
        if (before == now) {
            continue;
        }
        (now == ContactBranch::Bonded ? snapInHeight : pullOffHeight) =
            samples[i].output.base.position.z();
    }
    // docs/theory.md 3.5: polystyrene at 14 N/m snaps in at 0.450 nm and lets go at 0.718 nm.
    EXPECT_NEAR(snapInHeight, 0.450_nm, 0.007_nm);  // one tick moves the base by 6 pm
    EXPECT_NEAR(pullOffHeight, 0.718_nm, 0.007_nm);
}

TEST(HapticTick, TipFollowsTheEstimatedForce) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    for (const TickSample& sample : approachAndRetract(scene, 2.0_nm)) {
        const Vector3 deflection =
            scene.belief.cantilever.compliance() * sample.output.estimate.force;
        EXPECT_LT((sample.output.tip - sample.output.base.position - deflection).norm(), 1e-20);
    }
}

TEST(HapticTick, FeelsTheModelAtOnceAndTheEstimateSlowly) {
    SceneDescription description = test::plainScene();
    description.truth.signalNoise = 0.0;
    description.truth.material.workOfAdhesion = 0.0;
    description.truth.material.elastic.youngsModulus *= 2.0;
    const Scene scene = buildScene(description, test::flatMap());
    SimulatedAfm afm(scene.surface, truthOf(scene));
    const Vector3 start(64.0_nm, 64.0_nm, 5.0_nm);
    const DevicePath path{{0.0, start}, {0.1, {64.0_nm, 64.0_nm, -2.0_nm}}};
    std::vector<TickSample> samples;
    runVirtually(scene, path, afm, 1001, [&](const TickSample& s) { samples.push_back(s); });
    // At rest the operator feels what the instrument feels, though the model believes otherwise.
    const TickOutput& rest = samples.back().output;
    EXPECT_GT((rest.estimate.force - rest.model.force).norm(), 0.5_nN);
    EXPECT_LT((rest.deviceForce - rest.estimate.force).norm(), 0.01_nN);
}

TEST(HapticTick, MovesTheBaseByTheDeviceTimesThePositionGain) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    TickMemory memory;
    TickInput input = inputAt({64.0, 64.0, 5.0});
    input.settings.positionGain = 1.0_nm;
    const TickOutput out = tick(scene, input, memory);
    EXPECT_LT((out.base.position - Vector3(64.0_nm, 64.0_nm, 5.0_nm)).norm(), 1e-20);
    EXPECT_EQ(out.base.velocity, Vector3::Zero()) << "no velocity is known in the first tick";
}

TEST(HapticTick, SwitchesTheForceOffOnRequest) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    TickMemory memory;
    TickInput input = inputAt({64.0_nm, 64.0_nm, -1.0_nm});
    EXPECT_GT(tick(scene, input, memory).deviceForce.norm(), 1.0_nN);
    input.settings.forcesOn = false;
    EXPECT_EQ(tick(scene, input, memory).deviceForce, Vector3::Zero());
}

TEST(HapticTick, LatchesAFaultOnANonFiniteDevice) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    TickMemory memory;
    const TickInput good = inputAt({64.0_nm, 64.0_nm, -1.0_nm});
    EXPECT_GT(tick(scene, good, memory).deviceForce.norm(), 1.0_nN);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const TickOutput faulted = tick(scene, inputAt({64.0_nm, bad, 0.0}), memory);
        EXPECT_EQ(faulted.fault, Fault::NotFinite);
        EXPECT_EQ(faulted.deviceForce, Vector3::Zero());
    }
    EXPECT_EQ(tick(scene, good, memory).deviceForce, Vector3::Zero()) << "latched";
    TickMemory fresh;
    EXPECT_GT(tick(scene, good, fresh).deviceForce.norm(), 1.0_nN) << "of a run without a fault";
}

TEST(HapticTick, IsAPureFunctionOfSceneInputAndMemory) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const auto samples = approachAndRetract(scene, 2.0_nm);
    TickMemory memory;
    for (const TickSample& sample : samples) {
        const TickOutput again = tick(scene, sample.input, memory);
        ASSERT_EQ(again.deviceForce, sample.output.deviceForce);
        ASSERT_EQ(again.estimate.covariance, sample.output.estimate.covariance);
    }
}

TEST(HapticTick, FlagsWhatTheModelDoesNotHoldFor) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5};
    description.sample.material.workOfAdhesion = 0.022;
    const Scene scene = buildScene(description, test::flatMap());
    TickMemory memory;
    const ValidityFlags pressed = tick(scene, inputAt({64.0_nm, 64.0_nm, -2.0_nm}), memory).flags;
    EXPECT_TRUE(pressed.has(Validity::LargeContact));
    EXPECT_FALSE(pressed.has(Validity::Anisotropic)) << "flat";
    EXPECT_TRUE(
        tick(scene, inputAt({-50.0_nm, 64.0_nm, 1.0_nm}), memory).flags.has(Validity::OutsideScan));
}

/// A soft lever bends a contact out of the window; the cycle lost its pull-off there.
TEST(HapticTick, AnExactShapeGoesOnBeyondItsWindow) {
    SceneDescription description = test::plainScene();
    description.sample.shape = ShapeDescription{.kind = ShapeKind::Plane, .size = 100.0_nm};
    const Scene scene = buildScene(description);
    TickMemory memory;
    const TickOutput beyond = tick(scene, inputAt({-50.0_nm, 50.0_nm, -1.0_nm}), memory);
    EXPECT_FALSE(beyond.flags.has(Validity::OutsideScan));
    EXPECT_GT(beyond.model.force.z(), 0.0);
}

TEST(HapticTick, FlagsSamplesTooCurvedForOneEffectiveRadius) {
    const Scene ridges = buildScene(test::plainScene(), test::ridgedMap(9.0_nm));
    TickMemory onCrest;
    const auto crest = tick(ridges, inputAt({15.0_nm, 64.0_nm, 8.0_nm}), onCrest).flags;
    EXPECT_TRUE(crest.has(Validity::Anisotropic));
    EXPECT_FALSE(crest.has(Validity::NarrowValley));
    TickMemory inGroove;
    const Scene grooves = buildScene(test::plainScene(), test::ridgedMap(25.0_nm));
    const auto groove = tick(grooves, inputAt({45.0_nm, 64.0_nm, -18.0_nm}), inGroove).flags;
    EXPECT_TRUE(groove.has(Validity::SeveralContactPoints));
}

TEST(HapticTick, FlagsAPitOfTheTipsOwnShape) {
    const SceneDescription description = test::plainScene();
    const double radius = description.tip.radius;
    HeightMap pit = test::flatMap();
    for (int row = 0; row < pit.rows; ++row) {
        for (int column = 0; column < pit.columns; ++column) {
            const double x = (column + 0.5) * pit.pitchX - 0.5 * pit.sizeX();
            const double y = (row + 0.5) * pit.pitchY - 0.5 * pit.sizeY();
            const double below = std::max(radius * radius - x * x - y * y, 0.0);
            pit.heights[pit.index(row, column)] = std::min(0.6 * radius - std::sqrt(below), 0.0);
        }
    }
    const Scene scene = buildScene(description, pit);
    TickMemory memory;
    const auto seated =
        tick(scene, inputAt({0.5 * pit.sizeX(), 0.5 * pit.sizeY(), -0.4 * radius}), memory).flags;
    EXPECT_TRUE(seated.has(Validity::SearchNotExhaustive));
    TickMemory beside;
    EXPECT_FALSE(tick(scene, inputAt({20.0_nm, 20.0_nm, 0.1_nm}), beside)
                     .flags.has(Validity::SearchNotExhaustive));
}

TEST(HapticTick, FlagsClosestPointsThatNobodyProved) {
    SceneDescription description = test::plainScene();
    for (const SearchEffort effort :
         {SearchEffort::Local, SearchEffort::Global, SearchEffort::Certified}) {
        description.choices.closestPointSearch = effort;
        const Scene scene = buildScene(description, test::ridgedMap(25.0_nm));
        TickMemory memory;
        const TickOutput out = tick(scene, inputAt({15.0_nm, 20.0_nm, 25.1_nm}), memory);
        EXPECT_EQ(out.flags.has(Validity::SearchNotExhaustive), effort != SearchEffort::Certified)
            << keyOf(effort);
        const Scene level = buildScene(description, test::flatMap());
        TickMemory above;
        EXPECT_FALSE(tick(level, inputAt({20.0_nm, 20.0_nm, 0.1_nm}), above)
                         .flags.has(Validity::SearchNotExhaustive))
            << "there is but one";
    }
}

TEST(HapticTick, APlanarForceIsThatOfTheEstimatorWhereTheSignalsTell) {
    SceneDescription description = test::plainScene();
    const Scene estimating = buildScene(description, test::flatMap());
    description.choices.decoupling = DecouplingModel::Planar;
    const Scene planar = buildScene(description, test::flatMap());
    TickMemory one;
    TickMemory other;
    for (int i = 0; i < 50; ++i) {  // along y: the force is well told
        TickInput input = inputAt({60.0_nm, 40.0_nm + 0.2_nm * i, -1.0_nm});
        const TickOutput expected = tick(estimating, input, one);
        input.measurement.signals = leverSignals(planar.belief.cantilever, expected.model.force);
        const TickOutput out = tick(planar, input, other);
        if (i > 1) {
            EXPECT_LE((out.estimate.force - expected.model.force).norm(),
                      1e-6 * expected.model.force.norm());
        }
    }
}

TEST(HapticTick, FlagsContactWhereTheImagingTipDidNotReach) {
    SceneDescription description = test::plainScene();
    description.sample.imagingTipRadius = 20.0_nm;
    const Scene scene = buildScene(description, dilated(test::ridgedMap(25.0_nm), 20.0_nm));
    const auto flaggedAt = [&](double x, double y, double z) {
        TickMemory memory;
        return tick(scene, inputAt({x, y, z}), memory).flags.has(Validity::UncertainPixel);
    };
    EXPECT_FALSE(flaggedAt(75.0_nm, 64.0_nm, 24.5_nm)) << "crest";
    const double groove = scene.surface.at(45.0_nm, 64.0_nm).height;
    EXPECT_TRUE(flaggedAt(45.0_nm, 64.0_nm, groove - 0.5_nm));
    EXPECT_FALSE(flaggedAt(45.0_nm, 64.0_nm, groove + 200.0_nm)) << "no contact";
}

TEST(HapticTick, FlagsPressureBeyondTheHardnessAndContactsTooWideForTheFilm) {
    SceneDescription description = test::plainScene();
    description.sample.material.hardness = 0.5_GPa;
    description.sample.material.filmThickness = 200.0_nm;
    const Scene scene = buildScene(description, test::flatMap());
    TickMemory memory;
    const auto light = tick(scene, inputAt({64.0_nm, 64.0_nm, -0.3_nm}), memory).flags;
    EXPECT_FALSE(light.has(Validity::ElasticLimit));
    EXPECT_FALSE(light.has(Validity::ThinFilm));
    const auto heavy = tick(scene, inputAt({64.0_nm, 64.0_nm, -20.0_nm}), memory).flags;
    EXPECT_TRUE(heavy.has(Validity::ElasticLimit));
    EXPECT_TRUE(heavy.has(Validity::ThinFilm));
}

/// Slides a tip under load and gives the last tick.
TickOutput slid(const Scene& scene, const Vector3& direction) {
    SimulatedAfm afm(scene.surface, truthOf(scene));
    TickMemory memory;
    TickInput input;
    input.settings = scene.settings;
    TickOutput out;
    for (int i = 0; i < 50; ++i) {
        input.device.position = Vector3(64.0_nm, 64.0_nm, -2.0_nm) + (i * 0.1_nm) * direction;
        input.measurement = afm.exchange(commandBase(scene, input, memory).base);
        out = tick(scene, input, memory);
    }
    return out;
}

/// Along the beam the signals do not tell normal force from friction: the friction law must.
TEST(HapticTick, EstimatesTheFrictionOfTheContactArea) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {.coefficient = 0.0, .shearStrength = 100.0_MPa};
    description.truth.material = description.sample.material;
    description.truth.signalNoise = 0.0;
    const Scene scene = buildScene(description, test::flatMap());
    const TickOutput out = slid(scene, Vector3::UnitX());
    ASSERT_LT(out.model.force.x(), -1.0_nN);
    EXPECT_NEAR(out.estimate.force.x(), out.model.force.x(), 0.02 * -out.model.force.x());
}

TEST(HapticTick, FlagsFrictionBeyondItsLaw) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {.coefficient = 0.2, .shearStrength = 0.0};
    description.truth.material = description.sample.material;
    const Scene asBelieved = buildScene(description, test::flatMap());
    EXPECT_FALSE(slid(asBelieved, Vector3::UnitY()).flags.has(Validity::Implausible));
    description.truth.material.friction.coefficient = 2.0;
    const Scene rougher = buildScene(description, test::flatMap());
    EXPECT_TRUE(slid(rougher, Vector3::UnitY()).flags.has(Validity::Implausible));
}

/// A soft lever in a groove that the tip fits: the jump comes earlier than on a flat sample.
TEST(HapticTick, WarnsOfSnapInByTheEffectiveRadius) {
    SceneDescription description = test::plainScene();
    description.probe.thickness = thicknessForStiffness(description.probe, 0.5);
    const Scene scene = buildScene(description, test::ridgedMap(4.5_nm));
    const double bottom = scene.surface.at(45.0_nm, 64.0_nm).height;
    TickMemory memory;
    const auto at = [&](double height) {
        return tick(scene, inputAt({45.0_nm, 64.0_nm, bottom + height}), memory);
    };
    const ContactModel inGroove = contactModelAt(scene, at(3.0_nm).model);
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    const double jumpIn = inGroove.jumpInApproach(compliance);
    ASSERT_LT(jumpIn, scene.belief.contact.jumpInApproach(compliance) - 0.1_nm) << jumpIn;
    EXPECT_FALSE(at(1.05_nm - jumpIn).flags.has(Validity::SnapInAhead));
    EXPECT_TRUE(at(0.95_nm - jumpIn).flags.has(Validity::SnapInAhead));
}

TEST(HapticTick, WarnsOfSnapInJustBeforeIt) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const double jumpIn = scene.belief.contact.jumpInApproach(1.0 / 14.0);
    TickMemory memory;
    const auto flagsAt = [&](double beforeJump) {
        return tick(scene, inputAt({64.0_nm, 64.0_nm, beforeJump - jumpIn}), memory).flags;
    };
    EXPECT_FALSE(flagsAt(1.1_nm).has(Validity::SnapInAhead));
    EXPECT_TRUE(flagsAt(0.9_nm).has(Validity::SnapInAhead));
    EXPECT_FALSE(flagsAt(-0.1_nm).has(Validity::SnapInAhead)) << "it has snapped in";
}

/// Behind the pull-off a withdrawn tip is as near to the sample as one that comes.
TEST(HapticTick, WarnsOfNoSnapInWhileTheTipIsWithdrawn) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const double ahead = 0.9_nm - scene.belief.contact.jumpInApproach(1.0 / 14.0);
    for (const double step : {-0.01_nm, 0.0, 0.01_nm}) {
        TickMemory memory;
        (void)tick(scene, inputAt({64.0_nm, 64.0_nm, ahead}), memory);
        const TickOutput out = tick(scene, inputAt({64.0_nm, 64.0_nm, ahead + step}), memory);
        EXPECT_EQ(out.flags.has(Validity::SnapInAhead), !(step > 0.0)) << step;
    }
}

}  // namespace
}  // namespace asperity
