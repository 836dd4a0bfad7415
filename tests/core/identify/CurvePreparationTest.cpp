#include "core/identify/CurvePreparation.h"

#include "core/identify/ContactPoint.h"
#include "tests/core/identify/SyntheticCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using test::SyntheticCurve;

constexpr double kNoise = 5e-12;  // [N]

SyntheticCurve noisy() {
    SyntheticCurve curve;
    curve.noise = kNoise;
    curve.drag = 4e-11;
    return curve;
}

/// A hard contact whose stored InvOLS is half the true one.
SyntheticCurve hard() {
    SyntheticCurve curve;
    curve.tip = {.kind = TipKind::Paraboloid, .radius = 1e-6};
    curve.reducedModulus = 1e10;
    curve.end = 5e-8;
    curve.start = -2e-7;
    curve.tilt = 0.0;
    curve.noise = 1e-14;
    return curve;
}

void scaleDeflection(MeasuredForceCurve& curve, double factor) {
    for (CurveSegment& segment : curve.segments) {
        for (std::size_t i = 0; i < segment.force.size(); ++i) {
            segment.force[i] *= factor;
            segment.deflection[i] *= factor;
        }
    }
}

TEST(CurvePreparation, FindsBaselineTiltNoiseAndDrag) {
    const SyntheticCurve given = noisy();
    const PreparedCurve curve = prepareCurve(given.curve(), {});
    EXPECT_NEAR(curve.baseline.at(given.contact), given.offset + given.drag, 5e-12);
    EXPECT_NEAR(curve.baseline.slope, given.tilt, 5e-7);
    EXPECT_NEAR(curve.baseline.noise, kNoise, 0.1 * kNoise);
    EXPECT_NEAR(curve.baseline.drag(), given.drag, 2e-12);
    EXPECT_FALSE(curve.baseline.isWavy());
    EXPECT_EQ(curve.stiffness, given.stiffness);
}

TEST(CurvePreparation, LeavesStepsOut) {
    const MeasuredForceCurve measured = noisy().curve();
    EXPECT_EQ(prepareCurve(measured, {.tilt = false}).baseline.slope, 0.0);
    EXPECT_EQ(prepareCurve(measured, {.drag = false}).baseline.retractOffset, 0.0);
    EXPECT_EQ(prepareCurve(measured, {.baseline = false}).baseline.offset, 0.0);
    const auto steps = prepareCurve(measured, {.tilt = false}).steps;
    const auto tilt = std::find_if(steps.begin(), steps.end(),
                                   [](const PreparationStep& step) { return step.key == "tilt"; });
    ASSERT_NE(tilt, steps.end());
    EXPECT_FALSE(tilt->on);
}

TEST(CurvePreparation, TurnsACurveOfTheWrongSignOver) {
    MeasuredForceCurve measured = noisy().curve();
    const PreparedCurve right = prepareCurve(measured, {});
    scaleDeflection(measured, -1.0);
    const PreparedCurve turned = prepareCurve(measured, {});
    EXPECT_TRUE(turned.turnedOver);
    EXPECT_FALSE(right.turnedOver);
    EXPECT_EQ(turned.approach.force, right.approach.force);
    EXPECT_FALSE(prepareCurve(measured, {.sign = false}).turnedOver);
}

TEST(CurvePreparation, ReportsInterferenceBeyondTheNoise) {
    MeasuredForceCurve measured = noisy().curve();
    CurveSegment& approach = measured.segments[0];
    approach.deflection.clear();
    for (std::size_t i = 0; i < approach.force.size(); ++i) {
        approach.force[i] += 6.0 * kNoise * std::sin(0.05 * static_cast<double>(i));
    }
    EXPECT_TRUE(prepareCurve(measured, {}).baseline.isWavy());
}

TEST(CurvePreparation, CorrectsTheInvolsByAHardContact) {
    const SyntheticCurve given = hard();
    MeasuredForceCurve measured = given.curve();
    scaleDeflection(measured, 0.5);
    const PreparedCurve stored = prepareCurve(measured, {});
    EXPECT_NEAR(stored.slope.approach, 0.5, 5e-3);
    EXPECT_TRUE(stored.slope.isRigid());
    EXPECT_EQ(stored.gain, 1.0);
    const PreparedCurve fixed = prepareCurve(measured, {.lever = LeverRule::Fixed});
    EXPECT_NEAR(fixed.gain, 2.0, 0.02);
    EXPECT_EQ(fixed.stiffness, given.stiffness);
    EXPECT_NEAR(fixed.approach.forceRange(), 2.0 * stored.approach.forceRange(), 1e-11);
    const PreparedCurve thermal = prepareCurve(measured, {.lever = LeverRule::Thermal});
    EXPECT_NEAR(thermal.stiffness, given.stiffness / (thermal.gain * thermal.gain), 1e-12);
    EXPECT_NEAR(thermal.approach.forceRange(), 0.5 * stored.approach.forceRange(), 1e-11);
}

