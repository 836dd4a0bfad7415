#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/ConeMaugisLaw.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectClose;
using test::expectPoint;
using test::ReferenceTable;

constexpr ContactPair kUnit{1.0, 1.0, 0.05};

void expectSame(const LawPoint& point, const LawPoint& other, double tolerance, double indentation,
                double force) {
    expectPoint(point, other.indentation, other.force, {.force = force, .indentation = indentation},
                tolerance);
    expectClose(point.contactRadius, other.contactRadius, tolerance);
    expectClose(point.cohesiveRadius, other.cohesiveRadius, tolerance);
    expectClose(point.stiffness, other.stiffness, 10.0 * tolerance, 2.0 * other.contactRadius);
}

/// As long as contact and zone end on the sphere, the cone makes no difference.
TEST(ConeMaugis, IsTheSphereBelowTheJoint) {
    for (const double stress : {0.3, 0.5, 5.0, 500.0}) {
        const SphereMaugisLaw sphere(kUnit, stress);
        const ConeMaugisLaw cone(kUnit, stress, 0.2);
        const double joint = std::cos(0.2);
        int compared = 0;
        for (double a = 0.01; a < joint; a += 0.02) {
            const LawPoint expected = sphere.at(a);
            if (expected.cohesiveRadius < joint) {
                SCOPED_TRACE(::testing::Message() << "stress " << stress << ", a " << a);
                expectSame(cone.at(a), expected, 1e-10, 1.0, 1.0);
                expectClose(cone.energy(cone.at(a)), sphere.energy(expected), 1e-9, 1e-3);
                ++compared;
            }
        }
        EXPECT_GT(compared, 5) << stress;
        const double touch = std::min(sphere.at(0.0).cohesiveRadius, joint);
        for (const double part : {0.1, 0.5, 0.99}) {
            const LawPoint expected = sphere.apart(part * touch);
            expectSame(cone.apart(part * touch), expected, 1e-12, 1.0, 1.0);
            expectClose(cone.energy(cone.apart(part * touch)), sphere.energy(expected), 1e-11,
                        1e-6);
        }
    }
}

TEST(ConeMaugis, HasTheReferenceStatesOfASphere) {
    constexpr double kHalfAngle = 0.02;
    const ReferenceTable table = test::referenceTable("T13_sphere_exact.csv");
    int found = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const ContactPair pair{cell("R_m"), cell("Es_Pa"), cell("w")};
        const double joint = pair.tipRadius * std::cos(kHalfAngle);
        if (cell("md_c_m") > joint) {
            continue;
        }
        const LawPoint point = ConeMaugisLaw(pair, cell("s0_Pa"), kHalfAngle).at(cell("a_m"));
        const double lift = 2.0 * cell("s0_Pa") / pair.reducedModulus * cell("md_c_m");
        const double pull = pi * cell("w") * pair.tipRadius;
        expectPoint(point, cell("md_delta_m"), cell("md_P_N"), {.force = pull, .indentation = lift},
                    1e-10);
        expectClose(point.cohesiveRadius, cell("md_c_m"), 1e-10);
        ++found;
    }
    EXPECT_GT(found, 25);
}

/// A short range is JKR's: at the same contact radius the difference falls with its square.
TEST(ConeMaugis, BecomesJkrForAShortRange) {
    constexpr double kStress = 1e6;  // in E*
    const ReferenceTable table = test::referenceTable("T25_cone_sphere.csv");
    int compared = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double work = table.number(row, "w");
        if (work == 0.0) {
            continue;
        }
        const double halfAngle = table.number(row, "alpha_deg") * pi / 180.0;
        const double a = table.number(row, "a");
        SCOPED_TRACE(::testing::Message() << halfAngle << " rad, a " << a << ", w " << work);
        const LawPoint point = ConeMaugisLaw({1.0, 1.0, work}, kStress, halfAngle).at(a);
        const double lift = std::sqrt(2.0 * pi * a * work);
        expectPoint(point, table.number(row, "delta"), table.number(row, "P"),
                    {.force = 2.0 * a * lift, .indentation = lift}, 1e-9);
        ++compared;
    }
    EXPECT_GT(compared, 200);
}

