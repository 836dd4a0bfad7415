#include "core/Units.h"
#include "core/haptics/coupling/CouplingKeeper.h"
#include "core/scene/BelievedModel.h"
#include "core/words/DeviceWords.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

ProbeSystem polystyrene() {
    const SceneDescription scene = test::plainScene();
    return believedSystem(scene, usualModel(scene));
}

/// 1 mm : 1 nm and 1 N : 10 nN at a device of the Phantom class, felt up to 3 N.
DeviceRequest common() {
    return {.device = {.maxForce = 8.5,
                       .maxStiffness = 800.0,
                       .maxDamping = 8.0,
                       .effectiveMass = 0.075},
            .timing = {.timeStep = 1.0_ms, .delay = 1.0_ms},
            .scale = {.positionGain = 1e-6, .forceGain = 1e8},
            .own = {},
            .maxForce = 3.0};
}

TEST(CoupledDevice, GetsTheDesignedGainsAndFeelsLeverContactAndCouplingInSeries) {
    const CoupledDevice coupled = coupleDevice(polystyrene(), common());
    ASSERT_TRUE(coupled.holds()) << refusalOf(coupled);
    EXPECT_EQ(coupled.gains, designCoupling(common().device, common().timing));
    const double tip = tipLoad(polystyrene(), 30.0_nN).stiffness;
    const double felt = inSeries(100.0 * tip, 600.0);
    EXPECT_NEAR(coupled.judgment.felt, felt, 1e-9 * felt);
}

TEST(CoupledDevice, TheScenesOwnCouplingCountsWhereItHolds) {
    DeviceRequest request = common();
    request.own = {.stiffness = 300.0, .damping = 1.0, .proxyDamping = 2.0};
    EXPECT_EQ(coupleDevice(polystyrene(), request).gains, request.own);
    request.timing.delay = 6.0_ms;  // now Kc tau is 1.95, more than its damping
    EXPECT_EQ(coupleDevice(polystyrene(), request).gains,
              designCoupling(request.device, request.timing));
}

TEST(CoupledDevice, AnOwnCouplingTooLittleDampedForTheContactGivesWayToTheDesignedOne) {
    DeviceRequest request = common();
    request.own = {.stiffness = 300.0, .damping = 1.0, .proxyDamping = 0.2};  // bears 400 N/m
    EXPECT_EQ(coupleDevice(polystyrene(), request).gains.proxyDamping, 3.0);
}

TEST(CoupledDevice, TheLesserOfTheMotorsAndTheScenesLimitMustHoldTheAdhesion) {
    DeviceRequest request = common();
    request.maxForce = 0.5;  // polystyrene pulls with 6 nN
    const CoupledDevice limited = coupleDevice(polystyrene(), request);
    EXPECT_NE(refusalOf(limited).find("(500 mN)"), std::string::npos) << refusalOf(limited);
    request = common();
    request.device.maxForce = 0.4;
    const CoupledDevice weak = coupleDevice(polystyrene(), request);
    EXPECT_NE(refusalOf(weak).find("(400 mN)"), std::string::npos) << refusalOf(weak);
}

TEST(CoupledDevice, ADelayThatNoCouplingHoldsIsRefusedInTheWordsOfTheDesign) {
    DeviceRequest request = common();
    request.timing.delay = 8.0_ms;
    const CoupledDevice late = coupleDevice(polystyrene(), request);
    EXPECT_FALSE(late.holds());
    EXPECT_NE(refusalOf(late).find("173 N/m"), std::string::npos) << refusalOf(late);
}

}  // namespace
}  // namespace asperity
