#include "core/Units.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/haptics/coupling/PassivityObserver.h"
#include "core/scene/Scene.h"
#include "tests/core/haptics/TestDevice.h"
#include "tests/core/haptics/bench/HeldTip.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace asperity {
namespace {

using test::kPhantom;

constexpr double kDelay = 5.0_ms;
constexpr CouplingGains kTooStiff{.stiffness = 600.0, .damping = 1.5, .proxyDamping = 3.0};

struct Supervision {
    double leastEnergy = 0.0;  ///< [J]
    bool active = false;       ///< ever
};

/// A light hand taps hard on silicon oxide, late by five milliseconds.
Supervision supervise(const CouplingGains& gains) {
    const Scene scene = test::hapticScene("silicon_oxide", test::flatMap());
    PassivityObserver observer(gains.stiffness, scene.timeStep(), kDelay);
    Supervision seen;
    const test::HeldTip held = test::holdTip(
        scene, {.bench = {.arm = kLightGrip, .delay = kDelay}, .coupling = gains, .goal = -8e-3},
        [&](const Vector3& device, const Vector3& force) {
            observer.observe(device, force);
            seen.leastEnergy = std::min(seen.leastEnergy, observer.energy());
            seen.active = seen.active || observer.active();
        });
    std::cout << "moves " << held.peakToPeak * 1e3 << " mm, least energy " << seen.leastEnergy * 1e3
              << " mJ\n";
    return seen;
}

TEST(SupervisedContact, ShakingIsSeenAndAHeldTipIsNot) {
    EXPECT_TRUE(supervise(kTooStiff).active);
    EXPECT_FALSE(supervise(designCoupling(kPhantom, {.delay = kDelay})).active);
}

}  // namespace
}  // namespace asperity
