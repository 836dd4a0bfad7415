#include "core/Units.h"
#include "core/experiment/Operator.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kSenseStep = 1e-3;  // [s]
constexpr double kScale = 2e6;       // of the screen
const Vector3 kSight = Vector3::UnitY();

OperatorTraits sharp() {
    OperatorTraits traits;
    traits.acuity = 0.0;
    return traits;
}

TEST(Perception, SightIsLate) {
    OperatorSight sight(sharp(), kScale, kSight);
    Random random(1);
    double time = 0.0;
    for (; time < 1.0; time += kSenseStep) {
        sight.show({.tip = Vector3::UnitX() * time}, kSenseStep);
    }
    const double late = time - sight.look(random).x();
    EXPECT_GE(late, 0.25);
    EXPECT_LE(late, 0.25 + 2.0 / 60.0 + 2.0 * kSenseStep);
}

/// Root mean square of what is seen of a tip at rest at 0, along an axis [m].
double spread(const ShownMoment& moment, int axis) {
    OperatorSight sight(OperatorTraits{}, kScale, kSight);
    sight.show(moment, kSenseStep);
    Random random(1);
    double sum = 0.0;
    constexpr int kLooks = 20'000;
    for (int i = 0; i < kLooks; ++i) {
        const double seen = sight.look(random)[axis];
        sum += seen * seen;
    }
    return std::sqrt(sum / kLooks);
}

TEST(Perception, SightIsAsExactAsItsTraits) {
    const OperatorTraits traits;
    const double acuity = traits.acuity / kScale;
    EXPECT_NEAR(spread({}, 0), acuity, 0.03 * acuity);
    EXPECT_NEAR(spread({}, 1), traits.depthFactor * acuity, 0.1 * acuity) << "along the sight";
    const double hidden = traits.hiddenFactor * acuity;
    EXPECT_NEAR(spread({.hidden = true}, 0), hidden, 0.03 * hidden);
}

/// Until a step of the force is answered [s]; < 0: never within a second.
double answerTo(double before, double after) {
    OperatorTouch touch{OperatorTraits{}};
    for (int i = 0; i < 3000; ++i) {
        touch.feel({0.0, 0.0, before}, kSenseStep);
    }
    (void)touch.takeNotice();
    for (int i = 0; i < 1000; ++i) {
        touch.feel({0.0, 0.0, after}, kSenseStep);
        if (touch.takeNotice()) {
            return (i + 1) * kSenseStep;
        }
    }
    return -1.0;
}

TEST(Perception, TouchNoticesLargeChangesLate) {
    EXPECT_NEAR(answerTo(0.0, 0.1), 0.15, 2.0 * kSenseStep);
    EXPECT_LT(answerTo(0.0, 0.05), 0.0) << "below what a hand notices";
    EXPECT_LT(answerTo(2.0, 2.15), 0.0) << "below a tenth of what acts";
    EXPECT_GT(answerTo(2.0, 2.3), 0.0);
}

}  // namespace
}  // namespace asperity
