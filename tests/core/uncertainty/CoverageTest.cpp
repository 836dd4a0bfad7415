#include "core/Random.h"
#include "core/map/PixelCycle.h"
#include "core/uncertainty/LandmarkBudgets.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <optional>
#include <vector>

namespace asperity {
namespace {

constexpr double kSide = 60e-9;       // [m]
constexpr int kPixels = 40;           // of 1.5 nm
constexpr double kNoise = 20e-12;     // of the heights [m]
constexpr double kSetpoint = 5e-9;    // [N]
constexpr double kInterval = 1.96;    // standard deviations of 95 %
constexpr double kImagingTip = 8e-9;  // [m]
const Vector2 kCenter(30e-9, 30e-9);  // of scan and sample
const Vector2 kAside(3e-9, 0.0);      // where the tip goes down, from the middle

/// A sample, and what a scan of it is taken for.
struct Sample {
    const char* name;
    double (*height)(const Vector2& fromMiddle);  ///< [m]
    std::optional<ShapeDescription> shape = {};   ///< that is exactly this one
    bool eroded = false;                          ///< whether its scan is
};

double sphere(const Vector2& position) {
    constexpr double kRadius = 60e-9;
    return std::sqrt((kRadius * kRadius) - position.squaredNorm());
}

/// Grains 40 nm apart; radii of curvature from 27 nm on.
double film(const Vector2& position) {
    constexpr double kWave = 2.0 * std::numbers::pi / 40e-9;
    return 1.5e-9 * std::cos((kWave * position.x()) + 0.7) * std::cos((kWave * position.y()) - 0.4);
}

/// 20 nm of radius at its top, on a plane.
double particle(const Vector2& position) {
    constexpr double kWidth = 9e-9;
    return 4e-9 * std::exp(-0.5 * position.squaredNorm() / (kWidth * kWidth));
}

const std::array<Sample, 5> kSamples{
    {{"flat", [](const Vector2& /*position*/) { return 0.0; },
      ShapeDescription{.kind = ShapeKind::Plane, .size = kSide}},
     {"sphere", sphere,
      ShapeDescription{.kind = ShapeKind::Sphere, .radius = 60e-9, .size = kSide}},
     {"film", film},
     {"particle, not eroded", particle},
     {"particle, eroded", particle, std::nullopt, true}}};

struct Compared {
    Landmark landmark;
    std::optional<MapQuantity> quantity;  ///< none: the force at the setpoint
};
constexpr std::array<Compared, 5> kCompared{
    {{Landmark::AdhesionForce, MapQuantity::AdhesionForce},
     {Landmark::SeparationWork, MapQuantity::SeparationWork},
     {Landmark::Indentation, MapQuantity::Indentation},
     {Landmark::Stiffness, MapQuantity::Stiffness},
     {Landmark::NormalForce, std::nullopt}}};

SceneDescription believed(const Sample& sample) {
    SceneDescription scene = test::plainScene();
    scene.choices.law = ContactLaw::Maugis;
    scene.sample.smoothingPixels = 1.0;
    scene.sample.imagingTipRadius = kImagingTip;
    scene.sample.erode = sample.eroded;
    scene.setpoint = kSetpoint;
    return scene;
}

/// Height at which the apex of a tip touches the sample above a position, both from the middle: the
/// point where it touches is a radius of the tip, along the normal, from its center.
double touchedBy(double tipRadius, const Sample& sample, const Vector2& position) {
    constexpr double kStep = 1e-11;  // [m]
    constexpr int kIterations = 30;  // at most half of the error is left by each
    Vector2 contact = position;
    Vector3 normal = Vector3::UnitZ();
    for (int i = 0; i < kIterations; ++i) {
        const auto slope = [&](const Vector2& way) {
            return (sample.height(contact + kStep * way) - sample.height(contact - kStep * way)) /
                   (2.0 * kStep);
        };
        normal = Vector3(-slope(Vector2::UnitX()), -slope(Vector2::UnitY()), 1.0).normalized();
        contact = position - tipRadius * normal.head<2>();
    }
    return sample.height(contact) + tipRadius * (normal.z() - 1.0);
}

HeightMap mapOf(int pixels, const auto& heightAt) {
    const double pitch = kSide / pixels;
    HeightMap map{.columns = pixels, .rows = pixels, .pitchX = pitch, .pitchY = pitch};
    for (int row = 0; row < pixels; ++row) {
        for (int column = 0; column < pixels; ++column) {
            map.heights.push_back(
                heightAt(Vector2((column + 0.5) * pitch, kSide - ((row + 0.5) * pitch)) - kCenter));
        }
    }
    return map;
}

/// What the instrument really is.
struct Truth {
    const Sample& sample;
    SceneDescription scene;
    double heightScale = 1.0;   ///< true height per shown one
    double lateralScale = 1.0;  ///< true length per shown one
    double imagingTip = 0.0;    ///< [m]

