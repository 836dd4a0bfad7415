#include "core/contact/laws/AttractiveTail.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::expectClose;

TEST(VanDerWaals, AgreesWithTheReferenceDownToContact) {
    const test::ReferenceTable table = test::referenceTable("T09_vdw.csv");
    ASSERT_EQ(table.rows(), 60U);
    int compared = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double separation = table.number(row, "D_m");
        if (separation < kContactSeparation) {
            continue;
        }
        SCOPED_TRACE(row);
        const VanDerWaals attraction(table.number(row, "H_J"), table.number(row, "R_m"));
        expectClose(attraction.force(separation), table.number(row, "F_exact_N"), 1e-14);
        expectClose(attraction.gradient(separation), table.number(row, "dFdD_exact_N_m"), 1e-14);
        expectClose(attraction.energy(separation), table.number(row, "U_exact_J"), 1e-13);
        expectClose(attraction.separationAt(attraction.force(separation)), separation, 1e-14);
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

/// The columns that no code computes: what Derjaguin makes of the attraction of a sphere, to the
/// factor by which the exact one is weaker, and the Lennard-Jones potential of the same adhesion.
TEST(VanDerWaals, StandsBesideDerjaguinAndLennardJonesLikeTheReference) {
    const test::ReferenceTable table = test::referenceTable("T09_vdw.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto cell = [&](const char* column) { return table.number(row, column); };
        SCOPED_TRACE(row);
        const double work = cell("w_J_m2");
        const double radius = cell("R_m");
        const double separation = cell("D_m");
        expectClose(hamakerConstant(work), cell("H_J"), 1e-14);
        if (separation >= kContactSeparation) {
            const VanDerWaals attraction(cell("H_J"), radius);
            const double weaker = std::pow(1.0 + (separation / (2.0 * radius)), -2.0);
            expectClose(attraction.force(separation) / weaker, cell("F_derj_N"), 1e-13);
        }
        expectClose(cell("U_derj_J"), cell("F_derj_N") * separation, 1e-14);
        const double spacing = kContactSeparation * std::sqrt(3.0) / 2.0;
        expectClose(cell("z0_m"), spacing, 1e-14);
        const double near = spacing / separation;
        const double most = 8.0 / 3.0 * std::numbers::pi * work * radius;
        expectClose(cell("F_LJ_N"), -most * ((near * near) - (0.25 * std::pow(near, 8))), 1e-13,
                    most * near * near);
        expectClose(cell("U_LJ_J"), -most * spacing * (near - (std::pow(near, 7) / 28.0)), 1e-13,
                    most * spacing * near);
    }
}

TEST(VanDerWaals, DoesNotDivergeBelowContact) {
    const VanDerWaals attraction(1e-19, 15e-9);
    for (const double separation : {1e-10, 0.0, -1e-9}) {
        EXPECT_EQ(attraction.force(separation), attraction.force(kContactSeparation));
        EXPECT_EQ(attraction.energy(separation), attraction.energy(kContactSeparation));
    }
}

TEST(VanDerWaals, ForceIsTheSlopeOfTheEnergy) {
    test::checkProperty([] {
        const double radius = *test::logUniform(1e-9, 1e-5);
        const VanDerWaals attraction(1e-19, radius);
        const double separation = *test::logUniform(2e-10, 1e-6);
        const double step = 1e-4 * separation;
        const double slope =
            (attraction.energy(separation + step) - attraction.energy(separation - step)) /
            (2.0 * step);
        RC_ASSERT(std::abs(slope + attraction.force(separation)) <=
                  1e-6 * std::abs(attraction.force(separation)));
        const double bend =
            (attraction.force(separation + step) - attraction.force(separation - step)) /
            (2.0 * step);
        RC_ASSERT(std::abs(bend - attraction.gradient(separation)) <=
                  1e-6 * attraction.gradient(separation));
    });
}

TEST(AttractiveTail, EnergyIsTheWorkOfTheForceOverTheApproachOfTheBodies) {
    test::checkProperty([] {
        const ContactPair pair = *test::adhesivePair();
        const AttractiveTail tail({hamakerConstant(pair.workOfAdhesion), pair.tipRadius},
                                  pair.reducedModulus, 5e-10);
        const double separation = tail.endSeparation(0.0) * *test::logUniform(1.01, 100.0);
        const double step = 1e-4 * separation;
        const double moved =
            tail.indentation(separation - step) - tail.indentation(separation + step);
        const double gained = tail.energy(separation - step) - tail.energy(separation + step);
        const double work = tail.attraction().force(separation) * moved;
        RC_ASSERT(std::abs(gained - work) <=
                  1e-6 * std::abs(tail.attraction().force(separation) * 2.0 * step));
    });
}

}  // namespace
}  // namespace asperity
