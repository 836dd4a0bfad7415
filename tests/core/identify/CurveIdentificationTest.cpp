#include "core/identify/CurveIdentification.h"

#include "core/identify/ContactTests.h"
#include "tests/core/identify/SyntheticCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {
namespace {

using test::SyntheticCurve;

SyntheticCurve noisyCurve() {
    SyntheticCurve curve;
    curve.noise = 1e-11;
    return curve;
}

CurveFitOptions optionsFor(const SyntheticCurve& curve) {
    CurveFitOptions options;
    options.tip = curve.tip;
    return options;
}

bool saysOf(const CurveIdentification& found, const std::string& words) {
    return std::any_of(found.reasons.begin(), found.reasons.end(), [&](const std::string& reason) {
        return reason.find(words) != std::string::npos;
    });
}

double numberOf(const std::vector<FitNumber>& numbers, const std::string& key) {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const FitNumber& number) { return number.key == key; });
    return found != numbers.end() ? found->value : std::nan("");
}

void expectRefused(const MeasuredForceCurve& curve, const std::string& words) {
    const CurveIdentification found = identifyElastic(curve, optionsFor({}));
    EXPECT_EQ(found.verdict, FitVerdict::Refused);
    EXPECT_TRUE(saysOf(found, words)) << found.reasons.front();
    EXPECT_TRUE(found.parameters.empty());
}

TEST(CurveIdentification, MatchesAnElasticCycle) {
    const SyntheticCurve given = noisyCurve();
    const CurveIdentification found = identifyElastic(given.curve(), optionsFor(given));
    EXPECT_EQ(found.verdict, FitVerdict::Matched) << found.reasons.back();
    EXPECT_NEAR(found.find("e_star_pa")->value, given.reducedModulus,
                4.0 * found.find("e_star_pa")->std);
    EXPECT_NEAR(found.find("youngs_modulus_pa")->value, 0.75 * found.find("e_star_pa")->value,
                1e-6);
    EXPECT_LT(numberOf(found.residuals, "rms_forward_cycle"), 0.01);
    EXPECT_NEAR(numberOf(found.tests, "exponent"), 1.5, 0.05);
    EXPECT_NEAR(numberOf(found.tests, "window_modulus_ratio"), 1.0, 0.05);
    EXPECT_EQ(found.approach.fitted.size(), given.samples);
    EXPECT_EQ(found.retract.forward.size(), given.samples);
}

TEST(CurveIdentification, NamesTheDeviationOfTheCalibration) {
    const SyntheticCurve given = noisyCurve();
    CurveFitOptions options = optionsFor(given);
    options.deviations = {.stiffness = 0.1, .invols = 0.0, .tipRadius = 0.0};
    const auto relative = [&](const CurveIdentification& found) {
        const IdentifiedValue& value = *found.find("youngs_modulus_pa");
        return value.stdCalibration / value.value;
    };
    EXPECT_NEAR(relative(identifyElastic(given.curve(), options)), 0.1, 1e-9);
    options.deviations = {.stiffness = 0.0, .invols = 0.0, .tipRadius = 0.1};
    EXPECT_NEAR(relative(identifyElastic(given.curve(), options)), 1.0 - std::sqrt(1.0 / 1.1),
                2e-3);
    options.deviations = {.stiffness = 0.0, .invols = 0.03, .tipRadius = 0.0};
    EXPECT_GT(relative(identifyElastic(given.curve(), options)), 0.03);
}

TEST(CurveIdentification, GivesNoModulusWithoutATip) {
    const SyntheticCurve given = noisyCurve();
    const CurveIdentification found = identifyElastic(given.curve(), {});
    EXPECT_EQ(found.find("youngs_modulus_pa"), nullptr);
    EXPECT_EQ(found.find("e_star_pa"), nullptr);
    EXPECT_NEAR(found.find("e_star_sqrt_radius_pa_m05")->value,
                given.reducedModulus * std::sqrt(given.tip.radius),
                0.05 * given.reducedModulus * std::sqrt(given.tip.radius));
    EXPECT_TRUE(saysOf(found, "no tip is named"));
}

TEST(CurveIdentification, TakesTheContactOfAnotherMethod) {
    const SyntheticCurve given = noisyCurve();
    CurveFitOptions options = optionsFor(given);
    options.contact = ContactMethod::LinePower;
    const CurveIdentification found = identifyElastic(given.curve(), options);
    EXPECT_EQ(found.find("contact_point_m")->source, ValueSource::Measured);
    EXPECT_EQ(found.find("contact_point_m")->value, numberOf(found.contactPoints, "line+power"));
    EXPECT_NEAR(found.find("contact_point_m")->value, given.contact, 1e-7);
}

