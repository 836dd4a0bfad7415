#include "core/haptics/coupling/CouplingKeeper.h"

#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "core/words/DeviceWords.h"
#include "tests/core/haptics/TestDevice.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace asperity {
namespace {

using test::kPhantom;

constexpr DeviceSpecification kMouse{};

Scene sceneOf(const std::function<void(SceneDescription&)>& change) {
    SceneDescription scene = test::plainScene();
    change(scene);
    return buildScene(scene, test::flatMap());
}

Scene plain() {
    return sceneOf([](SceneDescription&) {});
}

std::string refusal(const std::function<void()>& ask) {
    try {
        ask();
    } catch (const CouplingRefused& refused) {
        return refusalOf(refused.device);
    }
    return {};
}

TEST(CouplingKeeper, LeavesADeviceThatOnlySensesAlone) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    Settings knobs = keeper.takeOver(kMouse, 0.0, scene.settings);
    EXPECT_EQ(knobs.positionGain, 1.0);
    EXPECT_FALSE(knobs.coupling.couples());
    EXPECT_EQ(keeper.coupled(), nullptr);
    knobs.forceGain = 1e12;
    EXPECT_EQ(keeper.turned(knobs, 0.0).forceGain, 1e12);
    EXPECT_FALSE(keeper.follow(knobs, 1.0).has_value());
}

TEST(CouplingKeeper, MotorsAreNeverWithoutACouplingAndGetTheStandardScale) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    EXPECT_EQ(knobs.positionGain, 1e-6);
    EXPECT_EQ(knobs.forceGain, 1e8);
    EXPECT_EQ(knobs.coupling, designCoupling(kPhantom, {.timeStep = 1.0_ms, .delay = 1.0_ms}));
    ASSERT_NE(keeper.coupled(), nullptr);
    EXPECT_TRUE(keeper.coupled()->holds());
}

TEST(CouplingKeeper, TheScenesScaleCountsWhereItHolds) {
    const Scene scene = sceneOf([](SceneDescription& description) {
        description.settings.positionGain = 2e-7;
        description.settings.forceGain = 3e8;
    });
    CouplingKeeper keeper(scene);
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    EXPECT_EQ(knobs.positionGain, 2e-7);
    EXPECT_EQ(knobs.forceGain, 3e8);
}

TEST(CouplingKeeper, AScaleOfTheSceneThatIsTooStiffGivesWayToTheStandardOne) {
    const Scene scene = sceneOf([](SceneDescription& description) {
        description.settings.positionGain = 1e-5;
        description.settings.forceGain = 4e8;  // 14 N/m are 56 kN/m
    });
    CouplingKeeper keeper(scene);
    EXPECT_EQ(keeper.takeOver(kPhantom, 1.0_ms, scene.settings).positionGain, 1e-6);
}

TEST(CouplingKeeper, ASlowLoopGetsTheLargestForceGainThatHolds) {
    const Scene scene =
        sceneOf([](SceneDescription& description) { description.tickRate = 100.0; });
    CouplingKeeper keeper(scene);
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    EXPECT_LE(keeper.coupled()->judgment.contact, 600.0);  // 2 bp / T
    EXPECT_LT(knobs.forceGain, 1e8);
    Settings larger = knobs;
    larger.forceGain /= 0.8;
    EXPECT_NE(refusal([&] { static_cast<void>(keeper.turned(larger, 1.0_ms)); }), "");
}

TEST(CouplingKeeper, AnAdhesionThatNoScaleMakesHoldableIsRefusedWithTheNumber) {
    const Scene scene = sceneOf([](SceneDescription& description) {
        description.tip.radius = 10.0_um;
        description.sample.material.workOfAdhesion = 1.0;
        description.truth.material = description.sample.material;
    });
    CouplingKeeper keeper(scene);
    const std::string told =
        refusal([&] { static_cast<void>(keeper.takeOver(kPhantom, 1.0_ms, scene.settings)); });
    EXPECT_NE(told.find("adhesion at the device of "), std::string::npos) << told;
    EXPECT_EQ(keeper.coupled(), nullptr);
}

TEST(CouplingKeeper, TheEarlierGainsReturnWithADeviceThatSenses) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    Settings knobs = scene.settings;
    knobs.positionGain = 3.0;
    knobs.forceGain = 7.0;
    knobs = keeper.takeOver(kPhantom, 1.0_ms, knobs);
    knobs.correctionBandwidth = 5.0;
    knobs = keeper.takeOver(kMouse, 0.0, keeper.release(knobs));
    EXPECT_EQ(knobs.positionGain, 3.0);
    EXPECT_EQ(knobs.forceGain, 7.0);
    EXPECT_FALSE(knobs.coupling.couples());
    EXPECT_EQ(knobs.correctionBandwidth, 5.0) << "what a person turned meanwhile stays";
    EXPECT_EQ(keeper.coupled(), nullptr);
}

