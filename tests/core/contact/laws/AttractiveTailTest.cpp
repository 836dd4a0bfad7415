#include "core/contact/laws/AttractiveTail.h"

#include "core/Units.h"
#include "core/contact/laws/SplitLaw.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {
namespace {

constexpr ContactPair kPairs[] = {
    {.tipRadius = 20.0_nm, .reducedModulus = 2.3_GPa, .workOfAdhesion = 0.066},
    {.tipRadius = 5.0_nm, .reducedModulus = 70.0_GPa, .workOfAdhesion = 0.1},
    {.tipRadius = 100.0_nm, .reducedModulus = 3.0_MPa, .workOfAdhesion = 0.05}};
constexpr double kCompliances[] = {0.0, 0.01, 0.1, 1.0, 5.0, 100.0};  // [m/N]

/// Approaches from far away to beyond the end, close to it on both sides.
std::vector<double> approachesTo(double end) {
    std::vector<double> approaches{end};
    for (double away = 1e-6; away > 1e-22; away *= 0.7) {
        approaches.push_back(end - away);
        approaches.push_back(end + away);
    }
    return approaches;
}

TEST(AttractiveTail, AStableSeparationIsThatAboveTheEndAndNoneBeyondIt) {
    int stable = 0;
    int none = 0;
    for (const ContactPair& pair : kPairs) {
        const AttractiveTail tail = splitTail(pair);
        for (const double compliance : kCompliances) {
            const double end = tail.endSeparation(compliance);
            const double last = tail.approach(end, compliance);
            for (const double approach : approachesTo(last)) {
                const auto found = tail.stableSeparation(approach, compliance);
                ASSERT_EQ(found.has_value(), approach <= last) << compliance << ' ' << approach;
                if (found) {
                    EXPECT_EQ(*found, tail.separationAt(approach, compliance, end));
                }
                ++(found ? stable : none);
            }
        }
    }
    EXPECT_GT(stable, 1000);
    EXPECT_GT(none, 1000);
}

TEST(AttractiveTail, AStableSeparationTakesTheApproach) {
    const AttractiveTail tail = splitTail(kPairs[0]);
    for (const double compliance : kCompliances) {
        for (double approach = -50.0_nm; approach < -15.0_nm; approach += 1.0_nm) {
            const auto found = tail.stableSeparation(approach, compliance);
            ASSERT_TRUE(found);
            EXPECT_NEAR(tail.approach(*found, compliance), approach, 1e-22);
        }
    }
}

}  // namespace
}  // namespace asperity
