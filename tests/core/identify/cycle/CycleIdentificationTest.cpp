#include "core/identify/cycle/CycleIdentification.h"

#include "core/Error.h"
#include "core/io/curves/ForceCurveFile.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {
namespace {

double cycleNumberOf(const std::vector<FitNumber>& numbers, const std::string& key) {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const FitNumber& number) { return number.key == key; });
    return found != numbers.end() ? found->value : std::nan("");
}

double valueOf(const std::vector<IdentifiedValue>& values, const std::string& key) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const IdentifiedValue& value) { return value.key == key; });
    return found != values.end() ? found->value : std::nan("");
}

MeasuredForceCurve sharedCurve(const std::string& file, std::size_t index = 0) {
    return readForceCurve(test::sharedData("curves/original/" + file), index);
}

CycleFitOptions paraboloid(double radius) {
    CycleFitOptions options;
    options.curve.tip = TipForm{.kind = TipKind::Paraboloid, .radius = radius};
    return options;
}

CycleFitOptions siliconNitride() {
    CycleFitOptions options = paraboloid(10e-9);
    options.curve.poissonRatio = 0.27;
    options.curve.preparation.lever = LeverRule::Thermal;
    options.law = SampleLaw::Maugis;
    return options;
}

constexpr const char* kNitride = "fmt-igor-fd_SiN_FD_plot.ibw";
constexpr const char* kTissue = "fmt-jpk-fd_map-data-reference-points.jpk-force-map";

TEST(CycleIdentification, NitrideInAirIsMatchedRigidAndElastic) {
    ASPERITY_NEEDS_SHARED_DATA();
    const CurveIdentification found = identifyCurve(sharedCurve(kNitride), siliconNitride());
    EXPECT_EQ(found.verdict, FitVerdict::Matched);
    ASSERT_EQ(found.variants.size(), 2U);
    for (const FitVariant& variant : found.variants) {
        EXPECT_LE(cycleNumberOf(variant.residuals, "rms_approach_contact"), 0.012) << variant.key;
        EXPECT_LE(cycleNumberOf(variant.residuals, "rms_retract_contact"), 0.012) << variant.key;
        EXPECT_LE(cycleNumberOf(variant.residuals, "rms_cycle"), 0.005) << variant.key;
        EXPECT_LE(cycleNumberOf(variant.residuals, "rms_cycle_with_jumps"), 0.04) << variant.key;
    }
    const auto& rigid = found.variants[0].parameters;
    const auto& elastic = found.variants[1].parameters;
    EXPECT_NEAR(valueOf(rigid, "invols_gain") / 2.1822, 1.0, 0.03);
    EXPECT_NEAR(valueOf(rigid, "stiffness_n_m") / 0.24866, 1.0, 0.03);
    EXPECT_NEAR(valueOf(rigid, "work_of_adhesion_j_m2") / 0.094251, 1.0, 0.03);
    EXPECT_NEAR(valueOf(elastic, "invols_gain") / 1.9354, 1.0, 0.03);
    EXPECT_NEAR(valueOf(elastic, "stiffness_n_m") / 0.31611, 1.0, 0.03);
    EXPECT_NEAR(valueOf(elastic, "work_of_adhesion_j_m2") / 0.11844, 1.0, 0.03);
    EXPECT_NEAR(valueOf(elastic, "e_star_pa") / 2.5163e8, 1.0, 0.3);
    EXPECT_NEAR(valueOf(elastic, "cohesive_range_m") / 4.136e-9, 1.0, 0.2);
    const auto relativeOf = [&elastic](const char* key) {
        const auto value = std::ranges::find(elastic, key, &IdentifiedValue::key);
        return value->std / value->value;
    };
    EXPECT_GT(relativeOf("invols_gain"), 0.01);
    EXPECT_NEAR(relativeOf("stiffness_n_m"), 2.0 * relativeOf("invols_gain"), 1e-9)
        << "as sure as the gain that it follows from";
}

TEST(CycleIdentification, RetractPredictsTheApproach) {
    ASPERITY_NEEDS_SHARED_DATA();
    CycleFitOptions options = siliconNitride();
    options.branch = FittedBranch::Retract;
    for (const FitVariant& variant : identifyCurve(sharedCurve(kNitride), options).variants) {
        EXPECT_LE(cycleNumberOf(variant.residuals, "rms_approach_contact"), 0.015) << variant.key;
    }
}

