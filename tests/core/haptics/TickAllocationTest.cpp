#include "core/Units.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticLoop.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/ZFeedback.h"
#include "core/probe/recorded/RecordedAfm.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/core/probe/recorded/AdhesiveCycle.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace asperity {
namespace {

/// Runs the approach of a scene and watches every tick of it.
void expectNoAllocation(const Scene& scene, AfmController& afm) {
    const DevicePath path = slidePath(scene, {.duration = 2.0});
    TickMemory memory;
    TickInput input;
    input.settings = scene.settings;
    bool touched = false;
    bool released = false;
    for (int i = 0; i <= 2000; ++i) {
        input.device.position = positionAt(path, i * 1e-3);
        const std::size_t before = test::allocationCount();
        input.measurement = afm.exchange(commandBase(scene, input, memory).base);
        const TickOutput output = tick(scene, input, memory);
        ASSERT_EQ(test::allocationCount(), before) << "tick " << i;
        ASSERT_EQ(output.fault, Fault::None) << "tick " << i;
        touched = touched || output.region() == TipRegion::Contact;
        released = touched && output.region() == TipRegion::Far;
    }
    EXPECT_TRUE(touched && released) << "the run must pass through all states";
}

void expectNoAllocation(const Scene& scene) {
    SimulatedAfm afm(scene.surface, truthOf(scene));
    expectNoAllocation(scene, afm);
}

TEST(TickAllocation, TickAndSimulatedInstrumentAllocateNothingInAnyState) {
    expectNoAllocation(buildScene(test::plainScene(), test::hillyMap()));
}

TEST(TickAllocation, NorDoesARecordedInstrument) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    RecordedAfm afm(playedCurve(test::adhesiveCycle(), 0.0), scene.trueSurface(),
                    scene.description.tip.radius, scene.belief.cantilever);
    expectNoAllocation(scene, afm);
}

TEST(TickAllocation, NorDoesANormalThatIsNotExact) {
    SceneDescription description = test::plainScene();
    description.uncertainty.surfaceNormal = 0.05;
    for (const DecouplingModel model : kValues<DecouplingModel>) {
        description.choices.decoupling = model;
        expectNoAllocation(buildScene(description, test::hillyMap()));
    }
}

TEST(TickAllocation, NorDoesAShape) {
    SceneDescription description = test::plainScene();
    description.sample.shape = ShapeDescription{.kind = ShapeKind::Sphere};
    expectNoAllocation(buildScene(description));
}

TEST(TickAllocation, NorDoesASampleOfSeveralMaterials) {
    const HeightMap scan = test::hillyMap();
    HeightMap values = scan;
    for (std::size_t i = 0; i < values.heights.size(); ++i) {
        values.heights[i] = 1e9 + 3e9 * static_cast<double>(i % 64) / 64.0;
    }
    const MaterialMaps maps{.youngsModulus = std::make_shared<const PixelField>(values, "Pa"),
                            .workOfAdhesion = nullptr,
                            .friction = nullptr};
    SceneDescription description = test::plainScene();
    description.sample.material.maps.youngsModulus =
        MapSource{.file = "modulus.gwy", .channel = "", .sha256 = ""};
    description.truth.material = description.sample.material;
    for (const SolverSetting solver : {SolverSetting::Newton, SolverSetting::Table}) {
        description.choices.solver = solver;
        expectNoAllocation(buildScene(description, scan, nullptr, {.sample = maps, .truth = maps}));
    }
}

TEST(TickAllocation, NorDoesAnyLawSolverOrControl) {
    SceneDescription description = test::plainScene();
    description.sample.material.filmThickness = 100.0_nm;
    description.truth.material = description.sample.material;
    description.settings.positionControl = PositionControl::Tip;
    description.choices.solver = SolverSetting::Table;
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(keyOf(law));
        description.choices.law = law;
        expectNoAllocation(buildScene(description, test::hillyMap()));
    }
    description.choices.law = ContactLaw::Split;
    description.truth.temperature = 300.0;
    description.meniscus = {.surfaceTension = 0.072, .contactAngle = 0.0, .range = 1.0_nm};
    expectNoAllocation(buildScene(description, test::hillyMap()));
}

TEST(TickAllocation, NorDoTwoWorksOfAdhesion) {
    SceneDescription description = test::plainScene();
    description.sample.material.retractWork = 1.5 * description.sample.material.workOfAdhesion;
    description.truth.material = description.sample.material;
    for (const ContactLaw law : {ContactLaw::Jkr, ContactLaw::SphereJkr}) {
        description.choices.law = law;
        expectNoAllocation(buildScene(description, test::hillyMap()));
    }
}

TEST(TickAllocation, NorDoRelaxationAndDrag) {
    SceneDescription description = test::plainScene();
    SampleMaterial& material = description.sample.material;
    material.workOfAdhesion = 0.0;
    material.relaxingModulus = material.elastic.youngsModulus;
    material.relaxationTime = 0.05;
    material.drag = 1e-15;
    material.dragOffset = 1e-8;
    description.truth.material = material;
    expectNoAllocation(buildScene(description, test::hillyMap()));
}

