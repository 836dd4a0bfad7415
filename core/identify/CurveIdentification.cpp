#include "core/identify/CurveIdentification.h"

#include "core/FormattedText.h"
#include "core/identify/ContactTests.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

// Fits with another calibration have fewer samples, but not too few of them in contact.
constexpr std::size_t kPerturbedSamples = 200;
constexpr std::size_t kPerturbedContact = 30;

/// Data that the steps of an elastic identification share.
struct ElasticCase {
    const CurveFitOptions& options;
    TipForm tip;
    PreparedCurve curve;
    BranchSamples retract;  ///< without its own offset
    double deviation = 0.0;

    [[nodiscard]] const BranchSamples& fitted() const {
        return options.fitsRetract ? retract : curve.approach;
    }
    [[nodiscard]] const BranchSamples& predicted() const {
        return options.fitsRetract ? curve.approach : retract;
    }
};

/// Tip and law of a curve for which nobody has named a tip: of unit radius, so that the modulus is
/// E* sqrt(R).
constexpr TipForm kUnnamedTip{.kind = TipKind::Paraboloid, .radius = 1.0};

double deviationContact(const PreparedCurve& curve) {
    const std::vector<double> force = curve.correctedForce(curve.approach);
    const double noise = curve.baseline.noise;
    const double range = curve.approach.forceRange();
    if (range < kMinRangeOverNoise * noise) {
        throw CurveRefusal(formatted("the force range is %.1f standard deviations of the noise, "
                                     "and a contact needs at least %.0f",
                                     range / noise, kMinRangeOverNoise));
    }
    const auto contact = contactPoint(ContactMethod::Deviation, curve.approach, force, noise);
    if (!contact) {
        throw CurveRefusal("no contact: the force never leaves its noise on the approach, or has "
                           "left it from the start");
    }
    return *contact;
}

ElasticCase caseOf(const MeasuredForceCurve& measured, const CurveFitOptions& options) {
    ElasticCase result{.options = options,
                       .tip = options.tip.value_or(kUnnamedTip),
                       .curve = prepareCurve(measured, options.preparation),
                       .retract = {}};
    result.retract = result.curve.retract;
    for (double& force : result.retract.force) {
        force -= result.curve.baseline.retractOffset;
    }
    result.deviation = deviationContact(result.curve);
    if (result.fitted().size() < kMinContactSamples) {
        throw CurveRefusal("the branch to fit has fewer than 20 samples");
    }
    return result;
}

TipLaw lawOf(const ElasticCase& elastic, const TipForm& tip) {
    const auto& base = elastic.fitted().base;
    const double deepest = *std::max_element(base.begin(), base.end());
    const SampleFilm film{.thickness = elastic.options.filmThickness,
                          .poissonRatio = elastic.options.poissonRatio};
    return {tip, film, 2.0 * std::max(deepest - elastic.deviation, 1e-12)};
}

double exponentFor(const TipForm& tip) { return exponentOf(tip).value_or(2.0); }

std::optional<double> contactBy(ContactMethod method, const ElasticCase& elastic) {
    const PreparedCurve& curve = elastic.curve;
    return contactPoint(method, curve.approach, curve.correctedForce(curve.approach),
                        curve.baseline.noise, exponentFor(elastic.tip));
}

ElasticFit fitOf(const ElasticCase& elastic, const BranchSamples& branch, double stiffness,
                 const TipLaw& law) {
    const ContactMethod method = elastic.options.contact;
    if (method == ContactMethod::Model) {
        return fitElastic(branch, stiffness, law, elastic.deviation);
    }
    const auto contact = contactBy(method, elastic);
    if (!contact) {
        throw CurveRefusal(std::string("no contact: the method ") + keyOf(method) +
                           " finds none within the data");
    }
    return fitElasticAt(branch, stiffness, law, *contact);
}

