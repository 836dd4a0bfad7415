#include "core/contact/displacement/SurfaceDisplacement.h"

#include "core/contact/laws/SplitLaw.h"
#include "core/contact/numerics/EllipticIntegrals.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectClose;
using test::paperPair;

TEST(SurfaceDisplacement, IsContinuousAcrossTheEdgesOfContactAndCohesion) {
    test::checkProperty([] {
        const ContactModel model(ContactLaw::Split, *test::adhesivePair());
        const double approach = *test::fraction() * model.pair().tipRadius;
        const ContactState state = model.equilibrium(approach, 0.0, {ContactBranch::Bonded});
        for (const double edge : {state.contactRadius, state.cohesiveRadius}) {
            RC_PRE(edge > 0.0);
            const double inside = surfaceDisplacement(model, state, edge * (1.0 - 1e-12));
            const double at = surfaceDisplacement(model, state, edge);
            const double outside = surfaceDisplacement(model, state, edge * (1.0 + 1e-12));
            const double size =
                std::abs(state.indentation) + (edge * edge / model.pair().tipRadius);
            RC_ASSERT(std::abs(inside - at) <= 1e-5 * size);
            RC_ASSERT(std::abs(outside - at) <= 1e-5 * size);
        }
    });
}

/// In contact the surface is the tip's: no gap, whatever lift the tail adds.
TEST(SurfaceDisplacement, ClosesTheGapInContact) {
    for (const char* material : {"SiO2", "PS", "rubber"}) {
        const ContactModel model(ContactLaw::Split, paperPair(material));
        const ContactState state = model.equilibrium(0.0, 0.0, {ContactBranch::Bonded});
        ASSERT_GT(state.contactRadius, 0.0);
        const double radius = 0.7 * state.contactRadius;
        const double gap = (radius * radius / (2.0 * model.pair().tipRadius)) - state.indentation +
                           surfaceDisplacement(model, state, radius);
        EXPECT_NEAR(gap, 0.0, 1e-22);
    }
}

TEST(SurfaceDisplacement, ClosesTheGapUnderASphereWithATail) {
    for (const char* material : {"SiO2", "PS", "rubber"}) {
        const ContactModel model(ContactLaw::SphereSplit, paperPair(material));
        const ContactState state = model.equilibrium(0.0, 0.0, {ContactBranch::Bonded});
        ASSERT_GT(state.contactRadius, 0.0);
        const double radius = 0.7 * state.contactRadius;
        const double tip = model.pair().tipRadius;
        const double height = radius * radius / (tip + std::sqrt((tip - radius) * (tip + radius)));
        EXPECT_NEAR(height - state.indentation + surfaceDisplacement(model, state, radius), 0.0,
                    1e-22);
        EXPECT_NEAR(tailLift(model, state, 0.0), model.split()->tailLift,
                    1e-14 * model.split()->tailLift);
    }
}

/// At the edge of the cohesive zone the gap is its range.
TEST(SurfaceDisplacement, OpensTheGapToTheCohesiveRange) {
    const ContactModel model(ContactLaw::Split, paperPair("rubber"));
    const ContactState state = model.equilibrium(0.0, 0.0, {ContactBranch::Bonded});
    const double radius = state.cohesiveRadius;
    const double gap = (radius * radius / (2.0 * model.pair().tipRadius)) - state.indentation +
                       surfaceDisplacement(model, state, radius);
    const AdhesionSplit& split = *model.split();
    expectClose(gap, split.jointSeparation - kContactSeparation, 1e-9);
}

/// Far from its position any load pulls the surface as a point force does, u = P / (pi E* r).
TEST(SurfaceDisplacement, FallsOffAsThatOfAPointForce) {
    for (const char* material : {"SiO2", "PS"}) {
        const ContactModel model(ContactLaw::Split, paperPair(material));
        const AdhesionSplit& split = *model.split();
        const double far = 3e-5;
        const double factor = pi * model.pair().reducedModulus * far;
        const ContactState bonded = model.equilibrium(1e-10, 0.0, {ContactBranch::Bonded});
        // Of the tail's force the first-order lift takes Derjaguin's value.
        const double derjaguin = -split.hamaker * model.pair().tipRadius /
                                 (6.0 * split.jointSeparation * split.jointSeparation);
        expectClose(factor * surfaceDisplacement(model, bonded, far),
                    bonded.force - split.tailForce + derjaguin, 1e-3);
        const ContactState before = model.equilibrium(-2e-9, 0.0, {ContactBranch::Far});
        const double separation = model.tail()->attraction().separationAt(before.force);
        expectClose(factor * surfaceDisplacement(model, before, far),
                    -split.hamaker * model.pair().tipRadius / (6.0 * separation * separation),
                    1e-3);
    }
}

TEST(SurfaceDisplacement, IsTheLiftUnderTheTipBeforeSnapIn) {
    const ContactModel model(ContactLaw::Split, paperPair("PS"));
    const ContactState state = model.equilibrium(-1e-9, 0.0, {ContactBranch::Far});
    const AttractiveTail& tail = *model.tail();
    expectClose(surfaceDisplacement(model, state, 0.0),
                -tail.lift(tail.attraction().separationAt(state.force)), 1e-13);
}

TEST(SurfaceDisplacement, IsNoneWithoutForce) {
    const ContactModel split(ContactLaw::Split, paperPair("PS"));
    const ContactModel hertz(ContactLaw::Hertz, paperPair("PS"));
    EXPECT_EQ(surfaceDisplacement(split, ContactState{}, 1e-9), 0.0);
    EXPECT_EQ(surfaceDisplacement(hertz, hertz.equilibrium(-1e-9, 0.0, {ContactBranch::Far}), 1e-9),
              0.0);
}

/// Values that Carlson (1995) gives to 14 digits.
TEST(EllipticIntegrals, HaveTheirPublishedValues) {
    expectClose(carlsonRf(1.0, 2.0, 0.0), 1.3110287771461, 1e-13);
    expectClose(carlsonRf(0.5, 1.0, 0.0), 1.8540746773014, 1e-13);
    expectClose(carlsonRf(2.0, 3.0, 4.0), 0.58408284167715, 1e-13);
    expectClose(carlsonRd(0.0, 2.0, 1.0), 1.7972103521034, 1e-13);
    expectClose(carlsonRd(2.0, 3.0, 4.0), 0.16510527294261, 1e-13);
}

/// The complete integrals K and E for moduli close to 1, where K - E cancels.
TEST(EllipticIntegrals, StayExactForALargeModulus) {
    const double k = 0.999999;
    const double complement = (1.0 - k) * (1.0 + k);
    const double first = carlsonRf(0.0, complement, 1.0);
    expectClose(first, 7.94747977354796703, 1e-14);
    expectClose(first - (k * k / 3.0 * carlsonRd(0.0, complement, 1.0)), 1.00000744747772439,
                1e-14);
}

}  // namespace
}  // namespace asperity