TEST(TickAllocation, NorDoesACoupling) {
    SceneDescription description = test::plainScene();
    description.settings.coupling = {.stiffness = 400.0, .damping = 3.0, .proxyDamping = 3.0};
    expectNoAllocation(buildScene(description, test::hillyMap()));
}

TEST(TickAllocation, NorDoesAGovernorWhateverBecomesOfTheForce) {
    SceneDescription description = test::plainScene();
    description.settings.coupling = {.stiffness = 400.0, .damping = 3.0, .proxyDamping = 3.0};
    description.settings.governor.deadManButton = 0;
    const Scene scene = buildScene(description, test::flatMap());
    TickMemory memory;
    TickInput input;
    input.settings = scene.settings;
    input.settings.workspace = {.radius = 60.0_nm, .stiffness = 200.0, .forceLimit = 2.0};
    input.settings.clutchButton = 1;
    input.settings.deviceTurn = {0.1, 0.2, 0.3};
    std::set<ForceState> states;
    for (int i = 0; i <= 3000; ++i) {
        input.device = {.position = {64.0_nm, 64.0_nm, i < 1500 ? 5.0_nm : -2.0_nm},
                        .buttons = i > 100 && i < 110 ? 3U : (i > 10 ? 1U : 0U),
                        .maxForce = i < 2000 ? 5.0 : 1e-12,
                        .streams = true,
                        .age = i < 2500 ? 0.0 : (i - 2500) * 1e-3};
        input.settings.forcesOn = i > 5;
        input.settings.guide.kind = static_cast<FixtureKind>(i / 100 % 4);
        const std::size_t before = test::allocationCount();
        const TickOutput output = tick(scene, input, memory);
        ASSERT_EQ(test::allocationCount(), before) << "tick " << i;
        states.insert(output.forceState);
    }
    EXPECT_EQ(states.size(), 8U) << "all but Waiting";
}

TEST(TickAllocation, NorDoSeveralClosestPoints) {
    const Scene scene = buildScene(test::plainScene(), test::ridgedMap(25.0_nm));
    TickMemory memory;
    TickInput input;
    bool several = false;
    for (int i = 0; i <= 400; ++i) {
        input.device.position = {40.0_nm + i * 25.0_pm, 64.0_nm, -17.0_nm};
        const std::size_t before = test::allocationCount();
        const TickOutput output = tick(scene, input, memory);
        ASSERT_EQ(test::allocationCount(), before) << "tick " << i;
        several = several || output.flags.has(Validity::SeveralContactPoints);
    }
    EXPECT_TRUE(several);
}

TEST(TickAllocation, TheRunningLoopAllocatesNothing) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    ScriptedDevice device(slidePath(scene, {.duration = 0.5}), scene.settings.positionGain);
    SimulatedAfm afm(scene.surface, truthOf(scene));
    HapticLoop loop(scene, device, afm);
    loop.start();
    while (loop.snapshot().statistics.ticks == 0) {
    }
    const std::size_t before = test::allocationCount();
    bool touched = false;
    while (loop.snapshot().statistics.ticks < 1010) {
        touched = touched || loop.snapshot().sample.output.region() == TipRegion::Contact;
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(touched);
}

TEST(TickAllocation, NorDoesAnApproachToTheSetpoint) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    ApproachDevice device(planApproach(scene, {.duration = 1.0}), scene.settings.positionGain);
    SimulatedAfm afm(scene.surface, truthOf(scene));
    std::size_t before = 0;
    runVirtually(scene, device, afm, 1001, [&](const TickSample& sample) {
        if (sample.time > 0.0) {
            ASSERT_EQ(test::allocationCount(), before) << "at " << sample.time << " s";
        }
        before = test::allocationCount();
    });
    EXPECT_TRUE(device.hasEngaged());
}

TEST(TickAllocation, NorDoesAFeedback) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const Vector3 base(40e-9, 60e-9, touchHeight(scene, 40e-9, 60e-9));
    const double gain = scene.settings.positionGain;
    FeedbackDevice device(
        std::make_unique<ScriptedDevice>(linesPath(base, {.length = 40e-9, .speed = 100e-9}), gain),
        {.lowest = base.z() - 1e-6, .highest = base.z() + 1e-6}, base.z(), gain);
    SimulatedAfm afm(scene.surface, truthOf(scene));
    std::size_t before = 0;
    runVirtually(scene, device, afm, 801, [&](const TickSample& sample) {
        if (sample.time > 0.0) {
            ASSERT_EQ(test::allocationCount(), before) << "at " << sample.time << " s";
        }
        before = test::allocationCount();
    });
    EXPECT_FALSE(device.hasStopped());
}

TEST(TickAllocation, CounterSeesOperatorNewAndEigen) {
    std::size_t before = test::allocationCount();
    const auto number = std::make_unique<int>(1);
    EXPECT_GT(test::allocationCount(), before);
    before = test::allocationCount();
    const Eigen::VectorXd vector = Eigen::VectorXd::Constant(*number + 99, 1.0);
    EXPECT_GT(test::allocationCount(), before) << vector.sum();
}

}  // namespace
}  // namespace asperity
