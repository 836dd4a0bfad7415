#include "core/Units.h"
#include "core/deformation/ContactDeformation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

double roundingAt(double ratio) {
    const ContactState contact{.contactRadius = ratio * 15.0_nm};
    return rimRounding(contact, 15.0_nm) / contact.contactRadius;
}

TEST(RimRounding, LeavesNarrowContactsExact) {
    EXPECT_EQ(roundingAt(0.05), 0.0);
    EXPECT_EQ(roundingAt(0.4), 0.0);
}

TEST(RimRounding, GrowsToAShareOfTheWidestContacts) {
    EXPECT_GT(roundingAt(0.7), 0.0);
    EXPECT_LT(roundingAt(0.7), roundingAt(0.9));
    EXPECT_EQ(roundingAt(0.95), roundingAt(2.0));
    EXPECT_LT(roundingAt(2.0), 0.2);
}

TEST(RimRounding, TakesTheTipOffACuspAndKeepsAStraightLine) {
    const auto cusp = [](double r) { return -std::sqrt(std::abs(r - 10.0_nm)); };
    EXPECT_EQ(averagedOverRim(cusp, 10.0_nm, 0.0), 0.0);
    EXPECT_LT(averagedOverRim(cusp, 10.0_nm, 1.0_nm), -1e-6);
    const auto line = [](double r) { return 3.0 * r; };
    EXPECT_NEAR(averagedOverRim(line, 10.0_nm, 1.0_nm), 30.0_nm, 1e-20);
}

}  // namespace
}  // namespace asperity
