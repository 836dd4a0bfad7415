#include "core/probe/MaterialMaps.h"

#include "core/probe/ProbeSystem.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {
namespace {

constexpr Elastic kTip{.youngsModulus = 169e9, .poissonRatio = 0.27};
constexpr LocalMaterial kUsual{
    .youngsModulus = 2e9, .workOfAdhesion = 0.05, .frictionCoefficient = 0.3};

/// Two pixels of 10 nm side by side.
std::shared_ptr<const PixelField> pair(double left, double right) {
    const HeightMap map{.columns = 2,
                        .rows = 1,
                        .pitchX = 10e-9,
                        .pitchY = 10e-9,
                        .heights = {left, right},
                        .invalid = {}};
    return std::make_shared<const PixelField>(map, "Pa");
}

MaterialField fieldOf(MaterialMaps maps) { return {std::move(maps), kUsual, 0.4, kTip}; }

TEST(MaterialField, IsLinearBetweenPixelsAndTheUsualOneWithoutAMap) {
    const MaterialField field =
        fieldOf({.youngsModulus = pair(1e9, 3e9), .workOfAdhesion = nullptr, .friction = nullptr});
    const LocalMaterial between = field.at(12.5e-9, 3e-9);
    EXPECT_NEAR(between.youngsModulus, 2.5e9, 1.0);
    EXPECT_EQ(between.workOfAdhesion, kUsual.workOfAdhesion);
    EXPECT_EQ(between.frictionCoefficient, kUsual.frictionCoefficient);
    EXPECT_EQ(field.at(-1.0, 0.0).youngsModulus, 1e9) << "the nearest pixel of the scan";
    EXPECT_EQ(field.reducedModulus(field.at(0.0, 0.0)),
              reducedModulus({.youngsModulus = 1e9, .poissonRatio = 0.4}, kTip));
}

TEST(MaterialField, TellsWhereItVariesWithinAContact) {
    const MaterialField field = fieldOf(
        {.youngsModulus = nullptr, .workOfAdhesion = pair(0.04, 0.06), .friction = nullptr});
    EXPECT_FALSE(field.variesWithin(10e-9, 5e-9, 1e-9)) << "4 % of it";
    EXPECT_TRUE(field.variesWithin(10e-9, 5e-9, 3e-9)) << "12 % of it";
    EXPECT_FALSE(field.variesWithin(1e-9, 5e-9, 3e-9)) << "outside the outermost centers";
}

TEST(ProbeSystem, HasThePairOfThePlace) {
    ProbeSystem system{
        .contact = ContactModel(ContactLaw::Maugis, {15e-9, 2.3e9, 0.06}),
        .cantilever = Cantilever(test::plainScene().probe),
        .friction = {.coefficient = 0.5, .shearStrength = 1e6},
    };
    EXPECT_EQ(system.pairAt(Vector3::Zero(), 8e-9).reducedModulus, 2.3e9);
    EXPECT_EQ(system.frictionAt(Vector3::Zero()), system.friction);
    system.field =
        std::make_shared<const MaterialField>(MaterialMaps{.youngsModulus = pair(1e9, 3e9),
                                                           .workOfAdhesion = pair(0.0, 0.06),
                                                           .friction = pair(0.1, 0.5)},
                                              kUsual, 0.4, kTip);
    const ContactPair left = system.pairAt(Vector3(1e-9, 5e-9, 0.0), 8e-9);
    EXPECT_EQ(left.tipRadius, 8e-9);
    EXPECT_EQ(left.reducedModulus,
              reducedModulus({.youngsModulus = 1e9, .poissonRatio = 0.4}, kTip));
    EXPECT_EQ(left.workOfAdhesion, 0.0);
    const Friction friction = system.frictionAt(Vector3(1e-9, 5e-9, 0.0));
    EXPECT_NEAR(friction.coefficient, 0.1, 1e-8);
    EXPECT_EQ(friction.shearStrength, 1e6);
}

}  // namespace
}  // namespace asperity
