#include "core/contact/VanDerWaals.h"

#include "core/contact/AttractiveTail.h"
#include "tests/core/contact/ContactCases.h"

#include <gtest/gtest.h>

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