TEST(CouplingKeeper, AGainThatDoesNotHoldIsRefusedAndChangesNothing) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    Settings wanted = knobs;
    wanted.forceGain = 6e8;  // some 6 nN of adhesion are 3.6 N
    const std::string told = refusal([&] { static_cast<void>(keeper.turned(wanted, 1.0_ms)); });
    EXPECT_NE(told.find("reduce the force gain"), std::string::npos) << told;
    wanted.forceGain = 1e8;
    wanted.positionGain = 1e-5;  // 14 N/m are 14 kN/m
    EXPECT_NE(refusal([&] { static_cast<void>(keeper.turned(wanted, 1.0_ms)); }), "");
    const double before = keeper.coupled()->judgment.contact;
    EXPECT_LT(before, 1400.0);
    wanted.positionGain = 2e-6;
    EXPECT_EQ(keeper.turned(wanted, 1.0_ms).positionGain, 2e-6);
    EXPECT_NEAR(keeper.coupled()->judgment.contact, 2.0 * before, 1e-9 * before) << "judged again";
}

TEST(CouplingKeeper, TheTipUnderControlIsRefusedWhereItsContactAloneIsTooStiff) {
    const Scene scene = sceneOf([](SceneDescription& description) {
        description.sample.material.elastic = {.youngsModulus = 70e9, .poissonRatio = 0.17};
    });
    CouplingKeeper keeper(scene);
    Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    knobs.positionControl = PositionControl::Tip;
    EXPECT_NE(refusal([&] { static_cast<void>(keeper.turned(knobs, 1.0_ms)); }), "");
}

TEST(CouplingKeeper, AGuideIsJudgedBesideTheContact) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    knobs.guide = scene.description.settings.guide;
    knobs.guide.kind = FixtureKind::Point;
    knobs = keeper.turned(knobs, 1.0_ms);
    knobs.guide.damping = 5.0;  // more than the proxy's
    EXPECT_NE(refusal([&] { static_cast<void>(keeper.turned(knobs, 1.0_ms)); }), "");
}

TEST(CouplingKeeper, TheDeviceGetsTheEdgeOfItsWorkspaceAndOtherDevicesNone) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    DeviceSpecification device = kPhantom;
    device.workspaceRadius = 0.1;
    const Settings knobs = keeper.takeOver(device, 5.0_ms, scene.settings);
    EXPECT_EQ(knobs.workspace.radius, 0.1);
    EXPECT_NEAR(knobs.workspace.stiffness, 0.3 / 5.5e-3, 1e-9) << "for the age of its force";
    EXPECT_EQ(keeper.release(knobs).workspace, Workspace{});
}

TEST(CouplingKeeper, ADelayThatGrowsHasTheGainsDesignedAnew) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    EXPECT_FALSE(keeper.follow(knobs, 1.0_ms).has_value());
    const std::optional<Settings> later = keeper.follow(knobs, 4.8_ms);
    ASSERT_TRUE(later.has_value());
    EXPECT_EQ(later->coupling, designCoupling(kPhantom, {.timeStep = 1.0_ms, .delay = 5.0_ms}));
    EXPECT_TRUE(later->forcesOn);
    EXPECT_FALSE(keeper.follow(*later, 4.9_ms).has_value()) << "in steps of half a millisecond";
}

TEST(CouplingKeeper, ADelayThatNoCouplingHoldsTakesTheForcesAwayUntilItIsShorter) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    const std::optional<Settings> off = keeper.follow(knobs, 9.0_ms);
    ASSERT_TRUE(off.has_value());
    EXPECT_FALSE(off->forcesOn);
    EXPECT_NE(keeper.coupled()->noCoupling.find("shorter delay"), std::string::npos);
    EXPECT_FALSE(keeper.follow(*off, 9.0_ms).has_value()) << "said once";
    Settings on = *off;
    on.forcesOn = true;
    EXPECT_NE(refusal([&] { static_cast<void>(keeper.turned(on, 9.0_ms)); }), "");
    EXPECT_EQ(refusal([&] { static_cast<void>(keeper.turned(*off, 9.0_ms)); }), "")
        << "to switch forces off is never refused";
    EXPECT_TRUE(keeper.turned(on, 2.0_ms).forcesOn);
    EXPECT_TRUE(keeper.coupled()->holds());
}

TEST(CouplingKeeper, ASampleThatTheDeviceCouldNotHoldIsRefused) {
    const Scene scene = plain();
    CouplingKeeper keeper(scene);
    SceneDescription sticky = scene.description;
    sticky.sample.material.workOfAdhesion = 0.5;
    const ProbeSystem tip = believedSystem(sticky, usualModel(sticky));
    EXPECT_EQ(refusal([&] { keeper.requireHolding(tip, scene.settings); }), "")
        << "a mouse feels nothing";
    const Settings knobs = keeper.takeOver(kPhantom, 1.0_ms, scene.settings);
    EXPECT_NE(refusal([&] { keeper.requireHolding(tip, knobs); }), "");
    EXPECT_EQ(refusal([&] { keeper.requireHolding(scene.belief, knobs); }), "");
}

}  // namespace
}  // namespace asperity
