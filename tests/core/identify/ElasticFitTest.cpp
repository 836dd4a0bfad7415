#include "core/identify/ElasticFit.h"

#include "core/identify/ContactPoint.h"
#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/identify/SyntheticCurve.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <string>

namespace asperity {
namespace {

using test::SyntheticCurve;

TipForm tipOf(const std::string& model, double size) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const std::map<std::string, TipKind> kinds{{"sphere", TipKind::Sphere},
                                               {"paraboloid", TipKind::Paraboloid},
                                               {"cone", TipKind::Cone},
                                               {"pyr4", TipKind::Pyramid4}};
    TipForm tip{.kind = kinds.at(model)};
    (hasRadius(tip.kind) ? tip.radius : tip.angle) = hasRadius(tip.kind) ? size : size * kDegree;
    return tip;
}

/// A fit of the approach as a command makes it.
struct ApproachFit {
    PreparedCurve curve;
    ElasticFit fit;

    ApproachFit(const MeasuredForceCurve& measured, const PreparationOptions& options,
                const TipForm& tip)
        : curve(prepareCurve(measured, options)) {
        const BranchSamples& approach = curve.approach;
        const double start = *contactPoint(ContactMethod::Deviation, approach,
                                           curve.correctedForce(approach), curve.baseline.noise);
        const double deepest = *std::max_element(approach.base.begin(), approach.base.end());
        const TipLaw law(tip, {}, 2.0 * (deepest - start));
        fit = fitElastic(approach, curve.stiffness, law, start);
    }
};

TEST(ElasticFit, HoldsTheReferenceFits) {
    ASPERITY_NEEDS_SHARED_DATA();
    const test::ReferenceTable table(test::sharedData("curves/EXPECTED_FITS.csv"));
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string name = table.text(row, "curve");
        const MeasuredForceCurve measured =
            readForceCurve(test::sharedData("curves/csv/" + name + ".csv"));
        const ApproachFit found(measured, {.stiffness = table.number(row, "k")},
                                tipOf(table.text(row, "model"), table.number(row, "tip")));
        const double ratio = table.number(row, "nu");
        const double modulus = found.fit.reducedModulus * (1.0 - ratio * ratio);
        const bool good = table.number(row, "rms_contact_over_range") < 0.03;
        const double expected = table.number(row, "E_Pa");
        EXPECT_NEAR(modulus, expected, (good ? 0.005 : 0.03) * expected) << name;
        EXPECT_NEAR(found.fit.contact, table.number(row, "x0_m"),
                    0.3 * table.number(row, "x0_std_m"))
            << name;
        EXPECT_NEAR(found.fit.rms, table.number(row, "rms_N"), 0.02 * table.number(row, "rms_N"))
            << name;
        EXPECT_NEAR(std::sqrt(found.fit.covariance(0, 0)) / found.fit.reducedModulus,
                    table.number(row, "E_rel_std"), 0.1 * table.number(row, "E_rel_std"))
            << name;
    }
    EXPECT_GT(table.rows(), 10U);
}

TEST(ElasticFit, FindsWhatMadeACurve) {
    for (const TipForm& tip : {TipForm{.kind = TipKind::Sphere, .radius = 5e-6},
                               TipForm{.kind = TipKind::ConeSphere, .radius = 50e-9, .angle = 0.4},
                               TipForm{.kind = TipKind::Cone, .angle = 0.5}}) {
        SyntheticCurve given;
        given.tip = tip;
        given.reducedModulus = 1e4;
        given.noise = 1e-13;
        const ApproachFit found(given.curve(), {}, tip);
        EXPECT_NEAR(found.fit.reducedModulus, 1e4, 10.0) << keyOf(tip.kind);
        EXPECT_NEAR(found.fit.contact, given.contact, 1e-9) << keyOf(tip.kind);
        EXPECT_NEAR(found.fit.slope, given.tilt, 1e-2 * given.tilt) << keyOf(tip.kind);
        EXPECT_TRUE(found.fit.converged);
    }
}

