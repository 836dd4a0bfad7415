#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectClose;
using test::expectPoint;
using test::ReferenceTable;

constexpr double kTableTolerance = 1e-11;

/// Whether the cohesive zone of this state ends at the tip's equator.
bool wrapsTip(const LawPoint& point, double tipRadius) { return point.cohesiveRadius >= tipRadius; }

TEST(SphereLaws, HaveTheReferenceStates) {
    const ReferenceTable table = test::referenceTable("T13_sphere_exact.csv");
    ASSERT_EQ(table.rows(), 32U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const ContactPair pair{cell("R_m"), cell("Es_Pa"), cell("w")};
        const MaugisUnits units = maugisUnits(pair);
        const double a = cell("a_m");
        expectPoint(SneddonLaw(pair).at(a), cell("sn_delta_m"), cell("sn_P_N"), {},
                    kTableTolerance);
        expectPoint(SphereJkrLaw(pair).at(a), cell("jkr_delta_m"), cell("jkr_P_N"), units,
                    kTableTolerance);
        const SphereMaugisLaw maugis(pair, cell("s0_Pa"));
        const LawPoint point = maugis.at(a);
        expectPoint(point, cell("md_delta_m"), cell("md_P_N"), units, kTableTolerance);
        expectClose(point.cohesiveRadius, cell("md_c_m"), 1e-11);
        EXPECT_FALSE(wrapsTip(point, pair.tipRadius));
        ContactPair paraboloid = pair;
        expectClose(a * a / paraboloid.tipRadius, cell("para_delta_m"), 1e-12);
        expectClose(HertzLaw(paraboloid).atContactRadius(a).force, cell("para_P_N"), 1e-12);
    }
}

/// The stable states among them are found again from their indentation.
TEST(SphereLaws, FindTheReferenceStatesByIndentation) {
    const ReferenceTable table = test::referenceTable("T13_sphere_exact.csv");
    int found = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const ContactPair pair{cell("R_m"), cell("Es_Pa"), cell("w")};
        const MaugisUnits units = maugisUnits(pair);
        const double a = cell("a_m");
        const auto plain = SneddonLaw(pair).stable(cell("sn_delta_m"), 0.0);
        ASSERT_TRUE(plain);
        expectPoint(*plain, cell("sn_delta_m"), cell("sn_P_N"), {}, kTableTolerance);
        expectClose(plain->contactRadius, a, 1e-11);
        const SphereJkrLaw jkr(pair);
        if (a > jkr.fold(0.0).contactRadius) {
            const auto state = jkr.stable(cell("jkr_delta_m"), 0.0);
            ASSERT_TRUE(state);
            expectPoint(*state, cell("jkr_delta_m"), cell("jkr_P_N"), units, kTableTolerance);
            ++found;
        }
        const SphereMaugisLaw maugis(pair, cell("s0_Pa"));
        if (a > maugis.fold(0.0).contactRadius) {
            const auto state = maugis.stable(cell("md_delta_m"), 0.0);
            ASSERT_TRUE(state);
            expectPoint(*state, cell("md_delta_m"), cell("md_P_N"), units, kTableTolerance);
            expectClose(state->cohesiveRadius, cell("md_c_m"), 1e-11);
            ++found;
        }
    }
    EXPECT_GT(found, 40);
}

TEST(SphereJkrLaw, FoldsWhereTheReferenceDoes) {
    const ReferenceTable table = test::referenceTable("T13c_sphere_jkr_critical.csv");
    ASSERT_EQ(table.rows(), 14U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const double omega = cell("omega");
        const SphereJkrLaw law({1.0, 1.0, omega});
        const LawPoint pullOff = law.fold(1e14);
        expectClose(pullOff.force, cell("po_P"), 1e-11);
        expectClose(pullOff.force / (pi * omega), cell("po_Pn"), 1e-11);
        expectClose(pullOff.indentation, cell("po_delta"), 1e-11);
        expectClose(pullOff.contactRadius, cell("po_a"), 1e-11);
        const LawPoint jumpOff = law.fold(0.0);
        expectClose(jumpOff.force, cell("do_P"), 1e-11);
        expectClose(jumpOff.indentation, cell("do_delta"), 1e-11);
        expectClose(jumpOff.contactRadius, cell("do_a"), 1e-11);
        const auto unloaded = law.stable(cell("z_delta"), 0.0);
        ASSERT_TRUE(unloaded);
        expectClose(unloaded->contactRadius, cell("z_a"), 1e-11);
        expectClose(unloaded->force, 0.0, 1e-11, pi * omega);
        EXPECT_FALSE(law.stable(jumpOff.indentation * (1.0 + 1e-12), 0.0));
    }
}