TEST(CurveIdentification, FilmOnARigidBaseIsSofterThanItSeems) {
    const SyntheticCurve given = noisyCurve();
    CurveFitOptions options = optionsFor(given);
    const double half = identifyElastic(given.curve(), options).find("e_star_pa")->value;
    options.filmThickness = 5e-6;
    const CurveIdentification found = identifyElastic(given.curve(), options);
    EXPECT_LT(found.find("e_star_pa")->value, 0.8 * half);
    EXPECT_EQ(found.find("film_thickness_m")->value, 5e-6);
    options.poissonRatio = 0.3;  // it gives way to the sides
    EXPECT_GT(identifyElastic(given.curve(), options).find("e_star_pa")->value,
              1.1 * found.find("e_star_pa")->value);
}

TEST(ContactTests, SayWhatSpeaksAgainstTheModel) {
    const TipForm tip{.kind = TipKind::Paraboloid, .radius = 1e-6};
    const auto count = [&](const ContactTests& tests, bool isKnown = true) {
        const auto found = concerns(tests, tip, isKnown);
        return std::count_if(found.begin(), found.end(),
                             [](const FitConcern& concern) { return concern.againstModel; });
    };
    EXPECT_EQ(count({.exponent = 1.5}), 0);
    EXPECT_EQ(count({.exponent = 1.75}), 1);
    EXPECT_EQ(count({.exponent = 1.5, .windowRatio = 1.3}), 1);
    EXPECT_EQ(count({.exponent = 1.5, .windowRatio = 0.7}), 1);
    EXPECT_EQ(count({.exponent = 1.5, .slope = 0.95}), 1);
    EXPECT_EQ(count({.exponent = 1.5, .radiusRatio = 0.6}), 1);
    EXPECT_EQ(count({.exponent = 1.5, .radiusRatio = 0.6}, false), 0);
    EXPECT_EQ(count({.exponent = 1.5, .contactShare = 0.2}), 0);
    EXPECT_EQ(concerns({.exponent = 1.5, .contactShare = 0.2}, tip, true).size(), 1U);
    const TipForm area{.kind = TipKind::Area, .area = {{0.0, 0.0}, {1e-8, 1e-15}}};
    EXPECT_EQ(concerns({.largestIndentation = 2e-8}, area, true).size(), 1U);
    EXPECT_TRUE(concerns({.largestIndentation = 5e-9}, area, true).empty());
}

TEST(CurveIdentification, RefusesWithAReason) {
    SyntheticCurve none = noisyCurve();
    none.end = -1e-6;
    none.tilt = 0.0;
    expectRefused(none.curve(), "force range");
    none.tilt = 5e-4;  // as far as the force goes
    expectRefused(none.curve(), "no contact");
    SyntheticCurve few = noisyCurve();
    few.samples = 60;
    few.end = 0.5e-6;
    few.start = -5e-6;
    few.noise = 1e-13;
    expectRefused(few.curve(), "samples in contact");
    MeasuredForceCurve bare = noisyCurve().curve();
    bare.stiffness = 0.0;
    for (CurveSegment& segment : bare.segments) {
        segment.deflection.clear();
    }
    expectRefused(bare, "--stiffness");
}

TEST(CurveIdentification, SteepSlopeIsAReasonAndNoRefusal) {
    SyntheticCurve given = noisyCurve();
    given.reducedModulus = 1e8;
    given.end = 2e-7;
    given.tip.radius = 1e-6;
    const CurveIdentification found = identifyElastic(given.curve(), optionsFor(given));
    EXPECT_NE(found.verdict, FitVerdict::Refused);
    EXPECT_TRUE(saysOf(found, "lower bound"));
}

TEST(CurveIdentification, LooksAtOneBranch) {
    SyntheticCurve given = noisyCurve();
    MeasuredForceCurve curve = given.curve();
    for (double& force : curve.segments[1].force) {
        force -= 1e-9;  // a retract that no elastic sample has, but an offset
    }
    for (std::size_t i = 0; i < 300; ++i) {
        curve.segments[1].force[i] -= 1e-9;
    }
    CurveFitOptions options = optionsFor(given);
    curve.segments[1].deflection.clear();
    curve.segments[0].deflection.clear();
    EXPECT_NE(identifyElastic(curve, options).verdict, FitVerdict::Matched);
    options.judgesRetract = false;
    EXPECT_EQ(identifyElastic(curve, options).verdict, FitVerdict::Matched);
    options.fitsRetract = true;
    EXPECT_NE(identifyElastic(curve, options).find("e_star_pa")->value, given.reducedModulus);
}

}  // namespace
}  // namespace asperity