BranchSamples samplesToFit(const ElasticCase& elastic) {
    const BranchSamples& branch = elastic.fitted();
    if (!elastic.options.window) {
        return branch;
    }
    std::vector<double> force(branch.size());
    for (std::size_t i = 0; i < force.size(); ++i) {
        force[i] = branch.force[i] - elastic.curve.baseline.at(branch.base[i]);
    }
    return windowed(branch, force, *elastic.options.window, elastic.deviation);
}

BranchSamples everyNth(const BranchSamples& branch, std::size_t step) {
    BranchSamples result;
    for (std::size_t i = 0; i < branch.size(); i += step) {
        result.base.push_back(branch.base[i]);
        result.force.push_back(branch.force[i]);
    }
    return result;
}

/// Effect of the calibration on modulus, relative, and on the contact [m].
struct CalibrationEffect {
    double modulus = 0.0;
    double contact = 0.0;

    void add(double modulusChange, double contactChange) {
        modulus = std::hypot(modulus, modulusChange);
        contact = std::hypot(contact, contactChange);
    }
};

/// Fits few samples again with each calibration one standard deviation off.
/// @param inContact number of samples in contact
CalibrationEffect calibrationEffect(const ElasticCase& elastic, const BranchSamples& samples,
                                    const ElasticFit& fit, std::size_t inContact) {
    const CalibrationDeviations& off = elastic.options.deviations;
    const std::size_t step =
        std::min(samples.size() / kPerturbedSamples, inContact / kPerturbedContact);
    const BranchSamples few = everyNth(samples, std::max<std::size_t>(1, step));
    const double stiffness = elastic.curve.stiffness;
    const ElasticFit own = refitElastic(few, stiffness, lawOf(elastic, elastic.tip), fit);
    CalibrationEffect effect;
    effect.add(off.stiffness, 0.0);  // force and stiffness go together
    const auto compare = [&](const BranchSamples& branch, double k, const TipForm& tip) {
        const ElasticFit other = refitElastic(branch, k, lawOf(elastic, tip), own);
        effect.add((other.reducedModulus / own.reducedModulus) - 1.0, other.contact - own.contact);
    };
    const double gain = 1.0 + off.invols;
    const bool thermal = elastic.options.preparation.lever == LeverRule::Thermal;
    BranchSamples scaled = few;
    for (double& force : scaled.force) {
        force *= thermal ? 1.0 / gain : gain;
    }
    compare(scaled, thermal ? stiffness / (gain * gain) : stiffness, elastic.tip);
    if (elastic.options.tip && hasRadius(elastic.tip.kind)) {
        TipForm tip = elastic.tip;
        tip.radius *= 1.0 + off.tipRadius;
        compare(few, stiffness, tip);
    }
    if (hasAngle(elastic.tip.kind)) {
        TipForm tip = elastic.tip;
        tip.angle += off.tipAngle;
        compare(few, stiffness, tip);
    }
    return effect;
}

void addModulus(const ElasticCase& elastic, const ElasticFit& fit, const CalibrationEffect& effect,
                CurveIdentification& result) {
    const double plane = 1.0 - (elastic.options.poissonRatio * elastic.options.poissonRatio);
    const double star = fit.reducedModulus;
    const double std = std::sqrt(fit.covariance(0, 0));
    const bool named = elastic.options.tip.has_value();
    const std::string unit = named ? "Pa" : "Pa m^0.5";
    result.parameters.push_back(
        {.key = named ? "youngs_modulus_pa" : "youngs_modulus_sqrt_radius_pa_m05",
         .value = star * plane,
         .std = std * plane,
         .stdCalibration = effect.modulus * star * plane,
         .unit = unit});
    result.parameters.push_back({.key = named ? "e_star_pa" : "e_star_sqrt_radius_pa_m05",
                                 .value = star,
                                 .std = std,
                                 .stdCalibration = effect.modulus * star,
                                 .unit = unit});
}

