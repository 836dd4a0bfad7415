#include "core/Units.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "tests/core/haptics/TestDevice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::kTick;

constexpr CouplingGains kGains{.stiffness = 300.0, .damping = 2.0, .proxyDamping = 3.0};

/// A device that starts at 0, with its proxy.
class CoupledDevice {
public:
    explicit CoupledDevice(const CouplingGains& gains = kGains, double tick = kTick)
        : gains_(gains), tick_(tick) {}

    CouplingStep moveTo(const Vector3& device, const ProxyLoad& load = {}) {
        const CouplingStep step = stepCoupling(gains_, device - device_, stretch_, load, tick_);
        device_ = device;
        stretch_ = step.stretch;
        return step;
    }
    [[nodiscard]] Vector3 proxy() const { return device_ - stretch_; }

private:
    CouplingGains gains_;
    double tick_;
    Vector3 device_ = Vector3::Zero();
    Vector3 stretch_ = Vector3::Zero();
};

TEST(VirtualCoupling, TheDeviceFeelsContactAndCouplingInSeries) {
    CoupledDevice coupled;
    const Vector3 device(0.3e-3, -0.4e-3, 2e-3);
    Vector3 force = Vector3::Zero();
    for (int i = 0; i < 1000; ++i) {
        force = coupled.moveTo(device, {.force = -1400.0 * coupled.proxy()}).device;
    }
    const double series = 1.0 / (1.0 / 300.0 + 1.0 / 1400.0);
    EXPECT_LT((force + series * device).norm(), 1e-9 * force.norm());
}

TEST(VirtualCoupling, AtRestTheDeviceFeelsTheLoadItself) {
    CoupledDevice coupled;
    const Vector3 load(0.1, -0.2, 1.5);
    Vector3 force = Vector3::Zero();
    for (int i = 0; i < 1000; ++i) {
        force = coupled.moveTo(Vector3::Zero(), {.force = load}).device;
    }
    EXPECT_LT((force - load).norm(), 1e-9);
    EXPECT_LT((coupled.proxy() - load / kGains.stiffness).norm(), 1e-12);
}

TEST(VirtualCoupling, DragInFreeAirIsTheProxysDamping) {
    CoupledDevice air;
    const Vector3 velocity(0.0, 0.05, -0.1);
    Vector3 force = Vector3::Zero();
    for (int i = 0; i < 1000; ++i) {
        force = air.moveTo(i * kTick * velocity).device;
    }
    EXPECT_LT((force + kGains.proxyDamping * velocity).norm(), 1e-9);
}

TEST(VirtualCoupling, SettlesAtAnyRateAndGain) {
    for (const double tick : {0.05e-3, 1e-3, 0.1}) {
        for (const double stiffness : {10.0, 300.0, 1e6}) {
            CoupledDevice air({.stiffness = stiffness, .damping = 0.01, .proxyDamping = 3.0}, tick);
            Vector3 force = Vector3::Zero();
            for (int i = 0; i < std::lround(10.0 / tick); ++i) {
                force = air.moveTo({0.0, 0.0, 1e-3}).device;
                ASSERT_LE(air.proxy().z(), 1e-3 * (1.0 + 1e-12)) << tick << " " << stiffness;
            }
            EXPECT_LT(force.norm(), 1e-9) << tick << " " << stiffness;
        }
    }
}

TEST(VirtualCoupling, AnEncoderStepKicksWithTheSameImpulseAtAnyRate) {
    constexpr double kStep = 30e-6;  // [m]
    for (const double tick : {0.25e-3, 1e-3}) {
        // The proxy cannot move and the spring is slack: the damper alone is left.
        const CouplingGains damper{.stiffness = 1e-9, .damping = 2.0, .proxyDamping = 1e12};
        const Vector3 kick =
            stepCoupling(damper, {kStep, 0.0, 0.0}, Vector3::Zero(), {}, tick).device;
        EXPECT_NEAR(-kick.x() * tick, damper.damping * kStep, 1e-6 * damper.damping * kStep);
    }
}

/// A load that presses on a surface across `normal` with this friction.
ProxyLoad rubbing(const Vector3& normal, double friction) {
    return {.force = normal, .normal = normal, .friction = friction, .restSpeed = 1e-3};
}

TEST(VirtualCoupling, SlidingMeetsTheFrictionOfItsSpeed) {
    const Vector3 normal = Vector3(0.3, 0.0, 1.0).normalized();
    const Vector3 velocity = 0.02 * normal.cross(Vector3::UnitY());
    for (const double friction : {0.0, 0.01, 0.3, 30.0}) {
        CoupledDevice coupled;
        CouplingStep step;
        for (int i = 0; i < 20000; ++i) {
            step = coupled.moveTo(i * kTick * velocity, rubbing(normal, friction));
        }
        const double share = 0.02 / std::hypot(0.02, 1e-3);
        const double drag = kGains.proxyDamping * 0.02 + friction * share;
        const Vector3 expected = normal - drag * velocity.normalized();
        EXPECT_LT((step.device - expected).norm(), 1e-9 * expected.norm()) << friction;
    }
}

TEST(VirtualCoupling, FrictionNeverThrowsAProxyBack) {
    // Stuck by far more friction than pulls at it, it creeps towards the device, tick by tick less.
    CoupledDevice coupled;
    const ProxyLoad load = rubbing(Vector3::UnitZ(), 5.0);
    double last = 1.0;
    double way = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const CouplingStep step = coupled.moveTo({1e-3, 0.0, 0.0}, load);
        ASSERT_GE(step.motion.x(), 0.0) << i;
        ASSERT_LE(step.motion.x(), last) << i;
        last = step.motion.x();
        way += last;
    }
    // Far below its largest value friction is viscous, friction / v0: a spring on a damper.
    const double time = 100.0 * kGains.stiffness / (5.0 / 1e-3 + kGains.proxyDamping);
    EXPECT_NEAR(way, 1e-3 * -std::expm1(-time), 1e-6);
}

}  // namespace
}  // namespace asperity
