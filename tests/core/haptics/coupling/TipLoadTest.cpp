#include "core/Units.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/scene/BelievedModel.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

SceneDescription sceneWith(ContactLaw law) {
    SceneDescription scene = test::plainScene();
    scene.choices.law = law;
    return scene;
}

ProbeSystem systemOf(const SceneDescription& scene) {
    return believedSystem(scene, usualModel(scene));
}

double leverOf(const ProbeSystem& system) { return 1.0 / system.cantilever.compliance()(2, 2); }

TEST(TipLoad, WithTheTipUnderControlTheDeviceMeetsTheContactAlone) {
    const ProbeSystem system = systemOf(sceneWith(ContactLaw::Hertz));
    const double lever = 1.0 / system.cantilever.compliance()(2, 2);
    const double base = tipLoad(system, 10.0_nN).stiffness;
    const double tip = tipLoad(system, 10.0_nN, PositionControl::Tip).stiffness;
    EXPECT_NEAR(inSeries(lever, tip), base, 1e-12 * base);
    EXPECT_GT(tip, base);
}

TEST(TipLoad, IsLeverAndContactInSeries) {
    const ProbeSystem hertz = systemOf(sceneWith(ContactLaw::Hertz));
    constexpr double kForce = 100.0_nN;
    // dF/d(delta) = (6 E*^2 R F)^(1/3)
    const ContactPair& pair = hertz.contact.pair();
    const double contact =
        std::cbrt(6.0 * pair.reducedModulus * pair.reducedModulus * pair.tipRadius * kForce);
    const double expected = leverOf(hertz) * contact / (leverOf(hertz) + contact);
    // The indentation, 1.6 nm, is 1.6e-5 of the way by which a thousand meters per newton press.
    EXPECT_NEAR(tipLoad(hertz, kForce).stiffness, expected, 1e-5 * expected);
}

TEST(TipLoad, AHarderPressIsStifferUpToTheLever) {
    const ProbeSystem system = systemOf(test::plainScene());
    const double soft = tipLoad(system, 1.0_nN).stiffness;
    const double hard = tipLoad(system, 1000.0_nN).stiffness;
    EXPECT_LT(soft, hard);
    EXPECT_LT(hard, leverOf(system));
}

TEST(TipLoad, TheSampleHoldsBackByThePullOffForceOfItsLaw) {
    const double unit = std::numbers::pi * 0.066 * 15.0_nm;  // pi w R [N]
    EXPECT_EQ(tipLoad(systemOf(sceneWith(ContactLaw::Hertz)), 1.0_nN).adhesion, 0.0);
    EXPECT_NEAR(tipLoad(systemOf(sceneWith(ContactLaw::Dmt)), 1.0_nN).adhesion, 2.0 * unit,
                1e-6 * unit);
    EXPECT_NEAR(tipLoad(systemOf(sceneWith(ContactLaw::Jkr)), 1.0_nN).adhesion, 1.5 * unit,
                1e-3 * unit);
}

TEST(TipLoad, AMeniscusHoldsBackToo) {
    SceneDescription wet = sceneWith(ContactLaw::Dmt);
    wet.meniscus = {.surfaceTension = 0.072, .contactAngle = 0.0, .range = 1.0_nm};
    const double dry = tipLoad(systemOf(sceneWith(ContactLaw::Dmt)), 1.0_nN).adhesion;
    const double bridge = 4.0 * std::numbers::pi * 15.0_nm * 0.072;
    EXPECT_NEAR(tipLoad(systemOf(wet), 1.0_nN).adhesion, dry + bridge, 1e-6 * bridge);
}

}  // namespace
}  // namespace asperity