void addGiven(const ElasticCase& elastic, CurveIdentification& result) {
    const CurveFitOptions& options = elastic.options;
    const auto given = [&](const char* key, double value, double std, const char* unit) {
        result.parameters.push_back({.key = key,
                                     .value = value,
                                     .stdCalibration = std,
                                     .unit = unit,
                                     .source = ValueSource::Assumed});
    };
    if (options.tip && hasRadius(elastic.tip.kind)) {
        given("tip_radius_m", elastic.tip.radius, elastic.tip.radius * options.deviations.tipRadius,
              "m");
    }
    if (options.tip && hasAngle(elastic.tip.kind)) {
        given("tip_angle_rad", elastic.tip.angle, options.deviations.tipAngle, "rad");
    }
    if (options.filmThickness > 0.0) {
        given("film_thickness_m", options.filmThickness, 0.0, "m");
    }
    given("poisson_ratio", options.poissonRatio, 0.0, "");
}

void addValues(const ElasticCase& elastic, const ElasticFit& fit, const CalibrationEffect& effect,
               CurveIdentification& result) {
    addModulus(elastic, fit, effect, result);
    result.parameters.push_back(
        {.key = "contact_point_m",
         .value = fit.contact,
         .std = std::sqrt(fit.covariance(1, 1)),
         .stdCalibration = effect.contact,
         .unit = "m",
         .source = fit.contactGiven ? ValueSource::Measured : ValueSource::Fitted});
    result.parameters.push_back({.key = "baseline_force_n",
                                 .value = fit.offset,
                                 .std = std::sqrt(fit.covariance(2, 2)),
                                 .unit = "N"});
    result.parameters.push_back({.key = "baseline_slope_n_m",
                                 .value = fit.slope,
                                 .std = std::sqrt(fit.covariance(3, 3)),
                                 .unit = "N/m"});
    const IdentifiedValue& stiffness = elastic.curve.steps.front().values.front();
    result.parameters.push_back(
        {.key = "stiffness_n_m",
         .value = elastic.curve.stiffness,
         .stdCalibration = elastic.curve.stiffness * elastic.options.deviations.stiffness,
         .unit = "N/m",
         .source = stiffness.source});
    if (elastic.curve.gain != 1.0) {
        result.parameters.push_back({.key = "invols_gain",
                                     .value = elastic.curve.gain,
                                     .unit = "",
                                     .source = ValueSource::Measured});
    }
    addGiven(elastic, result);
    const std::array<const char*, 4> keys{result.parameters[1].key.c_str(), "contact_point_m",
                                          "baseline_force_n", "baseline_slope_n_m"};
    for (Eigen::Index i = 0; i < 4; ++i) {
        for (Eigen::Index j = i + 1; j < 4; ++j) {
            const double size = std::sqrt(fit.covariance(i, i) * fit.covariance(j, j));
            if (size > 0.0) {
                result.correlations.push_back({keys[static_cast<std::size_t>(i)],
                                               keys[static_cast<std::size_t>(j)],
                                               fit.covariance(i, j) / size});
            }
        }
    }
}

ComparedBranch compared(const BranchSamples& branch, double stiffness, const TipLaw& law,
                        const ElasticFit& fit) {
    ComparedBranch result;
    result.measured = branch;
    result.fitted = fittedForce(branch, stiffness, law, fit);
    result.forward = simulatedForce(branch, stiffness, law, fit);
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const double line = fit.baselineAt(branch.base[i]);
        result.corrected.push_back(branch.force[i] - line);
        result.separation.push_back(-fit.indentation(branch.base[i], branch.force[i], stiffness));
        result.fitted[i] -= line;
        result.forward[i] -= line;
    }
    return result;
}

/// Sum of squares of residuals and their number.
struct RestSum {
    double squares = 0.0;
    double count = 0.0;

    void add(double residual) {
        squares += residual * residual;
        count += 1.0;
    }
    [[nodiscard]] double rms() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }
};

