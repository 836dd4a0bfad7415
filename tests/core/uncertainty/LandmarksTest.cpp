#include "core/uncertainty/Landmarks.h"

#include "core/contact/laws/ForceCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr ContactPair kPair{.tipRadius = 20e-9, .reducedModulus = 2e9, .workOfAdhesion = 0.05};

double of(const Landmarks& landmarks, Landmark landmark) {
    return landmarks[static_cast<std::size_t>(landmark)];
}

TEST(Landmarks, AreThoseOfJkr) {
    constexpr double kSoft = 1e3;  // [m/N]
    const Landmarks found = landmarksOf(ContactModel(ContactLaw::Jkr, kPair), kSoft, 5e-9);
    const double pull = 1.5 * std::numbers::pi * kPair.workOfAdhesion * kPair.tipRadius;
    EXPECT_NEAR(of(found, Landmark::AdhesionForce), pull, 1e-9 * pull);
    EXPECT_NEAR(of(found, Landmark::PullOffForce), pull, 1e-4 * pull);
    EXPECT_NEAR(of(found, Landmark::NormalForce), 5e-9, 1e-15);
    // A soft lever stores nearly all of the work: F^2 / 2k.
    EXPECT_NEAR(of(found, Landmark::SeparationWork), 0.5 * kSoft * pull * pull,
                0.01 * kSoft * pull * pull);
}

TEST(Landmarks, WorkIsTheAreaOfTheCurve) {
    constexpr double kLever = 1.0 / 14.0;  // [m/N]
    const ContactModel model(ContactLaw::Maugis, kPair);
    ForceCurvePlan plan = curvePlan(model, kLever);
    plan.points = 20000;
    const ForceCurve curve = forceCurve(model, kLever, plan);
    double area = 0.0;
    for (std::size_t i = 1; i < curve.retract.size(); ++i) {
        const ForceCurvePoint& a = curve.retract[i - 1];
        const ForceCurvePoint& b = curve.retract[i];
        const double pull = std::max(0.0, -0.5 * (a.state.force + b.state.force));
        area += pull * (a.basePosition - b.basePosition);
    }
    EXPECT_NEAR(of(landmarksOf(model, kLever, 1e-9), Landmark::SeparationWork), area, 1e-3 * area);
}

TEST(Landmarks, HoldBothJumps) {
    constexpr double kLever = 1.0 / 14.0;  // [m/N]
    constexpr double kSetpoint = 5e-9;     // [N]
    const ContactModel model(ContactLaw::Maugis, kPair);
    const ForceCurve curve = forceCurve(model, kLever, curvePlan(model, kLever));
    const Landmarks found = landmarksOf(model, kLever, kSetpoint);
    ASSERT_TRUE(curve.snapIn && curve.pullOff);
    EXPECT_EQ(of(found, Landmark::SnapInForce), -curve.snapIn->after.force);
    EXPECT_EQ(of(found, Landmark::SnapInDistance), -curve.snapIn->basePosition);
    EXPECT_GT(of(found, Landmark::SnapInDistance), 0.0) << "a gap";
    double area = 0.0;  // between both ways; the lever is elastic
    for (const auto* way : {&curve.approach, &curve.retract}) {
        for (std::size_t i = 1; i < way->size(); ++i) {
            const ForceCurvePoint& a = (*way)[i - 1];
            const ForceCurvePoint& b = (*way)[i];
            area += 0.5 * (a.state.force + b.state.force) * (b.basePosition - a.basePosition);
        }
    }
    EXPECT_NEAR(of(found, Landmark::Hysteresis), area, 0.02 * area);
    EXPECT_NEAR(of(found, Landmark::ContactTravel),
                *basePositionAt(model, kLever, kSetpoint) - curve.pullOff->basePosition, 1e-18);
}

TEST(Landmarks, AreMissingWhereTheLawHasNone) {
    const Landmarks found = landmarksOf(ContactModel(ContactLaw::Hertz, kPair), 0.1, 0.0);
    for (const double value : found) {
        EXPECT_TRUE(std::isnan(value));
    }
}

}  // namespace
}  // namespace asperity
