#include "core/experiment/Operator.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double kHandStep = 1e-3;  // [s]
constexpr double kGain = 1e-6;

OperatorTask taskTo(const Vector3& target) {
    return {.target = target, .positionGain = kGain, .screenScale = 2.8e6};
}

/// What a trial in free air comes to: the tip follows the hand, and the window shows it shifted.
struct FreeReach {
    double time = 0.0;     ///< until the button; the limit where it was not pressed [s]
    double fastest = 0.0;  ///< of the hand [m/s]
    Vector3 tip = Vector3::Zero();
    bool pressed = false;
};

FreeReach reachIn(const OperatorTraits& traits, const Vector3& target,
                  const Vector3& shift = Vector3::Zero(), double limit = 60.0) {
    Operator person(traits, taskTo(target), Vector3::Zero(), 5);
    person.begin();
    FreeReach reach;
    Vector3 before = Vector3::Zero();
    while (!person.hasPressed() && reach.time < limit) {
        reach.time += kHandStep;
        const Vector3 hand = person.advance(kHandStep);
        reach.fastest = std::max(reach.fastest, (hand - before).norm() / kHandStep);
        before = hand;
        reach.tip = kGain * hand;
        person.see({.tip = reach.tip + shift}, kHandStep);
    }
    reach.pressed = person.hasPressed();
    return reach;
}

OperatorTraits steady() {
    OperatorTraits traits;
    traits.tremor = 0.0;
    return traits;
}

TEST(Operator, ReachesATargetInFreeAirAndPresses) {
    const Vector3 target(30.0_nm, 20.0_nm, -40.0_nm);
    const FreeReach reach = reachIn(OperatorTraits{}, target);
    EXPECT_TRUE(reach.pressed);
    EXPECT_LT((reach.tip - target).norm(), 1.5_nm);
    EXPECT_GT(reach.time, 1.0);
    EXPECT_LT(reach.time, 20.0);
}

TEST(Operator, KnowsWhatTheWindowShowsNotTheTruth) {
    const Vector3 target(30.0_nm, 20.0_nm, -40.0_nm);
    const Vector3 shift(5.0_nm, 0.0, 3.0_nm);
    const FreeReach reach = reachIn(steady(), target, shift);
    EXPECT_TRUE(reach.pressed);
    EXPECT_LT((reach.tip + shift - target).norm(), 1.5_nm);
    EXPECT_GT((reach.tip - target).norm(), 4.0_nm);
}

TEST(Operator, MovesWithTheSpeedOfMinimumJerk) {
    OperatorTraits exact = steady();
    exact.aimError = 0.0;
    exact.acuity = 0.0;
    const Vector3 target(40.0_nm, 0.0, 0.0);
    const FreeReach reach = reachIn(exact, target);
    // One movement of 40 mm: 1.875 times the mean speed at its middle.
    const double bits = std::log2(40e-9 / (exact.tolerance / 2.8e6) + 1.0);
    const double duration = exact.moveTime + exact.timePerBit * bits;
    EXPECT_NEAR(reach.fastest, 1.875 * 0.04 / duration, 0.03 * reach.fastest);
}

TEST(Operator, NeverPressesFarFromTheTarget) {
    Operator person(OperatorTraits{}, taskTo({50.0_nm, 0.0, 0.0}), Vector3::Zero(), 1);
    person.begin();
    for (int i = 0; i < 10'000; ++i) {
        (void)person.advance(kHandStep);
        person.see({.tip = Vector3::Zero()}, kHandStep);  // whatever the hand does, the tip stays
        ASSERT_FALSE(person.hasPressed());
    }
    EXPECT_GT(person.movements(), 3);
}

TEST(Operator, RestsUntilTheTrialBegins) {
    Operator person(steady(), taskTo({50.0_nm, 0.0, 0.0}), Vector3::Zero(), 1);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(person.advance(kHandStep), Vector3::Zero());
        person.see({}, kHandStep);
    }
}

TEST(Operator, AForceThatIsSuddenlyFeltStopsTheMovement) {
    Operator person(steady(), taskTo({90.0_nm, 0.0, 0.0}), Vector3::Zero(), 1);
    person.begin();
    double time = 0.0;
    Vector3 hand = Vector3::Zero();
    const auto step = [&](double force) {
        time += kHandStep;
        person.feel({force, 0.0, 0.0}, kHandStep);
        hand = person.advance(kHandStep);
        person.see({.tip = kGain * hand}, kHandStep);
    };
    while (hand.x() < 5e-3) {  // on the way
        step(0.0);
    }
    const double felt = time;
    const double touch = OperatorTraits{}.touchTime;
    while (time < felt + touch + 0.01) {
        step(0.5);
    }
    const double stopped = hand.x();
    for (int i = 0; i < 100; ++i) {
        step(0.5);
    }
    EXPECT_EQ(hand.x(), stopped);
    EXPECT_LT(stopped, 0.08);
}

TEST(Operator, TremblesAsMuchAsItsTraitsSay) {
    OperatorTraits traits;
    traits.tremor = 0.2e-3;
    Operator person(traits, taskTo(Vector3::Zero()), Vector3::Zero(), 3);
    double sum = 0.0;
    constexpr int kTicks = 200'000;
    for (int i = 0; i < kTicks; ++i) {
        const double x = person.advance(kHandStep).x();
        sum += x * x;
    }
    EXPECT_NEAR(std::sqrt(sum / kTicks), 0.2e-3, 0.02e-3);
}

}  // namespace
}  // namespace asperity