/// By the surface outside the contact, which the law itself does not compute.
TEST(ConeMaugis, LeavesTheRangeAtTheEdgeOfItsZone) {
    for (const double halfAngle : {0.17, 0.35, 0.8, 1.3}) {
        for (const double stress : {0.05, 0.5, 5.0}) {
            const ContactModel model(ContactLaw::SphereMaugis, kUnit,
                                     {.cohesiveStress = stress, .coneHalfAngle = halfAngle});
            const ConeMaugisLaw law(kUnit, stress, halfAngle);
            for (const double a : {0.1, 0.7, 0.99, 1.05, 2.0, 20.0}) {
                const LawPoint point = law.at(a);
                const CohesiveContact profile =
                    contactProfile(model, {.force = point.force,
                                           .indentation = point.indentation,
                                           .contactRadius = point.contactRadius,
                                           .cohesiveRadius = point.cohesiveRadius,
                                           .branch = ContactBranch::Bonded});
                SCOPED_TRACE(::testing::Message()
                             << halfAngle << " rad, stress " << stress << ", a " << a);
                const double rounding = 1e-13 * (std::abs(point.indentation) + a + stress);
                EXPECT_NEAR(surfaceGap(profile, point.cohesiveRadius),
                            kUnit.workOfAdhesion / stress,
                            (1e-9 * kUnit.workOfAdhesion / stress) + rounding);
            }
        }
    }
}

TEST(ConeMaugis, EnergyIsTheWorkOfItsForce) {
    for (const double halfAngle : {0.17, 0.35, 0.8, 1.4}) {
        for (const double stress : {0.02, 0.3, 30.0}) {
            const ConeMaugisLaw law(kUnit, stress, halfAngle);
            const auto expectWork = [&](const LawPoint& less, const LawPoint& here,
                                        const LawPoint& more, const char* name) {
                const double work = (less.force + (4.0 * here.force) + more.force) / 6.0 *
                                    (more.indentation - less.indentation);
                EXPECT_NEAR(law.energy(more) - law.energy(less), work,
                            (1e-4 * std::abs(work)) + (1e-9 * std::abs(law.energy(more))))
                    << halfAngle << " rad, stress " << stress << ", " << name;
                const double slope =
                    (more.force - less.force) / (more.indentation - less.indentation);
                EXPECT_NEAR(here.stiffness, slope, 1e-3 * std::abs(slope)) << name;
            };
            for (const double a : {0.5 * std::cos(halfAngle), 1.2, 5.0, 100.0}) {
                const double step = 1e-3 * a;
                expectWork(law.at(a - step), law.at(a), law.at(a + step), "contact");
            }
            const double c = 0.9 * law.at(0.0).cohesiveRadius;
            expectWork(law.apart(0.999 * c), law.apart(c), law.apart(1.001 * c), "apart");
        }
    }
}

/// The first touch has the same state from both sides.
TEST(ConeMaugis, TouchesWithoutAStep) {
    for (const double halfAngle : {0.17, 0.8, 1.4}) {
        for (const double stress : {0.01, 0.03, 0.3, 30.0}) {  // some zones reach the cone before
            const ConeMaugisLaw law(kUnit, stress, halfAngle);
            const LawPoint touch = law.at(0.0);
            const LawPoint apart = law.apart(touch.cohesiveRadius);
            SCOPED_TRACE(::testing::Message() << halfAngle << " rad, stress " << stress);
            expectSame(touch, apart, 1e-10, 1.0, 1e-3);
            expectClose(law.energy(touch), law.energy(apart), 1e-9, 1e-4);
        }
    }
}

