#include "core/haptics/coupling/CouplingDesign.h"

#include "core/Error.h"
#include "core/SiFormat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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

constexpr double kMaxCouplingStiffness = 600.0;  // [N/m]
constexpr double kProxyDamping = 3.0;            // [N s/m]
constexpr double kMinHandleMass = 0.045;         // [kg]
constexpr double kDampingRatio = 0.15;           // that the delay leaves
constexpr double kDelayedStiffness = 1.0 / 6.0;  // Kc tau^2 / m

void check(const DeviceSpecification& device, const LoopTiming& timing) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(device.maxStiffness) || !positive(device.maxDamping)) {
        throw Error("a haptic device's maximum stiffness and damping must be positive numbers");
    }
    if (device.effectiveMass != 0.0 && !positive(device.effectiveMass)) {
        throw Error("a haptic device's effective mass must be a positive number, or 0: not known");
    }
    if (!positive(timing.timeStep) || !(timing.delay == 0.0 || positive(timing.delay))) {
        throw Error("the loop's time step must be a positive number, its delay that or 0");
    }
}

/// Bc for a stiffness.
double dampingFor(double stiffness, double mass, double age) {
    return stiffness * age + 2.0 * kDampingRatio * std::sqrt(stiffness * mass);
}

/// The stiffness whose dampingFor() is `damping`: a quadratic in its root.
double stiffnessFor(double damping, double mass, double age) {
    const double half = kDampingRatio * std::sqrt(mass);
    const double root = damping / (half + std::sqrt(half * half + age * damping));
    return root * root;
}

double massOf(const DeviceSpecification& device) {
    return device.effectiveMass > 0.0 ? device.effectiveMass : kMinHandleMass;
}

double ageOf(const LoopTiming& timing) { return timing.timeStep / 2.0 + timing.delay; }

constexpr double kForceControl = 1e3;  // compliance beside which no indentation counts [m/N]

/// Returns what is left for the contact beside a guide, from (K + k) T/2 + b = bp [N/m].
double contactBound(const CouplingGains& gains, const GuideLoad& guide, double timeStep) {
    CouplingGains left = gains;
    left.proxyDamping -= guide.damping;
    return stiffestContact(left, timeStep) - guide.stiffness;
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

CouplingGains designCoupling(const DeviceSpecification& device, const LoopTiming& timing) {
    check(device, timing);
    const double mass = massOf(device);
    const double age = ageOf(timing);
    const double stiffness = std::min({device.maxStiffness, kMaxCouplingStiffness,
                                       kDelayedStiffness * mass / (age * age),
                                       stiffnessFor(device.maxDamping, mass, age)});
    if (stiffness < kMinCouplingStiffness) {
        throw Error("the haptic device holds no coupling stiffer than " +
                    formatSi(stiffness, "N/m") + " with a force that is " + formatSi(age, "s") +
                    " old; at least " + formatSi(kMinCouplingStiffness, "N/m") +
                    " are needed: a shorter delay or a higher rate");
    }
    return {.stiffness = stiffness,
            .damping = dampingFor(stiffness, mass, age),
            .proxyDamping = kProxyDamping};
}

bool holdsHandle(const CouplingGains& gains, const DeviceSpecification& device,
                 const LoopTiming& timing) {
    check(device, timing);
    if (gains.stiffness > device.maxStiffness || gains.damping > device.maxDamping) {
        return false;
    }
    // With x = omega tau: |k + i beta x| = x^2 where the gain is 1.
    const double age = ageOf(timing);
    const double k = gains.stiffness * age * age / massOf(device);
    const double beta = gains.damping * age / massOf(device);
    const double crossover =
        std::sqrt((beta * beta + std::sqrt(std::pow(beta, 4.0) + 4.0 * k * k)) / 2.0);
    return std::atan2(beta * crossover, k) > crossover;
}

double stiffestContact(const CouplingGains& gains, double timeStep) noexcept {
    return 2.0 * gains.proxyDamping / timeStep;
}

double inSeries(double first, double second) noexcept { return 1.0 / (1.0 / first + 1.0 / second); }

TipLoad tipLoad(const ProbeSystem& system, double largestForce, PositionControl control) noexcept {
    const ContactModel& contact = system.contact;
    const double lever = 1.0 / system.cantilever.compliance()(2, 2);
    const ContactState pressed =
        contact.equilibrium(kForceControl * largestForce, kForceControl, {});
    const double stiffness =
        control == PositionControl::Tip ? pressed.stiffness : inSeries(lever, pressed.stiffness);
    return {.stiffness = pressed.solved() ? stiffness : lever,
            .adhesion = std::max(0.0, -contact.lastBonded(kForceControl).force)};
}

ScaleJudgment judgeScale(const TipLoad& tip, const DeviceScale& scale,
                         const std::optional<CouplingGains>& coupling, const ScaleBounds& bounds,
                         const GuideLoad& guide) {
    const double contact = tip.stiffness * scale.forceGain * scale.positionGain;
    return {.contact = contact,
            .contactBound = coupling ? contactBound(*coupling, guide, bounds.timeStep)
                                     : std::numeric_limits<double>::infinity(),
            .felt = coupling ? inSeries(contact, coupling->stiffness) : contact,
            .feltBound = bounds.stiffness,
            .adhesion = tip.adhesion * scale.forceGain,
            .forceBound = bounds.force,
            .guided = guide.stiffness > 0.0 || guide.damping > 0.0};
}

}  // namespace asperity