/// A very long cohesion range on a very small tip: the zone reaches the equator before contact.
SphereMaugisLaw wrappedTip() { return {{1e-10, 1e10, 0.05}, 0.05 / 0.36e-9}; }

TEST(SphereMaugisLaw, EndsItsZoneAtTheEquator) {
    const SphereMaugisLaw law = wrappedTip();
    const auto state = law.stable(-1e-10, 0.0);
    ASSERT_TRUE(state);
    EXPECT_TRUE(wrapsTip(*state, 1e-10));
    EXPECT_EQ(state->contactRadius, 0.0);
    expectClose(state->force, -pi * (0.05 / 0.36e-9) * 1e-20, 1e-14);
    EXPECT_EQ(state->stiffness, 0.0);
    // Deep in, any tip is wrapped: the gap at its equator closes with the contact's edge.
    const ContactPair polystyrene = test::paperPair("PS");
    const SphereMaugisLaw deep(polystyrene, polystyrene.workOfAdhesion / 0.357e-9);
    const auto pressed = deep.stable(10.0 * polystyrene.tipRadius, 0.0);
    ASSERT_TRUE(pressed);
    EXPECT_TRUE(wrapsTip(*pressed, polystyrene.tipRadius));
    EXPECT_FALSE(wrapsTip(*deep.stable(polystyrene.tipRadius, 0.0), polystyrene.tipRadius));
}

LawPoint paraboloidMaugis(const ContactPair& pair, double stress, double indentation) {
    const MaugisUnits units = maugisUnits(pair);
    const MaugisDugdale law(transitionParameter(units, stress));
    const auto point = law.stable(MaugisControl::displacement(), indentation / units.indentation);
    return {.force = point->force * units.force,
            .indentation = indentation,
            .contactRadius = point->contactRadius * units.radius,
            .cohesiveRadius = point->cohesiveRadius * units.radius};
}

/// Their difference falls with the square of the contact's (or the cohesive zone's) radius over R.
TEST(SphereLaws, BecomeTheParaboloidForSmallContacts) {
    for (const double radius : {1e-8, 1e-6, 1e-4, 100.0}) {
        const ContactPair pair{radius, 1e12, 1e-3};
        const double stress = 1e-3 / 3e-10;
        const double indentation = 1e-11;
        const double strain = (indentation / radius) + 1e-11;  // (a / R)^2 and rounding
        const auto plain = SneddonLaw(pair).stable(indentation, 0.0);
        const double force = HertzLaw(pair).atIndentation(indentation).force;
        expectClose(plain->force, force, strain);
        const LawPoint expected = paraboloidMaugis(pair, stress, indentation);
        const auto maugis = SphereMaugisLaw(pair, stress).stable(indentation, 0.0);
        const double size = force + maugisUnits(pair).force;
        const double zone = std::pow(expected.cohesiveRadius / radius, 2) + 1e-11;
        EXPECT_NEAR(maugis->force, expected.force, zone * size);
        expectClose(maugis->contactRadius, expected.contactRadius, zone);
        expectClose(maugis->cohesiveRadius, expected.cohesiveRadius, zone);
    }
}

TEST(SphereJkrLaw, BecomesTheParaboloidForSmallContacts) {
    const ContactPair pair{1.0, 1.0, 1e-12};
    const MaugisUnits units = maugisUnits(pair);
    const SphereJkrLaw law(pair);
    const LawPoint pullOff = law.fold(1e14);
    expectClose(pullOff.force / units.force, -1.5, 1e-7);
    expectClose(pullOff.contactRadius / units.radius, std::cbrt(1.5), 1e-7);
    const LawPoint jumpOff = law.fold(0.0);
    expectClose(jumpOff.force / units.force, -5.0 / 6.0, 1e-7);
    expectClose(jumpOff.indentation / units.indentation, -3.0 * std::pow(6.0, -2.0 / 3.0), 1e-7);
}

