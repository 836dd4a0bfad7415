#include "bench/probe/FalseAlarms.h"

#include "core/Random.h"
#include "core/Units.h"
#include "core/probe/DecouplingRows.h"
#include "core/probe/InnovationMonitor.h"
#include "core/scene/SceneDescription.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace asperity {

namespace {

constexpr double kNoise = 1e-7;  // [rad]

struct Situation {
    const char* name;
    Vector3 normal = Vector3::UnitZ();
    Vector3 velocity = Vector3::Zero();  ///< [m/s]
    double normalForce = 0.0;            ///< [N]
    double contactArea = 0.0;            ///< [m^2]
    double rate = 1000.0;                ///< [Hz]
};

struct Alarms {
    long contradicted = 0;  ///< times that the flag came
    long inconsistent = 0;
};

/// Signals of the force that is believed, with noise as it is stated.
Alarms alarmsOf(const Situation& situation, const Cantilever& lever, double seconds) {
    InnovationInput input{
        .belief = {.signals = {},
                   .sigma = {kNoise, kNoise},
                   .normal = situation.normal,
                   .velocity = situation.velocity,
                   .frictionCoefficient = 0.3,
                   .shearStrength = 30.0_MPa,
                   .contactArea = situation.contactArea,
                   .normalForceModel = situation.normalForce,
                   .normalForceSigma = 0.2 * std::abs(situation.normalForce) + 0.1_nN},
        .timeStep = 1.0 / situation.rate};
    const DecouplingInput& belief = input.belief;
    const Vector3 normal = situation.normal.normalized();
    const double friction =
        std::max(0.0, 0.3 * situation.normalForce + decoupling::adhesiveFriction(belief));
    const Vector3 slip = slidingOf(normal, situation.velocity).slip();
    const LeverSignals expected =
        leverSignals(lever, (situation.normalForce * normal) + (friction * slip));
    Random random(7);
    InnovationMemory memory;
    InnovationVerdict before;
    Alarms alarms;
    const long ticks = std::lround(seconds * situation.rate);
    for (long i = 0; i < ticks; ++i) {
        input.belief.signals = {expected.bending + kNoise * random.normal(),
                                expected.torsion + kNoise * random.normal()};
        const InnovationVerdict now = monitorInnovation(lever, input, memory);
        alarms.contradicted += now.modelContradicted && !before.modelContradicted ? 1 : 0;
        alarms.inconsistent += now.estimateInconsistent && !before.estimateInconsistent ? 1 : 0;
        before = now;
    }
    return alarms;
}

/// Upper limit at 95 % of the mean of a Poisson count (Wilson and Hilferty), exact for 0.
double upperLimit(long count) {
    if (count == 0) {
        return -std::log(0.05);
    }
    const double n = static_cast<double>(count) + 1.0;
    return n * std::pow(1.0 - (1.0 / (9.0 * n)) + (1.645 / (3.0 * std::sqrt(n))), 3.0);
}

}  // namespace

bool printFalseAlarms(double seconds) {
    const Cantilever lever(defaultScene().probe);
    const Vector3 slope = Vector3(0.3, -0.2, 1.0).normalized();
    const Situation situations[] = {
        {.name = "free air"},
        {.name = "free air, sideways", .velocity = {1e-6, 2e-6, 0.0}},
        {.name = "contact, at rest", .normalForce = 10.0_nN, .contactArea = 8e-17},
        {.name = "along the beam",
         .velocity = {1e-7, 0.0, 0.0},
         .normalForce = 10.0_nN,
         .contactArea = 8e-17},
        {.name = "across the beam",
         .velocity = {0.0, 1e-7, 0.0},
         .normalForce = 10.0_nN,
         .contactArea = 8e-17},
        {.name = "across, light",
         .velocity = {0.0, 1e-7, 0.0},
         .normalForce = 1.0_nN,
         .contactArea = 1e-17},
        {.name = "slope, pulled",
         .normal = slope,
         .velocity = {1e-7, 1e-7, 0.0},
         .normalForce = -3.0_nN,
         .contactArea = 3e-17},
        {.name = "across, 100 Hz",
         .velocity = {0.0, 1e-7, 0.0},
         .normalForce = 10.0_nN,
         .contactArea = 8e-17,
         .rate = 100.0},
        {.name = "across, 20 kHz",
         .velocity = {0.0, 1e-7, 0.0},
         .normalForce = 10.0_nN,
         .contactArea = 8e-17,
         .rate = 20000.0}};
    std::printf("False alarms with truth = belief, %.3g s each\n", seconds);
    std::printf("%-20s %12s %14s %14s %18s\n", "situation", "ticks", "contradicted", "inconsistent",
                "per s, at most");
    bool good = true;
    for (const Situation& situation : situations) {
        const Alarms alarms = alarmsOf(situation, lever, seconds);
        const double rate = upperLimit(alarms.contradicted + alarms.inconsistent) / seconds;
        std::printf("%-20s %12.3g %14ld %14ld %18.2g\n", situation.name, seconds * situation.rate,
                    alarms.contradicted, alarms.inconsistent, rate);
        good = good && rate <= 1e-4;
    }
    return good;
}

}  // namespace asperity
