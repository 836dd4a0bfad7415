#include "core/contact/HertzLaw.h"
#include "core/contact/MaugisDugdale.h"
#include "core/contact/MaugisUnits.h"
#include "core/contact/SneddonLaw.h"
#include "core/contact/SphereJkrLaw.h"
#include "core/contact/SphereMaugisLaw.h"
#include "tests/core/contact/ContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <tuple>
#include <utility>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectClose;
using test::ReferenceTable;

/// Force and indentation against a table, relative to the Maugis units where they vanish.
void expectPoint(const LawPoint& point, double indentation, double force,
                 const MaugisUnits& units) {
    expectClose(point.indentation, indentation, 1e-11, units.indentation);
    expectClose(point.force, force, 1e-11, units.force);
}

TEST(SphereLaws, HaveTheReferenceStates) {
    const ReferenceTable table = test::referenceTable("T13_sphere_exact.csv");
    ASSERT_EQ(table.rows(), 32U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const ContactPair pair{cell("R_m"), cell("Es_Pa"), cell("w")};
        const MaugisUnits units = maugisUnits(pair);
        const double a = cell("a_m");
        expectPoint(SneddonLaw(pair).at(a), cell("sn_delta_m"), cell("sn_P_N"), {});
        expectPoint(SphereJkrLaw(pair).at(a), cell("jkr_delta_m"), cell("jkr_P_N"), units);
        const SphereMaugisLaw maugis(pair, cell("s0_Pa"));
        const LawPoint point = maugis.at(a);
        expectPoint(point, cell("md_delta_m"), cell("md_P_N"), units);
        expectClose(point.cohesiveRadius, cell("md_c_m"), 1e-11);
        EXPECT_FALSE(maugis.wrapsTip(point));
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
        expectPoint(*plain, cell("sn_delta_m"), cell("sn_P_N"), {});
        expectClose(plain->contactRadius, a, 1e-11);
        const SphereJkrLaw jkr(pair);
        if (a > jkr.fold(0.0).contactRadius) {
            const auto state = jkr.stable(cell("jkr_delta_m"), 0.0);
            ASSERT_TRUE(state);
            expectPoint(*state, cell("jkr_delta_m"), cell("jkr_P_N"), units);
            ++found;
        }
        const SphereMaugisLaw maugis(pair, cell("s0_Pa"));
        if (a > maugis.fold(0.0).contactRadius) {
            const auto state = maugis.stable(cell("md_delta_m"), 0.0);
            ASSERT_TRUE(state);
            expectPoint(*state, cell("md_delta_m"), cell("md_P_N"), units);
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
    EXPECT_TRUE(law.wrapsTip(*state));
    EXPECT_EQ(state->contactRadius, 0.0);
    expectClose(state->force, -pi * (0.05 / 0.36e-9) * 1e-20, 1e-14);
    EXPECT_EQ(state->stiffness, 0.0);
    // Deep in, any tip is wrapped: the gap at its equator closes with the contact's edge.
    const ContactPair polystyrene = test::paperPair("PS");
    const SphereMaugisLaw deep(polystyrene, polystyrene.workOfAdhesion / 0.357e-9);
    const auto pressed = deep.stable(10.0 * polystyrene.tipRadius, 0.0);
    ASSERT_TRUE(pressed);
    EXPECT_TRUE(deep.wrapsTip(*pressed));
    EXPECT_FALSE(deep.wrapsTip(*deep.stable(polystyrene.tipRadius, 0.0)));
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
    for (const double radius : {1e-8, 1e-6, 1e-4}) {
        const ContactPair pair{radius, 1e12, 1e-3};
        const double stress = 1e-3 / 3e-10;
        const double indentation = 1e-11;
        const double strain = indentation / radius;  // (a / R)^2
        const auto plain = SneddonLaw(pair).stable(indentation, 0.0);
        const double force = HertzLaw(pair).atIndentation(indentation).force;
        expectClose(plain->force, force, strain);
        EXPECT_GT(std::abs(plain->force - force), 0.01 * strain * force);
        const LawPoint expected = paraboloidMaugis(pair, stress, indentation);
        const auto maugis = SphereMaugisLaw(pair, stress).stable(indentation, 0.0);
        const double size = force + maugisUnits(pair).force;
        const double zone = std::pow(expected.cohesiveRadius / radius, 2);
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

/// The difference falls with the square of the range, as in physics.md 2.5 with the paraboloid.
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

/// Any tip, sample and range of cohesion the laws are made for.
struct AnySphere {
    ContactPair pair;
    double stress;
    double compliance;
};

void showValue(const AnySphere& sphere, std::ostream& stream) {
    showValue(sphere.pair, stream);
    stream << ", sigma0 " << sphere.stress << " Pa, compliance " << sphere.compliance << " m/N";
}

rc::Gen<AnySphere> anySphere() {
    using rc::gen::tuple;
    return rc::gen::map(tuple(test::logUniform(1e-10, 1e-3), test::logUniform(1.0, 1e13),
                              test::logUniform(1e-9, 100.0), test::logUniform(1e-11, 1e-8),
                              test::anyCompliance()),
                        [](const std::tuple<double, double, double, double, double>& p) {
                            const auto [radius, modulus, work, range, compliance] = p;
                            return AnySphere{{radius, modulus, work}, work / range, compliance};
                        });
}

/// From before snap-in to 10 tip radii deep, dense around the fold.
double anyApproach(double fold, double radius) {
    const double where = *test::fraction();
    switch (*rc::gen::inRange(0, 5)) {
    case 0:
        return fold * (1.0 + ((where - 0.5) * 1e-6));
    case 1:
        return fold + (where * std::abs(fold));
    case 2:
        return -1e-6 * where;
    case 3:
        return fold + (radius * *test::logUniform(1e-12, 10.0));
    default:
        return 10.0 * radius * where;
    }
}

bool isFinite(const LawPoint& point) {
    return std::isfinite(point.force) && std::isfinite(point.indentation) &&
           std::isfinite(point.contactRadius) && std::isfinite(point.cohesiveRadius) &&
           std::isfinite(point.stiffness);
}

/// Sum of what cancels in the balance of a state.
double sizeOf(const AnySphere& sphere, const LawPoint& point, double approach) {
    const double radius = sphere.pair.tipRadius;
    const double c = point.cohesiveRadius;
    const double pull =
        sphere.stress * 4.0 * c * std::sqrt((c - point.contactRadius) * (c + radius)) +
        (2.0 * pi * sphere.pair.workOfAdhesion * radius) +
        std::sqrt(8.0 * pi * std::pow(c, 3) * sphere.pair.workOfAdhesion *
                  sphere.pair.reducedModulus);
    const double lift = pull / sphere.pair.reducedModulus / std::max(c, 1e-30);
    return std::abs(approach) + std::abs(point.indentation) + lift +
           (sphere.compliance * (std::abs(point.force) + pull)) +
           (sphere.pair.workOfAdhesion / sphere.stress);
}

template <typename Law>
void expectEquilibria(const Law& law, const AnySphere& sphere) {
    const LawPoint fold = law.fold(sphere.compliance);
    RC_ASSERT(isFinite(fold));
    const double end = fold.indentation + (sphere.compliance * fold.force);
    const double approach = anyApproach(end, sphere.pair.tipRadius);
    const auto state = law.stable(approach, sphere.compliance);
    if (!state) {
        RC_ASSERT(approach <= end + (1e-13 * sizeOf(sphere, fold, approach)));
        return;
    }
    RC_ASSERT(isFinite(*state));
    RC_ASSERT(state->contactRadius >= 0.0);
    RC_ASSERT(state->contactRadius <= sphere.pair.tipRadius);
    RC_ASSERT(state->cohesiveRadius >= state->contactRadius);
    RC_ASSERT(state->cohesiveRadius <= sphere.pair.tipRadius * (1.0 + 1e-15));
    const double off = state->indentation + (sphere.compliance * state->force) - approach;
    RC_ASSERT(std::abs(off) <= 1e-13 * sizeOf(sphere, *state, approach));
    RC_ASSERT(std::isfinite(law.energy(*state)));
    // Stable, whatever rounding leaves beside the fold itself.
    RC_ASSERT(approach <= end + (1e-6 * std::abs(end)) ||
              1.0 + (sphere.compliance * state->stiffness) >= -1e-9);
}

TEST(SphereLawsProperty, AreFiniteAndInEquilibriumForAnyMaterialAndLever) {
    test::checkProperty([] {
        AnySphere sphere = *anySphere();
        if (*rc::gen::inRange(0, 10) == 0) {
            sphere.pair.workOfAdhesion = 0.0;
        }
        expectEquilibria(SneddonLaw(sphere.pair), sphere);
        expectEquilibria(SphereJkrLaw(sphere.pair), sphere);
        expectEquilibria(SphereMaugisLaw(sphere.pair, sphere.stress), sphere);
    });
}

template <typename Law>
void expectMonotone(const Law& law, const AnySphere& sphere) {
    const LawPoint fold = law.fold(sphere.compliance);
    const double end = fold.indentation + (sphere.compliance * fold.force);
    const double low = end + (sphere.pair.tipRadius * *test::logUniform(1e-9, 5.0));
    const double high = low + (sphere.pair.tipRadius * *test::logUniform(1e-6, 1.0));
    const auto below = law.stable(low, sphere.compliance);
    const auto above = law.stable(high, sphere.compliance);
    RC_PRE(below && above);
    RC_ASSERT(above->contactRadius >= below->contactRadius * (1.0 - 1e-14));
    RC_ASSERT(above->cohesiveRadius >= below->cohesiveRadius * (1.0 - 1e-14));
    RC_ASSERT(above->indentation >= below->indentation - (1e-13 * sizeOf(sphere, *below, low)));
}

TEST(SphereLawsProperty, DeepenMonotonicallyAlongTheStableBranch) {
    test::checkProperty([] {
        const AnySphere sphere = *anySphere();
        expectMonotone(SneddonLaw(sphere.pair), sphere);
        expectMonotone(SphereJkrLaw(sphere.pair), sphere);
        expectMonotone(SphereMaugisLaw(sphere.pair, sphere.stress), sphere);
    });
}

/// Unit sphere and modulus with an adhesion that gives contacts from slight to wrapped.
rc::Gen<AnySphere> unitSphere() {
    return rc::gen::map(rc::gen::pair(test::logUniform(1e-3, 3.0), test::logUniform(0.02, 1.5)),
                        [](const std::pair<double, double>& p) {
                            return AnySphere{{1.0, 1.0, p.first}, p.first / p.second, 0.0};
                        });
}

/// Force is the slope of the energy, stiffness that of the force.
template <typename Law>
void expectSlopes(const Law& law, const AnySphere& sphere) {
    const double fold = law.fold(0.0).indentation;
    const double indentation = fold + *test::logUniform(0.03, 8.0);
    const double step = 1e-3 * (indentation - fold);
    const auto at = [&](double shift) { return *law.stable(indentation + (shift * step), 0.0); };
    const LawPoint middle = at(0.0);
    const double size = 1.0 + sphere.pair.workOfAdhesion + std::abs(middle.force);
    const auto slope = [&](const auto& value) {
        return ((8.0 * (value(at(1.0)) - value(at(-1.0)))) - (value(at(2.0)) - value(at(-2.0)))) /
               (12.0 * step);
    };
    // Where the zone meets contact or equator the third derivative is singular: keep off.
    const LawPoint below = at(-60.0);
    const LawPoint above = at(60.0);
    RC_PRE((below.contactRadius > 0.0) == (above.contactRadius > 0.0));
    RC_PRE((below.cohesiveRadius < 1.0) == (above.cohesiveRadius < 1.0));
    const double force = slope([&](const LawPoint& point) { return law.energy(point); });
    RC_ASSERT(std::abs(force - middle.force) <= 1e-8 * size);
    const double stiffness = slope([](const LawPoint& point) { return point.force; });
    RC_ASSERT(std::abs(stiffness - middle.stiffness) <= 1e-6 * (1.0 + std::abs(stiffness)));
}

TEST(SphereLawsProperty, HaveForceAndStiffnessAsSlopes) {
    test::checkProperty([] {
        const AnySphere sphere = *unitSphere();
        expectSlopes(SneddonLaw(sphere.pair), sphere);
        expectSlopes(SphereJkrLaw(sphere.pair), sphere);
        expectSlopes(SphereMaugisLaw(sphere.pair, sphere.stress), sphere);
    });
}

/// Value, slope and energy meet where the surfaces first touch and where the zone gets to the
/// equator.
TEST(SphereMaugisLaw, ContinuesSmoothlyAcrossTheFirstTouch) {
    test::checkProperty([] {
        const AnySphere sphere = *unitSphere();
        const SphereMaugisLaw law(sphere.pair, sphere.stress);
        const LawPoint touch = law.at(0.0);
        const double lift = 2.0 * sphere.stress / sphere.pair.reducedModulus;
        RC_ASSERT(std::abs(touch.indentation + (lift * touch.cohesiveRadius)) <= 1e-14 * lift);
        RC_PRE(touch.cohesiveRadius < 0.99);
        const LawPoint apart = law.apart(touch.cohesiveRadius);
        const double size = std::abs(touch.indentation) + touch.cohesiveRadius - law.onset();
        RC_ASSERT(std::abs(apart.indentation - touch.indentation) <= 1e-14 * size);
        RC_ASSERT(std::abs(apart.force - touch.force) <= 1e-14 * std::abs(touch.force));
        RC_ASSERT(std::abs(apart.stiffness - touch.stiffness) <= 1e-9 * std::abs(touch.stiffness));
        const LawPoint slight = law.at(1e-5);
        RC_ASSERT(std::abs(law.energy(slight) - law.energy(apart)) <=
                  1e-8 * (std::abs(law.energy(apart)) + sphere.pair.workOfAdhesion));
    });
}

/// Approach and retract on a rigid lever give a loop that never yields work.
TEST(SphereMaugisLaw, LosesEnergyInEveryLoop) {
    test::checkProperty([] {
        const AnySphere sphere = *anySphere();
        const SphereMaugisLaw law(sphere.pair, sphere.stress);
        const auto landing = law.stable(law.onset(), 0.0);
        const LawPoint fold = law.fold(0.0);
        RC_ASSERT(landing);
        const double size = pi * sphere.pair.workOfAdhesion * std::pow(landing->cohesiveRadius, 2);
        RC_ASSERT(law.energy(*landing) <= 1e-10 * size);
        RC_ASSERT(law.energy(fold) >= -1e-10 * size);
    });
}

}  // namespace
}  // namespace asperity
