#include "core/curves/AlignedForceCurve.h"

#include "core/Error.h"
#include "core/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double kLever = 0.2;    // [N/m]
constexpr double kContact = 0.8;  // [N/m]
constexpr double kTogether = kLever * kContact / (kLever + kContact);
constexpr double kBaseAtContact = 3.21e-6;  // [m]
constexpr double kOffset = -2.5e-9;         // [N]
constexpr double kTilt = 1e-4;              // [N/m]
constexpr double kPull = 4e-9;              // at pull-off [N]

/// A spring contact on a lever whose force drifts with the base.
struct Spring {
    double sigma = 0.0;            ///< [N]
    double offsetOfRetract = 0.0;  ///< [N]
    Random random{3};

    [[nodiscard]] MeasuredForceCurve curve() {
        MeasuredForceCurve all;
        all.stiffness = kLever;
        CurveSegment approach;
        CurveSegment retract{.kind = CurveSegmentKind::Retract};
        for (int i = 0; i <= 2000; ++i) {
            add(approach, -900e-9 + 0.5e-9 * i, false);
        }
        for (int i = 2000; i >= 0; --i) {
            add(retract, -900e-9 + 0.5e-9 * i, true);
        }
        all.segments = {approach, retract};
        return all;
    }

    void add(CurveSegment& segment, double depth, bool retracts) {
        const bool holds = depth > 0.0 || (retracts && depth > -kPull / kTogether);
        const double base = kBaseAtContact + depth;
        const double force = holds ? kTogether * depth : 0.0;
        segment.base.push_back(base);
        segment.force.push_back(force + kOffset + kTilt * depth +
                                (retracts ? offsetOfRetract : 0.0) + sigma * random.normal());
    }
};

std::size_t pullOff(const AlignedBranch& branch) {
    return static_cast<std::size_t>(std::min_element(branch.force.begin(), branch.force.end()) -
                                    branch.force.begin());
}

TEST(AlignedForceCurve, BaselineAndContactAreAtZero) {
    const AlignedForceCurve aligned = alignedCurve(Spring().curve(), 1.0);
    EXPECT_NEAR(aligned.baselineForce, kOffset, 1e-15);
    EXPECT_NEAR(aligned.baselineSlope, kTilt, 1e-9);
    EXPECT_LT(aligned.noise, 1e-16);
    EXPECT_NEAR(aligned.approach.force.front(), 0.0, 1e-16);
    EXPECT_NEAR(aligned.approach.baseDistance.back(), -100e-9, 0.6e-9) << "within a sample";
    EXPECT_NEAR(aligned.approach.force.back(), kTogether * 100e-9, 1e-13);
}

TEST(AlignedForceCurve, SeparationIsTheBaseWithoutTheLeversBending) {
    const AlignedForceCurve aligned = alignedCurve(Spring().curve(), 1.0);
    EXPECT_EQ(aligned.stiffness, kLever) << "the file's, not the caller's";
    const std::size_t last = aligned.approach.force.size() - 1;
    EXPECT_NEAR(aligned.approach.separation[last],
                aligned.approach.baseDistance[last] + aligned.approach.force[last] / kLever, 1e-18);
    EXPECT_NEAR(aligned.approach.separation[last], -aligned.approach.force[last] / kContact,
                0.6e-9);
}

TEST(AlignedForceCurve, APullOffIsWhereItIsWithNoise) {
    Spring spring{.sigma = 50e-12};
    const AlignedForceCurve aligned = alignedCurve(spring.curve(), 1.0);
    EXPECT_NEAR(aligned.noise, 50e-12, 5e-12);
    const std::size_t last = pullOff(aligned.retract);
    EXPECT_NEAR(aligned.retract.force[last], -kPull, 0.2e-9);
    EXPECT_NEAR(aligned.retract.baseDistance[last], kPull / kTogether, 2e-9);
    EXPECT_NEAR(aligned.lastPull, kPull / kTogether, 2e-9);
}

TEST(AlignedForceCurve, ARetractHasItsOwnOffset) {
    Spring spring{.offsetOfRetract = 3e-10};
    const AlignedForceCurve aligned = alignedCurve(spring.curve(), 1.0);
    EXPECT_NEAR(aligned.retract.force.back(), 0.0, 1e-15);
    EXPECT_NEAR(aligned.retract.force.front(), kTogether * 100e-9, 1e-13);
}

TEST(AlignedForceCurve, TheLeverIsThatOfForceAndDeflectionElseTheCallers) {
    MeasuredForceCurve curve = Spring().curve();
    curve.stiffness = 0.0;
    EXPECT_EQ(alignedCurve(curve, 7.0).stiffness, 7.0);
    for (const double force : curve.segments.front().force) {
        curve.segments.front().deflection.push_back(force / 0.35 + 1e-7);
    }
    EXPECT_NEAR(alignedCurve(curve, 7.0).stiffness, 0.35, 1e-12);
}

TEST(AlignedForceCurve, ACurveOverTheSeparationHasItsBaseFromTheLever) {
    MeasuredForceCurve curve = Spring().curve();
    curve.segments.pop_back();
    CurveSegment& approach = curve.segments.front();
    for (const double base : approach.base) {
        approach.separation.push_back(5e-6 - base);
    }
    approach.base.clear();
    const AlignedForceCurve aligned = alignedCurve(curve, 1.0);
    EXPECT_TRUE(aligned.retract.force.empty());
    EXPECT_NEAR(aligned.approach.separation.back(), -100e-9, 0.6e-9);
    EXPECT_NEAR(aligned.approach.baseDistance.back(),
                aligned.approach.separation.back() - aligned.approach.force.back() / kLever, 1e-18);
}

TEST(AlignedForceCurve, ACurveWithoutContactIsRefused) {
    Spring spring{.sigma = 50e-12};
    MeasuredForceCurve flat = spring.curve();
    for (double& force : flat.segments.front().force) {
        force = 50e-12 * spring.random.normal();
    }
    EXPECT_THROW(static_cast<void>(alignedCurve(flat, 1.0)), Error);
    MeasuredForceCurve few;
    few.segments = {{.base = {1e-9, 2e-9}, .force = {0.0, 1e-9}}};
    EXPECT_THROW(static_cast<void>(alignedCurve(few, 1.0)), Error);
}

}  // namespace
}  // namespace asperity
