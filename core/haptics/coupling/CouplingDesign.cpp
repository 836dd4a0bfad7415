#include "core/haptics/coupling/CouplingDesign.h"

#include "core/Error.h"
#include "core/SiFormat.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {

namespace {

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

}  // namespace

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

}  // namespace asperity