TEST(CycleIdentification, TissueInLiquidRelaxesUnderDrag) {
    ASPERITY_NEEDS_SHARED_DATA();
    CycleFitOptions options = paraboloid(18.64e-6);
    options.relaxation = true;
    options.drag = true;
    const CurveIdentification found = identifyCurve(sharedCurve(kTissue), options);
    EXPECT_EQ(found.verdict, FitVerdict::Matched);
    EXPECT_LE(cycleNumberOf(found.residuals, "rms_cycle"), 0.010);
    EXPECT_LE(cycleNumberOf(found.residuals, "rms_forward_cycle"), 0.010);
    EXPECT_NEAR(valueOf(found.parameters, "long_term_modulus_pa") / 57.134, 1.0, 0.15);
    CycleFitOptions jkr = paraboloid(18.64e-6);
    jkr.law = SampleLaw::Jkr;
    const CurveIdentification other = identifyCurve(sharedCurve(kTissue), jkr);
    EXPECT_EQ(other.verdict, FitVerdict::NotMatched);
    EXPECT_GT(cycleNumberOf(other.residuals, "rms_cycle"),
              5.0 * cycleNumberOf(found.residuals, "rms_forward_cycle"));
}

TEST(CycleIdentification, SaysWhatDoesNotMatch) {
    ASPERITY_NEEDS_SHARED_DATA();
    CycleFitOptions options = paraboloid(18.64e-6);
    options.relaxation = true;
    options.drag = true;
    EXPECT_EQ(identifyCurve(sharedCurve(kTissue, 1), options).verdict, FitVerdict::NotMatched);
    options.curve.tip->radius = 27.5e-6;
    EXPECT_EQ(
        identifyCurve(sharedCurve("fmt-chiaro-txt_AEBP1_Indentation_002.zip"), options).verdict,
        FitVerdict::NotMatched);
}

TEST(CycleIdentification, RefusesTheThreeBadFiles) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const char* file :
         {"fmt-afm-workshop-fd_single_2021-01-15.csv", "fmt-jpk-fd_single-modified_2023.jpk-force",
          "fmt-jpk-cl_calibration_force-save-2015.02.04-11.25.21.294.jpk-force"}) {
        const MeasuredForceCurve curve = sharedCurve(file);
        CycleFitOptions options = paraboloid(5e-6);
        EXPECT_EQ(identifyCurve(curve, options).verdict, FitVerdict::Refused) << file;
        options.curve.preparation.stiffness = 0.1;
        options.curve.preparation.invols = 50e-9;
        EXPECT_EQ(identifyCurve(curve, options).verdict, FitVerdict::Refused) << file;
    }
}

TEST(CycleIdentification, WithoutATipOnlyProductsAreKnown) {
    ASPERITY_NEEDS_SHARED_DATA();
    CycleFitOptions options = siliconNitride();
    const CurveIdentification named = identifyCurve(sharedCurve(kNitride), options);
    options.curve.tip.reset();
    const CurveIdentification unnamed = identifyCurve(sharedCurve(kNitride), options);
    EXPECT_EQ(unnamed.find("e_star_pa"), nullptr);
    EXPECT_EQ(unnamed.find("work_of_adhesion_j_m2"), nullptr);
    EXPECT_NEAR(unnamed.find("work_of_adhesion_radius_n")->value /
                    (named.find("work_of_adhesion_j_m2")->value * 10e-9),
                1.0, 0.05);
}

TEST(CycleIdentification, RefusesWhatDoesNotGoTogether) {
    const MeasuredForceCurve curve;
    CycleFitOptions options = paraboloid(1e-6);
    options.law = SampleLaw::Jkr;
    options.drag = true;
    EXPECT_THROW((void)identifyCurve(curve, options), Error);
    options = paraboloid(1e-6);
    options.law = SampleLaw::Maugis;
    options.twoWorks = true;
    EXPECT_THROW((void)identifyCurve(curve, options), Error);
    options = {};
    options.relaxation = true;
    EXPECT_THROW((void)identifyCurve(curve, options), Error);
    options.curve.tip = TipForm{.kind = TipKind::Cone, .angle = 0.4};
    EXPECT_THROW((void)identifyCurve(curve, options), Error);
}

}  // namespace
}  // namespace asperity