TEST(CurvePreparation, LeavesTheInvolsOfASoftContactAlone) {
    const PreparedCurve curve = prepareCurve(noisy().curve(), {.lever = LeverRule::Fixed});
    EXPECT_FALSE(curve.slope.isRigid());
    EXPECT_EQ(curve.gain, 1.0);
}

TEST(CurvePreparation, CalibratesAsItIsTold) {
    MeasuredForceCurve measured = noisy().curve();
    const double range = prepareCurve(measured, {}).approach.forceRange();
    EXPECT_NEAR(prepareCurve(measured, {.stiffness = 0.1}).approach.forceRange(), 2.0 * range,
                1e-15);
    measured.invols = 50e-9;
    EXPECT_NEAR(prepareCurve(measured, {.invols = 100e-9}).approach.forceRange(), 2.0 * range,
                1e-15);
}

TEST(CurvePreparation, ReadsVoltsWithBothCalibrations) {
    MeasuredForceCurve measured = noisy().curve();
    const double range = prepareCurve(measured, {}).approach.forceRange();
    for (CurveSegment& segment : measured.segments) {
        segment.signal = segment.deflection;
        std::for_each(segment.signal.begin(), segment.signal.end(), [](double& v) { v /= 50e-9; });
        segment.force.clear();
        segment.deflection.clear();
    }
    EXPECT_THROW((void)prepareCurve(measured, {}), CurveRefusal);  // no InvOLS
    EXPECT_NEAR(prepareCurve(measured, {.invols = 50e-9}).approach.forceRange(), range, 1e-15);
    measured.stiffness = 0.0;
    EXPECT_THROW((void)prepareCurve(measured, {.invols = 50e-9}), CurveRefusal);
}

TEST(CurvePreparation, RefusesACurveWithoutAnApproach) {
    MeasuredForceCurve measured = noisy().curve();
    measured.segments.erase(measured.segments.begin());
    EXPECT_THROW((void)prepareCurve(measured, {}), CurveRefusal);
}

TEST(ContactPoint, EachMethodFindsIt) {
    SyntheticCurve given = noisy();
    const PreparedCurve curve = prepareCurve(given.curve(), {});
    const std::vector<double> force = curve.correctedForce(curve.approach);
    // How far off a method may be, of a contact 1.5 um deep: its own bias on a soft sample.
    const auto expect = [&](ContactMethod method, double tolerance) {
        const auto found = contactPoint(method, curve.approach, force, curve.baseline.noise);
        ASSERT_TRUE(found) << keyOf(method);
        EXPECT_NEAR(*found, given.contact, tolerance) << keyOf(method);
    };
    expect(ContactMethod::Deviation, 0.1e-6);
    expect(ContactMethod::LinePower, 0.08e-6);
    expect(ContactMethod::ConstantLine, 0.5e-6);
    expect(ContactMethod::Gradient, 0.15e-6);
}

TEST(CurvePreparation, BaselineEndsBeforeAnAttraction) {
    SyntheticCurve given = noisy();
    given.noise = 0.0;  // rounding is no noise either
    given.drag = 0.0;
    MeasuredForceCurve measured = given.curve();
    for (CurveSegment& segment : measured.segments) {
        segment.deflection.clear();
        for (std::size_t i = 0; i < segment.base.size(); ++i) {
            const double beyond = segment.base[i] - given.contact;
            segment.force[i] -= beyond > -1e-6 && beyond < 0.5e-6 ? 2e-9 : 0.0;
        }
    }
    const PreparedCurve curve = prepareCurve(measured, {});
    EXPECT_LT(curve.baseline.nearEnd, given.contact - 1e-6);
    EXPECT_NEAR(curve.baseline.at(given.contact), given.offset, 1e-15);
    EXPECT_LT(curve.baseline.noise, 1e-6 * curve.forceRange());
}

TEST(ContactPoint, IsNotFoundInNoise) {
    SyntheticCurve given = noisy();
    given.end = -1e-6;
    const PreparedCurve curve = prepareCurve(given.curve(), {});
    EXPECT_FALSE(contactPoint(ContactMethod::Deviation, curve.approach,
                              curve.correctedForce(curve.approach), curve.baseline.noise));
}

}  // namespace
}  // namespace asperity
