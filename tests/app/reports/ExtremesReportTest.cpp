#include "app/reports/ExtremesReport.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ExtremesReport, SentencesOfOneKindDifferInQuantitiesAlone) {
    EXPECT_EQ(kindOf("contact stiffness at the device of 12.5 kN/m exceeds (6 kN/m)"),
              "contact stiffness at the device of X N/m exceeds (X N/m)");
    EXPECT_EQ(kindOf("a force that is 850 µs old, as of 1e-05 s"),
              "a force that is X s old, as of X s");
    EXPECT_EQ(kindOf("with 17.9 N, more than (850 mN)"), "with X N, more than (X N)");
}

}  // namespace
}  // namespace asperity