struct BranchRests {
    RestSum contact;
    RestSum all;
    RestSum forward;
};

BranchRests restsOf(const ComparedBranch& branch) {
    BranchRests result;
    for (std::size_t i = 0; i < branch.corrected.size(); ++i) {
        const double rest = branch.corrected[i] - branch.fitted[i];
        result.all.add(rest);
        result.forward.add(branch.corrected[i] - branch.forward[i]);
        if (branch.separation[i] < 0.0) {
            result.contact.add(rest);
        }
    }
    return result;
}

RestSum both(const RestSum& one, const RestSum& other) {
    return {one.squares + other.squares, one.count + other.count};
}

void addResiduals(CurveIdentification& result) {
    const BranchRests approach = restsOf(result.approach);
    const BranchRests retract = restsOf(result.retract);
    const auto add = [&](const char* key, const RestSum& sum) {
        result.residuals.push_back({key, sum.rms() / result.forceRange});
    };
    add("rms_approach_contact", approach.contact);
    if (retract.all.count > 0.0) {
        add("rms_retract_contact", retract.contact);
        add("rms_contact", both(approach.contact, retract.contact));
        add("rms_cycle", both(approach.all, retract.all));
        add("rms_cycle_with_jumps", both(approach.all, retract.all));
        add("rms_forward_cycle", both(approach.forward, retract.forward));
    }
    add("rms_approach", approach.all);
    add("rms_forward_approach", approach.forward);
    result.residuals.push_back({"noise", result.noise / result.forceRange});
}

double residualOf(const CurveIdentification& result, const char* key) {
    const auto found = std::find_if(result.residuals.begin(), result.residuals.end(),
                                    [&](const FitNumber& number) { return number.key == key; });
    return found != result.residuals.end() ? found->value : 0.0;
}

/// Verdict by the residuals and by what speaks against the model.
void judge(const CurveFitOptions& options, const std::vector<FitConcern>& found,
           CurveIdentification& result) {
    const bool cycle = options.judgesRetract && !result.retract.corrected.empty();
    const double contact = residualOf(result, cycle ? "rms_contact" : "rms_approach_contact");
    const double all = residualOf(result, cycle ? "rms_forward_cycle" : "rms_forward_approach");
    const bool isDoubtful =
        std::any_of(found.begin(), found.end(), [](const auto& c) { return c.againstModel; });
    result.verdict = verdictOf(contact, all, isDoubtful);
    const char* const what = cycle ? "cycle" : "approach alone, whose fit predicts nothing";
    result.reasons.push_back(formatted("residual of the %s: %.2f %% of the force range in contact, "
                                       "%.2f %% of all samples simulated from the base motion",
                                       what, 100.0 * contact, 100.0 * all));
    for (const FitConcern& concern : found) {
        result.reasons.push_back(concern.text);
    }
}

void addTests(const ElasticCase& elastic, const ContactTests& tests, CurveIdentification& result) {
    const auto expected = exponentOf(elastic.tip);
    result.tests = {{"contact_samples", static_cast<double>(tests.samples)},
                    {"range_over_noise", tests.rangeOverNoise},
                    {"largest_indentation_m", tests.largestIndentation},
                    {"exponent", tests.exponent},
                    {"window_modulus_ratio", tests.windowRatio},
                    {"contact_slope", tests.slope},
                    {"contact_point_share", tests.contactShare}};
    if (expected) {
        result.tests.push_back({"exponent_expected", *expected});
    }
    if (elastic.options.tip && hasRadius(elastic.tip.kind)) {
        result.tests.push_back({"contact_radius_over_tip_radius", tests.radiusRatio});
    }
}

void addContactPoints(const ElasticCase& elastic, const ElasticFit& fit,
                      CurveIdentification& result) {
    for (const ContactMethod method : kValues<ContactMethod>) {
        const auto contact = method == ContactMethod::Model ? std::optional(fit.contact)
                                                            : contactBy(method, elastic);
        if (contact && !(method == ContactMethod::Model && fit.contactGiven)) {
            result.contactPoints.push_back({keyOf(method), *contact});
        }
    }
}