/// ConeTip.HasTwoStretchesOfStableStates, for a range that is short but finite.
TEST(ConeMaugis, KeepsATipOnItsStretch) {
    constexpr double kSoft = 1e3;
    constexpr double kStep = 1.0;
    const double halfAngle = 17.5 * pi / 180.0;
    const ConeMaugisLaw law({1.0, 1.0, 3.0}, 300.0, halfAngle);
    const LawPoint last = law.fold(kSoft);
    const double end = last.indentation + (kSoft * last.force);
    EXPECT_FALSE(law.stable(end - kStep, kSoft));
    EXPECT_NEAR(end, -5658.1, 5.0);
    double coordinate = 0.0;
    double changed = 0.0;
    const auto follow = [&](double approach) {
        const auto state = law.stable(approach, kSoft, coordinate);
        ASSERT_TRUE(state);
        expectClose(state->indentation + (kSoft * state->force), approach, 1e-9, 1e4);
        const bool wasOut = coordinate > law.at(1.3).coordinate;
        if (wasOut != (state->contactRadius > 1.3)) {
            changed = approach;
        }
        coordinate = state->coordinate;
    };
    for (double approach = end + kStep; approach < end + 1e3; approach += 2.0 * kStep) {
        follow(approach);
    }
    EXPECT_NEAR(changed, -5281.9, 10.0);
    for (double approach = end + 1e3; approach > end + kStep; approach -= 2.0 * kStep) {
        follow(approach);
    }
    EXPECT_NEAR(changed, -5571.9, 10.0);
}

/// Any cone, adhesion, range and lever: above the fold there is a state that balances the lever,
/// and it grows with the approach.
TEST(ConeMaugis, HasAStableStateAboveItsFold) {
    test::checkProperty([] {
        const double halfAngle = *test::logUniform(0.05, 1.5);
        const ContactPair pair{1.0, 1.0, *test::logUniform(1e-9, 1e2)};
        const double stress =
            *test::logUniform(pair.workOfAdhesion / 10.0, pair.workOfAdhesion / 1e-6);
        const double soft = *rc::gen::element(0.0, 1e-3, 1.0, 1e3);
        const ConeMaugisLaw law(pair, stress, halfAngle);
        const LawPoint fold = law.fold(soft);
        const double end = fold.indentation + (soft * fold.force);
        const double above = *test::logUniform(1e-6, 1e4);
        const double size = std::abs(end) + above;
        RC_ASSERT(std::isfinite(end));
        RC_ASSERT(!law.stable(end - (1e-6 * size), soft));
        const auto state = law.stable(end + above, soft);
        RC_ASSERT(state.has_value());
        const double held = state->indentation + (soft * state->force);
        const double c = state->cohesiveRadius;
        const double parts = 2.0 * stress * c * (1.0 + (soft * 4.0 * c));
        RC_ASSERT(std::abs(held - (end + above)) <= 1e-10 * (size + parts));
        const auto next = law.stable(end + above + (1e-3 * size), soft, state->coordinate);
        RC_ASSERT(next.has_value());
        RC_ASSERT(next->contactRadius >= state->contactRadius);
    });
}

TEST(ConeMaugis, IsPartOfAContactModel) {
    const ContactPair rubber{30e-9, 1.33e6, 0.022};
    for (const ContactLaw law : {ContactLaw::SphereMaugis, ContactLaw::SphereSplit}) {
        const ContactModel cone(law, rubber, {.coneHalfAngle = 0.3});
        const ContactModel sphere(law, rubber);
        EXPECT_EQ(cone.coneHalfAngle(), 0.3);
        EXPECT_EQ(cone.cohesiveStress(), sphere.cohesiveStress());
        EXPECT_EQ(cone.lambda(), sphere.lambda());
        EXPECT_EQ(cone.jumpInApproach(0.1), sphere.jumpInApproach(0.1));
        const ContactState state = cone.equilibrium(300e-9, 0.0, kBondedMemory);
        EXPECT_GT(state.contactRadius, 1.2 * rubber.tipRadius);
        const ContactModel again = cone.withPair(rubber);
        EXPECT_EQ(again.equilibrium(300e-9, 0.0, kBondedMemory).force, state.force);
        const ContactModel sharper = cone.withTipRadius(10e-9);
        EXPECT_GT(sharper.equilibrium(300e-9, 0.0, kBondedMemory).contactRadius, 10e-9);
    }
}

TEST(ConeMaugis, AllocatesNothing) {
    const std::size_t before = test::allocationCount();
    const ConeMaugisLaw law({1.0, 1.0, 4.0}, 100.0, 0.3);
    const auto state = law.stable(2.0, 10.0);
    const LawPoint fold = law.fold(10.0);
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(state);
    EXPECT_GT(fold.contactRadius, 0.0);
}

}  // namespace
}  // namespace asperity