/// The difference falls with the square of the range, as in docs/theory.md 2.5 with the paraboloid.
TEST(SphereMaugisLaw, BecomesJkrForCohesionOfNoRange) {
    for (const double omega : {1e-6, 1e-2, 1.0}) {
        const ContactPair pair{1.0, 1.0, omega};
        const SphereJkrLaw jkr(pair);
        const SphereMaugisLaw maugis(pair, 1e5 * std::sqrt(omega) * (1.0 + std::cbrt(omega)));
        for (const double compliance : {0.0, 1.0, 1e14}) {
            const LawPoint limit = jkr.fold(compliance);
            const LawPoint fold = maugis.fold(compliance);
            expectClose(fold.force, limit.force, 1e-6);
            expectClose(fold.indentation, limit.indentation, 1e-6);
            expectClose(fold.contactRadius, limit.contactRadius, 1e-6);
        }
        const double approach = 0.3 + (10.0 * omega);
        expectClose(maugis.stable(approach, 0.0)->force, jkr.stable(approach, 0.0)->force, 1e-4);
    }
}

/// Folds of the cohesive law in units of the sphere, computed with 30 digits by minimizing
/// indentation + compliance * force over the contact radius of docs/theory.md 4.4.
struct SphereFold {
    double cohesion;    ///< 2 sigma0 / E*
    double range;       ///< h0 / R
    double compliance;  ///< times E* R
    double contactRadius;
    double cohesiveRadius;
    double indentation;
    double force;
};

constexpr std::array<SphereFold, 9> kFolds{
    {{2.0, 0.1, 0.0, 0.27089819241272, 0.34453216470647, -0.35048940508191706,
      -0.24613190708689955},
     {2.0, 0.1, 1.0, 0.43124564818231, 0.49998528052534, -0.30702580941377949,
      -0.36749473412509381},
     {2.0, 0.1, 1e14, 0.54230225846686, 0.60802559092278, -0.22052087181257279,
      -0.40144003311087724},
     {0.5, 0.05, 0.0, 0.071402870854718, 0.2081760663837, -0.092666791112638955,
      -0.032945760194300497},
     {0.5, 0.05, 1.0, 0.15531729534722, 0.27035725558403, -0.086325061035254941,
      -0.04718185929980817},
     {0.5, 0.05, 1e14, 0.27639979566706, 0.37609353725328, -0.049087326695414297,
      -0.058893636716863169},
     {20.0, 0.5, 0.0, 0.76173184123521, 0.80042280840403, -4.1549797986668664, -6.926698489245613},
     {20.0, 0.5, 1.0, 0.88268555516405, 0.92027017794147, -3.9812917226497518, -7.8666112175033053},
     {20.0, 0.5, 1e14, 0.90564110978543, 0.94271868457427, -3.8748123147278559,
      -7.9136808977002953}}};

/// A tip and a sample of radius and modulus 1.
SphereMaugisLaw unitLaw(double cohesion, double range) {
    const double stress = cohesion / 2.0;
    return {{1.0, 1.0, stress * range}, stress};
}

TEST(SphereMaugisLaw, FoldsWhereHighPrecisionDoes) {
    for (const SphereFold& expected : kFolds) {
        const SphereMaugisLaw law = unitLaw(expected.cohesion, expected.range);
        const LawPoint fold = law.fold(expected.compliance);
        expectClose(fold.contactRadius, expected.contactRadius, 1e-11);
        expectClose(fold.cohesiveRadius, expected.cohesiveRadius, 1e-11);
        expectClose(fold.indentation, expected.indentation, 1e-11);
        expectClose(fold.force, expected.force, 1e-11);
    }
}