std::vector<FitConcern> concernsOf(const ElasticCase& elastic, const ContactTests& tests) {
    std::vector<FitConcern> found = concerns(tests, elastic.tip, elastic.options.tip.has_value());
    if (!elastic.options.tip) {
        found.push_back({"no tip is named: of the modulus only its product with the root of the "
                         "tip's radius is known, as of a paraboloid",
                         false});
    }
    for (const PreparationStep& step : elastic.curve.steps) {
        if (!step.note.empty()) {
            found.push_back({step.key + ": " + step.note, false});
        }
    }
    return found;
}

void identify(const ElasticCase& elastic, CurveIdentification& result) {
    const double stiffness = elastic.curve.stiffness;
    const BranchSamples samples = samplesToFit(elastic);
    const TipLaw law = lawOf(elastic, elastic.tip);
    const ElasticFit fit = fitOf(elastic, samples, stiffness, law);
    const ContactTests tests =
        contactTests(samples, stiffness, elastic.curve.baseline.noise, law, fit, elastic.deviation);
    addContactPoints(elastic, fit, result);
    addTests(elastic, tests, result);
    if (tests.samples < kMinContactSamples) {
        throw CurveRefusal(formatted("%zu samples in contact, and a fit needs at least %zu",
                                     tests.samples, kMinContactSamples));
    }
    addValues(elastic, fit, calibrationEffect(elastic, samples, fit, tests.samples), result);
    result.forceRange = elastic.curve.forceRange();
    result.approach = compared(elastic.curve.approach, stiffness, law, fit);
    if (elastic.retract.size() > 0) {
        result.retract = compared(elastic.retract, stiffness, law, fit);
    }
    addResiduals(result);
    judge(elastic.options, concernsOf(elastic, tests), result);
}

std::optional<ContactLaw> sceneLaw(const CurveFitOptions& options) {
    if (!options.tip || !hasRadius(options.tip->kind)) {
        return std::nullopt;
    }
    if (options.tip->kind != TipKind::Paraboloid) {
        return ContactLaw::Sneddon;
    }
    return options.filmThickness > 0.0 ? ContactLaw::HertzFilm : ContactLaw::Hertz;
}

}  // namespace

const IdentifiedValue* CurveIdentification::find(const std::string& key) const noexcept {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const IdentifiedValue& v) { return v.key == key; });
    return found != parameters.end() ? &*found : nullptr;
}

FitVerdict verdictOf(double contact, double cycle, bool isDoubtful) noexcept {
    constexpr double kMatched = 0.02;
    constexpr double kPartly = 0.04;
    constexpr double kPartlyContact = 0.06;
    if (contact <= kMatched && cycle <= kMatched && !isDoubtful) {
        return FitVerdict::Matched;
    }
    return contact <= kPartlyContact && cycle <= kPartly ? FitVerdict::Partly
                                                         : FitVerdict::NotMatched;
}

CurveIdentification identifyElastic(const MeasuredForceCurve& curve,
                                    const CurveFitOptions& options) {
    CurveIdentification result;
    result.model = "elastic, ";
    result.model += options.tip ? keyOf(options.tip->kind) : "tip not named";
    result.tip = options.tip;
    result.law = sceneLaw(options);
    result.fitsApproach = !options.fitsRetract;
    result.fitsRetract = options.fitsRetract;
    try {
        const ElasticCase elastic = caseOf(curve, options);
        result.steps = elastic.curve.steps;
        result.noise = elastic.curve.baseline.noise;
        identify(elastic, result);
    } catch (const CurveRefusal& refusal) {
        result.verdict = FitVerdict::Refused;
        result.reasons = {refusal.what()};
    }
    return result;
}

}  // namespace asperity