/// Scatter of modulus and contact over many curves, against what the fits state.
void expectStatedScatter(double memory) {
    constexpr int kSeeds = 50;
    SyntheticCurve given;
    given.noise = 2e-11;
    given.memory = memory;
    const TipLaw law(given.tip, {}, 4e-6);
    double modulus = 0.0;
    double contact = 0.0;
    double statedModulus = 0.0;
    double statedContact = 0.0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const PreparedCurve curve = prepareCurve(given.curve(seed), {});
        const ElasticFit fit = fitElastic(curve.approach, curve.stiffness, law, given.contact);
        modulus += std::pow(fit.reducedModulus - given.reducedModulus, 2) / kSeeds;
        contact += std::pow(fit.contact - given.contact, 2) / kSeeds;
        statedModulus += fit.covariance(0, 0) / kSeeds;
        statedContact += fit.covariance(1, 1) / kSeeds;
    }
    EXPECT_NEAR(std::sqrt(statedModulus / modulus), 1.0, 0.25) << memory;
    EXPECT_NEAR(std::sqrt(statedContact / contact), 1.0, 0.25) << memory;
}

TEST(ElasticFit, StatesTheScatterOfItsResults) { expectStatedScatter(0.0); }

TEST(ElasticFit, StatesTheScatterUnderCorrelatedNoise) { expectStatedScatter(0.8); }

TEST(ElasticFit, FitsWithAGivenContact) {
    SyntheticCurve given;
    given.noise = 1e-13;
    const PreparedCurve curve = prepareCurve(given.curve(), {});
    const TipLaw law(given.tip, {}, 4e-6);
    const ElasticFit right = fitElasticAt(curve.approach, curve.stiffness, law, given.contact);
    EXPECT_NEAR(right.reducedModulus, given.reducedModulus, 1e-3 * given.reducedModulus);
    EXPECT_TRUE(right.contactGiven);
    EXPECT_EQ(right.covariance(1, 1), 0.0);
    const ElasticFit late =
        fitElasticAt(curve.approach, curve.stiffness, law, given.contact + 1e-7);
    EXPECT_GT(late.reducedModulus, 1.05 * given.reducedModulus);
}

TEST(ElasticFit, WindowKeepsWhatIsBeforeContact) {
    SyntheticCurve given;
    const PreparedCurve curve = prepareCurve(given.curve(), {});
    const std::vector<double> force = curve.correctedForce(curve.approach);
    const BranchSamples part = windowed(curve.approach, force, {1e-9, 2e-9}, given.contact);
    EXPECT_LT(part.size(), curve.approach.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
        const double above = part.force[i] - curve.baseline.at(part.base[i]);
        EXPECT_TRUE(part.base[i] < given.contact || (above >= 1e-9 && above <= 2e-9)) << i;
    }
}

TEST(ElasticFit, SimulatesFromTheMotionOfTheBase) {
    SyntheticCurve given;
    const MeasuredForceCurve measured = given.curve();
    const PreparedCurve curve = prepareCurve(measured, {});
    const TipLaw law(given.tip, {}, 4e-6);
    const ElasticFit fit{.reducedModulus = given.reducedModulus,
                         .contact = given.contact,
                         .offset = given.offset - (given.tilt * given.contact),
                         .slope = given.tilt};
    const std::vector<double> force = simulatedForce(curve.approach, given.stiffness, law, fit);
    for (std::size_t i = 0; i < force.size(); ++i) {
        EXPECT_NEAR(force[i], measured.segments[0].force[i], 1e-18) << i;
    }
}

TEST(ElasticFit, PrintsItsTime) {
    SyntheticCurve given;
    given.samples = 4000;
    given.noise = 1e-11;
    const PreparedCurve curve = prepareCurve(given.curve(), {});
    const TipLaw law(given.tip, {}, 4e-6);
    constexpr int kRuns = 20;
    double best = 1.0;
    for (int i = 0; i < kRuns; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        const ElasticFit fit = fitElastic(curve.approach, curve.stiffness, law, given.contact);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
        best = std::min(best, spent.count());
        ASSERT_TRUE(fit.converged);
    }
    std::cout << "elastic fit of 4000 samples: " << 1e3 * best << " ms\n";
}

}  // namespace
}  // namespace asperity
