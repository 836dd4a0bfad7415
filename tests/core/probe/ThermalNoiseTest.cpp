#include "core/Error.h"
#include "core/Units.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/SimulatedAfm.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/core/probe/ReferenceLever.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;

constexpr double kThermalEnergy = 1.380649e-23 * 300.0;  // kB T [J]

std::vector<double> samples(const Oscillator& lever, double timeStep, int count) {
    ThermalNoise noise(lever, 300.0, timeStep, 5);
    std::vector<double> values(static_cast<std::size_t>(count));
    for (double& value : values) {
        value = noise.next();
    }
    return values;
}

double meanProduct(const std::vector<double>& values, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < values.size(); ++i) {
        sum += values[i] * values[i + lag];
    }
    return sum / static_cast<double>(values.size() - lag);
}

/// Equipartition, whatever damping and step; the correlation from sample to sample is that of the
/// free motion.
TEST(ThermalNoise, HasTheVarianceOfEquipartitionAndTheMemoryOfTheLever) {
    constexpr int kCount = 400000;
    for (const double quality : {0.2, 0.5, 3.0, 20.0}) {
        for (const double phase : {0.3, 2.0, 1283.0}) {
            SCOPED_TRACE(testing::Message() << "Q " << quality << ", w0 dt " << phase);
            const Oscillator lever{14.4, 1.28e6, quality};
            const double timeStep = phase / lever.angularFrequency;
            const auto values = samples(lever, timeStep, kCount);
            const double variance = kThermalEnergy / lever.stiffness;
            // The slower rate of decay says how many samples are independent.
            const double damping = 0.5 / quality;
            const double rate =
                damping > 1.0 ? damping - std::sqrt((damping * damping) - 1.0) : damping;
            const double independent = kCount * std::min(1.0, 0.5 * rate * phase);
            const double limit = 5.0 * std::sqrt(2.0 / independent);
            EXPECT_NEAR(meanProduct(values, 0) / variance, 1.0, limit);
            for (const std::size_t lag : {1U, 2U}) {
                const Eigen::Matrix2d free =
                    LeverResonance(lever, timeStep * static_cast<double>(lag)).propagator();
                EXPECT_NEAR(meanProduct(values, lag) / variance, free(0, 0), limit);
            }
        }
    }
}

/// Power of one frequency, averaged over pieces under a Hann window.
double power(const std::vector<double>& values, double phasePerSample) {
    constexpr std::size_t kPiece = 1000;
    double sum = 0.0;
    for (std::size_t start = 0; start + kPiece <= values.size(); start += kPiece) {
        std::complex<double> amplitude;
        for (std::size_t i = 0; i < kPiece; ++i) {
            const auto position = static_cast<double>(i);
            const double window = 1.0 - std::cos(2.0 * pi * position / kPiece);
            amplitude += values[start + i] * window * std::polar(1.0, -phasePerSample * position);
        }
        sum += std::norm(amplitude);
    }
    return sum;
}

/// The spectrum is that of a damped oscillator under white force: flat below the resonance and Q^2
/// higher at it.
TEST(ThermalNoise, ResonatesInItsSpectrum) {
    constexpr double kQuality = 5.0;
    constexpr double kPhase = 0.2;  // of the resonance per sample
    const auto values = samples({14.4, 1.28e6, kQuality}, kPhase / 1.28e6, 400000);
    const double atResonance = power(values, kPhase);
    for (const double ratio : {0.1, 0.5, 0.8, 1.5, 2.5}) {
        const double detuned = 1.0 - (ratio * ratio);
        const double expected = 1.0 / (kQuality * kQuality * detuned * detuned + ratio * ratio);
        // 400 pieces: five standard errors of both, and a little aliasing.
        EXPECT_NEAR(power(values, ratio * kPhase) / (expected * atResonance), 1.0, 0.4) << ratio;
    }
}

TEST(ThermalNoise, RestsWithoutTemperatureAndRefusesANegativeOne) {
    ThermalNoise cold({1.0, 1e5, 10.0}, 0.0, 1e-3, 1);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(cold.next(), 0.0);
    }
    for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW((ThermalNoise{{1.0, 1e5, 10.0}, bad, 1e-3, 1}), Error);
    }
}

/// A lever that touches nothing, warm or cold, over a detector without noise.
class WarmAfm : public ::testing::Test {
protected:
    SimulatedAfm afm(double temperature, std::uint64_t seed) {
        InstrumentTruth truth = truthOf(scene);
        truth.noise = {};
        truth.temperature = temperature;
        truth.timeStep = scene.timeStep();
        truth.seed = seed;
        return {scene.surface, truth};
    }

    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const BaseMotion farAway{.position = {64.0_nm, 64.0_nm, 900.0_nm}};
};

TEST_F(WarmAfm, ShakesTheBendingSignalByTheFundamentalMode) {
    const FlexuralMode mode = flexuralMode(truthOf(scene).system.cantilever.geometry(), 1);
    SimulatedAfm warm = afm(300.0, 3);
    SimulatedAfm cold = afm(0.0, 3);
    const double still = cold.exchange(farAway).signals.bending;
    constexpr int kCount = 20000;
    double squares = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const LeverSignals signals = warm.exchange(farAway).signals;
        squares += (signals.bending - still) * (signals.bending - still) / kCount;
        ASSERT_EQ(signals.torsion, cold.exchange(farAway).signals.torsion);
    }
    const double expected = mode.endSlope * mode.endSlope * kThermalEnergy / mode.stiffness;
    EXPECT_NEAR(squares / expected, 1.0, 5.0 * std::sqrt(2.0 / kCount));
    EXPECT_NEAR(std::sqrt(expected), 1.6e-7, 0.05e-7) << "as large as the detector's noise";
}

TEST_F(WarmAfm, IsAsWarmAndAsFastAsItsScene) {
    SceneDescription description = test::plainScene();
    EXPECT_EQ(truthOf(scene).temperature, 0.0) << "cold unless asked";
    description.truth.temperature = 77.0;
    description.tickRate = 4000.0;
    const Scene warm = buildScene(description, test::flatMap());
    EXPECT_EQ(truthOf(warm).temperature, 77.0);
    EXPECT_EQ(truthOf(warm).timeStep, warm.timeStep());
    description.truth.temperature = -1.0;
    EXPECT_THROW((void)buildScene(description, test::flatMap()), Error);
}

TEST_F(WarmAfm, RepeatsItselfForTheSameSeedOnly) {
    SimulatedAfm first = afm(300.0, 3);
    SimulatedAfm same = afm(300.0, 3);
    SimulatedAfm other = afm(300.0, 4);
    int equal = 0;
    for (int i = 0; i < 100; ++i) {
        const double bending = first.exchange(farAway).signals.bending;
        ASSERT_EQ(bending, same.exchange(farAway).signals.bending);
        equal += bending == other.exchange(farAway).signals.bending ? 1 : 0;
    }
    EXPECT_EQ(equal, 0);
}

TEST_F(WarmAfm, DoesNotAllocate) {
    SimulatedAfm warm = afm(300.0, 3);
    double sum = 0.0;
    const std::size_t before = test::allocationCount();
    for (int i = 0; i < 100; ++i) {
        sum += warm.exchange(farAway).signals.bending;
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace asperity