/// Work from separate bodies: the integral of force over indentation along the curve, 25 digits.
TEST(SphereMaugisLaw, HasTheWorkAlongTheCurveAsEnergy) {
    const auto energy = [](const SphereMaugisLaw& law, double a) { return law.energy(law.at(a)); };
    expectClose(energy(unitLaw(0.16, 0.024), 0.3), -0.000273549919541894, 1e-12);
    expectClose(energy(unitLaw(2.0, 0.1), 0.7), -0.119281763901668, 1e-12);
    expectClose(energy(unitLaw(0.5, 0.7), 0.4), -0.241397279066586, 1e-12);
}

TEST(SphereMaugisLaw, DetachesBeforeItJumpsWhereCohesionIsWeak) {
    // 1 - cos(beta), tan(beta) = 2/pi * cohesion: the smallest indentation without contact.
    const SphereMaugisLaw law = unitLaw(0.02, 0.05);
    const LawPoint fold = law.fold(0.0);
    const double tangent = 0.04 / pi;
    EXPECT_EQ(fold.contactRadius, 0.0);
    expectClose(fold.cohesiveRadius, std::sin(std::atan(tangent)), 1e-14);
    expectClose(fold.force, -pi * 0.01 * std::pow(fold.cohesiveRadius, 2), 1e-13);
}

TEST(SphereMaugisLaw, StaysContinuousWhereItsZoneReachesTheEquator) {
    const SphereMaugisLaw law = unitLaw(2.0, 0.1);
    double low = 0.7;
    double high = 1.0 - 1e-9;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (wrapsTip(law.at(middle), 1.0) ? high : low) = middle;
    }
    const LawPoint before = law.at(low - 1e-12);
    const LawPoint after = law.at(high + 1e-12);
    EXPECT_LT(before.cohesiveRadius, 1.0);
    EXPECT_TRUE(wrapsTip(after, 1.0));
    expectClose(after.indentation, before.indentation, 1e-9);
    expectClose(after.force, before.force, 1e-9);
    expectClose(law.energy(after), law.energy(before), 1e-9);
}

TEST(SphereLaws, FindTheirStatesWithoutAllocating) {
    const ContactPair pair = test::paperPair("PS");
    const SneddonLaw sneddon(pair);
    const SphereJkrLaw jkr(pair);
    const std::size_t before = test::allocationCount();
    const SphereMaugisLaw maugis(pair, pair.workOfAdhesion / 0.357e-9);
    double force = 0.0;
    for (int i = -100; i < 100; ++i) {
        const double approach = 1e-11 * i;
        for (const auto& state : {sneddon.stable(approach, 0.07), jkr.stable(approach, 0.07),
                                  maugis.stable(approach, 0.07)}) {
            force += state ? state->force + maugis.energy(*state) : 0.0;
        }
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(std::isfinite(force));
}

TEST(GaussLegendre, IntegratesPolynomialsExactly) {
    for (const int degree : {0, 1, 8, 30, 31}) {
        const double integral =
            gaussLegendre([degree](double x) { return std::pow(x, degree); }, 0.5, 1.5);
        expectClose(integral,
                    (std::pow(1.5, degree + 1) - std::pow(0.5, degree + 1)) / (degree + 1), 1e-14);
    }
}

/// There the pull of the cohesive zone fades exponentially and the indentation levels off to the
/// depth, which a search in powers of the distance takes too long for.
TEST(SphereMaugisLaw, ATipThatSinksByManyRadiiIsInEquilibrium) {
    for (const double modulus : {0.1, 3.9, 10.0, 100.0}) {  // [Pa]
        const ContactModel model(
            ContactLaw::SphereMaugis,
            {.tipRadius = 0.448e-9, .reducedModulus = modulus, .workOfAdhesion = 0.001}, {});
        for (const double approach : {1e-9, 8e-9, 9e-9, 1.07e-8, 2e-8, 2e-7}) {
            for (const double compliance : {0.0, 85.8}) {
                const ContactState state =
                    model.equilibrium(approach, compliance, {ContactBranch::Bonded});
                EXPECT_NEAR(state.indentation + (compliance * state.force), approach,
                            1e-12 * approach)
                    << modulus << ' ' << approach;
            }
        }
    }
}

}  // namespace
}  // namespace asperity
