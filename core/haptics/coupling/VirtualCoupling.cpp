#include "core/haptics/coupling/VirtualCoupling.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Speed s of a proxy that is pushed along the surface: push = resistance s + friction s / sqrt(s^2
/// + v0^2). The right side rises and bends down, so that Newton's steps from below stay below.
double slidingSpeed(double push, double resistance, const ProxyLoad& load) {
    constexpr int kMaxSteps = 40;
    constexpr double kAccuracy = 1e-12;
    double speed = std::max(0.0, push - load.friction) / resistance;
    for (int i = 0; i < kMaxSteps; ++i) {
        const double total = std::hypot(speed, load.restSpeed);
        const double rest = push - resistance * speed - load.friction * (speed / total);
        const double fading = load.restSpeed / total;
        const double slope = resistance + load.friction / total * fading * fading;
        const double step = rest / slope;
        speed += step;
        if (!(step > kAccuracy * speed)) {
            break;
        }
    }
    return speed;
}

/// Velocity of a proxy under `push` [N], its friction included.
Vector3 proxyVelocity(const Vector3& push, double resistance, const ProxyLoad& load) {
    const Vector3 along = push - push.dot(load.normal) * load.normal;
    const double size = along.norm();
    if (!(load.friction > 0.0 && size > 0.0)) {
        return push / resistance;
    }
    const double speed = slidingSpeed(size, resistance, load);
    return (push - along) / resistance + (speed / size) * along;
}

}  // namespace

CouplingStep stepCoupling(const CouplingGains& gains, const Vector3& deviceMotion,
                          const Vector3& stretch, const ProxyLoad& load, double timeStep) noexcept {
    // F = Kc (stretch + deviceMotion - T vp) + Bc (deviceMotion / T - vp) put into the balance
    // leaves resistance * vp = push + friction.
    const double resistance =
        gains.proxyDamping + gains.damping + gains.stiffness * timeStep;  // [N s/m]
    const Vector3 push = gains.stiffness * (stretch + deviceMotion) +
                         (gains.damping / timeStep) * deviceMotion + load.force;
    const Vector3 velocity = proxyVelocity(push, resistance, load);
    const Vector3 friction = resistance * velocity - push;
    const Vector3 motion = timeStep * velocity;
    return {.device = load.force + friction - gains.proxyDamping * velocity,
            .motion = motion,
            .stretch = stretch + deviceMotion - motion};
}

}  // namespace asperity