    /// Draws each input from its stated deviation.
    Truth(const Sample& of, Random& random) : sample(of), scene(believed(of)) {
        const Uncertainty given = scene.uncertainty;
        const auto factor = [&random](double deviation) {
            return std::exp(random.normal() * std::log1p(deviation));
        };
        const double stiffness = factor(given.stiffness);
        scene.probe.thickness = thicknessForStiffness(scene.probe, 14.0 * stiffness);
        scene.setpoint = kSetpoint * stiffness * factor(given.invOls);
        scene.tip.radius *= factor(given.tipRadius);
        scene.sample.material.elastic.youngsModulus *= factor(given.modulus);
        scene.sample.material.workOfAdhesion *= factor(given.workOfAdhesion);
        scene.cohesiveRange *= factor(given.cohesiveRange);
        heightScale = factor(given.heightCalibration);
        lateralScale = factor(given.lateralCalibration);
        imagingTip = kImagingTip * factor(given.imagingTip);
        scene.sample.smoothingPixels = 0.0;
        scene.sample.imagingTipRadius = 0.0;
        scene.sample.erode = false;
        scene.sample.shape = sample.shape;
    }

    /// What the microscope shows of the sample.
    [[nodiscard]] HeightMap scan(Random& random) const {
        return mapOf(kPixels, [&](const Vector2& shown) {
            return (touchedBy(imagingTip, sample, lateralScale * shown) / heightScale) +
                   (kNoise * random.normal());
        });
    }

    /// The run on the sample itself, which the tip's apex touches where the scan has it.
    [[nodiscard]] MapValues values() const {
        constexpr int kFine = 120;  // of half a nanometer
        const Scene real =
            sample.shape ? buildScene(scene) : buildScene(scene, mapOf(kFine, sample.height));
        return pixelCycle(MapInstrument(real, false), kCenter + (lateralScale * kAside),
                          scene.setpoint);
    }
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// How often the stated interval holds the truth, and how wide it is.
struct Coverage {
    int held = 0;
    std::vector<double> deviations;  ///< stated, relative
    double squares = 0.0;            ///< of the relative errors

    void take(const Budget& budget, double truth) {
        const double error = budget.value - budget.shift - truth;
        held += std::abs(error) <= kInterval * budget.total() ? 1 : 0;
        deviations.push_back(budget.total() / budget.value);
        squares += (error / budget.value) * (error / budget.value);
    }
    [[nodiscard]] double widthOverScatter() const {
        return medianOf(deviations) / std::sqrt(squares / static_cast<double>(deviations.size()));
    }
};

using Coverages = std::array<Coverage, kCompared.size()>;

Coverages coverageOf(const Sample& sample, int scans) {
    Coverages coverage;
    Random random(43);
    for (int i = 0; i < scans; ++i) {
        const Truth truth(sample, random);
        const Scene scene = buildScene(believed(sample), truth.scan(random));
        const Vector2 position = kCenter + kAside;
        const MapValues shown = pixelCycle(MapInstrument(scene, false), position, kSetpoint);
        const LandmarkBudgets budgets = budgetsAt(scene, position, kSetpoint);
        const MapValues real = truth.values();
        for (std::size_t k = 0; k < kCompared.size(); ++k) {
            const auto [landmark, quantity] = kCompared[k];
            const double read = quantity ? shown[*quantity] : kSetpoint;
            coverage[k].take(budgetOf(budgets, landmark).of(read, 0.0),
                             quantity ? real[*quantity] : truth.scene.setpoint);
        }
    }
    for (std::size_t k = 0; k < kCompared.size(); ++k) {
        std::cout << sample.name << ", " << nameOf(kCompared[k].landmark) << ": "
                  << coverage[k].held << " of " << scans << ", width over scatter "
                  << coverage[k].widthOverScatter() << '\n';
    }
    return coverage;
}

/// The most misses of `count` that happen by chance at least as often as `chance`, each with
/// the probability `miss`: binomial distribution.
int mostMisses(int count, double miss, double chance) {
    double below = 0.0;  // probability of fewer
    double term = std::pow(1.0 - miss, count);
    for (int misses = 0; misses < count; ++misses) {
        if (1.0 - below < chance) {
            return misses - 1;
        }
        below += term;
        term *= (count - misses) / (misses + 1.0) * miss / (1.0 - miss);
    }
    return count;
}

/// All of it fails by chance at most once in 10^4, were each interval to hold the truth in the
/// least share that is allowed, 92 %, and each width the largest, 1.3: 25 counts and as many
/// scatters. 16 misses of 50, or more, come 9.8 times in 10^7 then, in one of 25 counts 2.5 times
/// in 10^5; a chi^2 of 50 degrees is below 0.55^2 of its mean 6 times in 10^7. No count is too
/// high: 50 of 50 is what one interval in 13 shows.
TEST(Coverage, OfFiftyScansOfEach) {
    constexpr int kScans = 50;
    const double chance = 0.5e-4 / (kSamples.size() * kCompared.size());
    const int misses = mostMisses(kScans, 0.08, chance);
    EXPECT_EQ(misses, 15);
    for (const Sample& sample : kSamples) {
        SCOPED_TRACE(sample.name);
        for (const Coverage& one : coverageOf(sample, kScans)) {
            EXPECT_GE(one.held, kScans - misses);
            EXPECT_LT(one.widthOverScatter(), 1.3 / 0.55);
        }
    }
}

class CoverageLong : public ::testing::TestWithParam<std::size_t> {};

TEST_P(CoverageLong, OfAThousandScans) {
    const Sample& sample = kSamples.at(GetParam());
    for (const Coverage& one : coverageOf(sample, 1000)) {
        EXPECT_GE(one.held, 920);
        EXPECT_LE(one.held, 980);
        EXPECT_LT(one.widthOverScatter(), 1.3);
    }
}

INSTANTIATE_TEST_SUITE_P(, CoverageLong, ::testing::Range<std::size_t>(0, kSamples.size()));

}  // namespace
}  // namespace asperity
