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

TEST(Landmarks, AreMissingWhereTheLawHasNone) {
    const Landmarks found = landmarksOf(ContactModel(ContactLaw::Hertz, kPair), 0.1, 0.0);
    for (const double value : found) {
        EXPECT_TRUE(std::isnan(value));
    }
}

}  // namespace
}  // namespace asperity
