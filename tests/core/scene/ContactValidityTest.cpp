#include "core/scene/TipValidity.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

bool isBeyondSphere(ContactLaw law, double coneHalfAngle, double contactRadius) {
    constexpr double kRadius = 30e-9;
    const ContactModel model(law, {kRadius, 1.33e6, 0.0}, {.coneHalfAngle = coneHalfAngle});
    const ContactState state{.contactRadius = contactRadius * kRadius,
                             .cohesiveRadius = contactRadius * kRadius,
                             .branch = ContactBranch::Bonded};
    return contactValidity(model, state, {.yields = false}).has(Validity::BeyondSphere);
}

/// A sphere alone ends at its equator; a shank of 0.3 rad would touch from 0.955 radii on.
TEST(ContactValidity, SaysWhereTheShankWouldTouch) {
    EXPECT_FALSE(isBeyondSphere(ContactLaw::Sneddon, 0.0, 0.95));
    EXPECT_TRUE(isBeyondSphere(ContactLaw::Sneddon, 0.0, 0.96));
    EXPECT_TRUE(isBeyondSphere(ContactLaw::SphereSplit, 0.0, 0.999));
    EXPECT_FALSE(isBeyondSphere(ContactLaw::Sneddon, 0.3, 2.0)) << "the cone goes on";
    EXPECT_FALSE(isBeyondSphere(ContactLaw::Hertz, 0.0, 0.96)) << "a paraboloid has no end";
}

}  // namespace
}  // namespace asperity
