#include "core/identify/cycle/CycleIdentification.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/identify/cycle/CycleResiduals.h"
#include "core/identify/cycle/RelaxationFit.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kLoopMargin = 0.25;  ///< of the measured loop energy

/// Data that the fits of one cycle share.
struct CycleCase {
    const CycleFitOptions& options;
    PreparedCurve curve;
    MeasuredCycle cycle;

    /// The tip's radius; 1 m where none is named: then a fit gives products with the radius.
    [[nodiscard]] double tipRadius() const {
        return options.curve.tip ? options.curve.tip->radius : 1.0;
    }
    [[nodiscard]] bool isSphere() const {
        return options.curve.tip && options.curve.tip->kind == TipKind::Sphere;
    }
    [[nodiscard]] double plane() const {
        return 1.0 - (options.curve.poissonRatio * options.curve.poissonRatio);
    }
};

void requireRoundTip(const CycleFitOptions& options) {
    const auto& tip = options.curve.tip;
    if (tip && tip->kind != TipKind::Sphere && tip->kind != TipKind::Paraboloid) {
        throw Error("adhesion, relaxation and drag need --tip sphere:R or paraboloid:R; cones, "
                    "pyramids and area functions are elastic");
    }
    if (options.curve.filmThickness > 0.0) {
        throw Error("a film goes with the elastic law alone");
    }
    if (options.curve.contact != ContactMethod::Model || options.curve.window) {
        throw Error("--contact and --range go with the elastic law alone");
    }
}

void requireTogether(const CycleFitOptions& options) {
    requireRoundTip(options);
    const bool timed = options.relaxation || options.drag;
    if (timed && options.law != SampleLaw::Elastic) {
        throw Error("relaxation and drag go with --law elastic");
    }
    if (timed && !options.curve.tip) {
        throw Error("relaxation and drag need the tip: --tip sphere:R or paraboloid:R");
    }
    if (options.twoWorks && options.law != SampleLaw::Jkr && options.law != SampleLaw::Automatic) {
        throw Error("two works of adhesion need --law jkr or auto");
    }
}

/// Prepares a curve whose gain is a parameter of the fit. @throw CurveRefusal
CycleCase cycleCase(const MeasuredForceCurve& measured, const CycleFitOptions& options) {
    PreparationOptions steps = options.curve.preparation;
    steps.lever = LeverRule::AsInFile;
    CycleCase result{options, prepareCurve(measured, steps), {}};
    const PreparedCurve& curve = result.curve;
    const double range = curve.forceRange();
    if (range < kMinRangeOverNoise * curve.baseline.noise) {
        throw CurveRefusal(formatted("the force range is %.1f standard deviations of the noise, "
                                     "and a contact needs at least %.0f",
                                     range / curve.baseline.noise, kMinRangeOverNoise));
    }
    if (curve.retract.size() < kMinContactSamples) {
        throw CurveRefusal("the curve has no retract of at least 20 samples");
    }
    result.cycle = measuredCycle(curve);
    const CycleEvents events = cycleEvents(result.cycle);
    const std::size_t inContact =
        (result.cycle.approach.size() - events.contactBegin) + events.contactEnd;
    if (inContact < kMinContactSamples) {
        throw CurveRefusal(formatted("%zu samples in contact, and a fit needs at least %zu",
                                     inContact, kMinContactSamples));
    }
    return result;
}

std::optional<ContactLaw> lawOf(const CycleCase& given) {
    const bool sphere = given.isSphere();
    switch (given.options.law) {
    case SampleLaw::Dmt:
        return ContactLaw::Dmt;
    case SampleLaw::Jkr:
        return sphere ? ContactLaw::SphereJkr : ContactLaw::Jkr;
    case SampleLaw::Maugis:
        return sphere ? ContactLaw::SphereMaugis : ContactLaw::Maugis;
    default:
        return std::nullopt;
    }
}

AdhesiveFitOptions adhesiveOptions(const CycleCase& given) {
    const LeverRule lever = given.options.curve.preparation.lever;
    AdhesiveFitOptions options;
    options.law = lawOf(given);
    options.sphere = given.isSphere();
    options.tipRadius = given.tipRadius();
    options.twoWorks = given.options.twoWorks;
    options.freeGain = lever != LeverRule::AsInFile;
    options.calibration =
        lever == LeverRule::Fixed ? SpringCalibration::Fixed : SpringCalibration::Thermal;
    options.branch = given.options.branch;
    return options;
}

void addResidualsOf(const CycleResiduals& rms, std::vector<FitNumber>& residuals) {
    residuals = {{"rms_approach_contact", rms.approachContact},
                 {"rms_retract_contact", rms.retractContact},
                 {"rms_contact", rms.contact},
                 {"rms_cycle", rms.cycle},
                 {"rms_cycle_with_jumps", rms.cycleWithJumps},
                 {"rms_forward_cycle", rms.forwardCycle},
                 {"noise", rms.noise}};
}

/// Without a named tip a modulus is known times the root of the radius, an adhesion times the
/// radius.
IdentifiedValue withoutRadius(IdentifiedValue value) {
    const auto rename = [&](const char* key, const char* name, const char* unit) {
        if (value.key == key) {
            value.key = name;
            value.unit = unit;
        }
    };
    rename("youngs_modulus_pa", "youngs_modulus_sqrt_radius_pa_m05", "Pa m^0.5");
    rename("e_star_pa", "e_star_sqrt_radius_pa_m05", "Pa m^0.5");
    rename("work_of_adhesion_j_m2", "work_of_adhesion_radius_n", "N");
    rename("work_of_adhesion_approach_j_m2", "work_of_adhesion_approach_radius_n", "N");
    return value;
}

/// Relative standard deviation of the product of two parameters of which the fit changes the
/// logarithms.
double productStd(const BoundedFit& fit, std::size_t one, std::size_t other) {
    const auto i = static_cast<Eigen::Index>(one);
    const auto j = static_cast<Eigen::Index>(other);
    const auto& c = fit.fit.covariance;
    return std::sqrt(std::max(0.0, c(i, i) + c(j, j) + (2.0 * c(i, j))));
}

/// The work of adhesion on retract, where it was fitted as a ratio to that on approach.
std::optional<IdentifiedValue> retractWork(const AdhesiveFit& fit) {
    const auto& free = fit.bounded.parameters;
    const auto indexOf = [&](const char* key) {
        return static_cast<std::size_t>(
            std::find_if(free.begin(), free.end(), [&](const auto& p) { return p.key == key; }) -
            free.begin());
    };
    const std::size_t ratio = indexOf("work_of_adhesion_ratio");
    if (ratio == free.size()) {
        return std::nullopt;
    }
    const std::size_t approach = indexOf("work_of_adhesion_approach_j_m2");
    return IdentifiedValue{.key = "work_of_adhesion_j_m2",
                           .value = fit.parameters.retractWork,
                           .std = fit.parameters.retractWork *
                                  productStd(fit.bounded, approach, ratio),
                           .unit = "J/m^2"};
}

/// Adds E beside E*, the lever and what was given.
void addDerived(const CycleCase& given, double stiffness, std::vector<IdentifiedValue>& values) {
    const auto star = std::find_if(values.begin(), values.end(),
                                   [](const auto& v) { return v.key == "e_star_pa"; });
    if (star != values.end()) {
        IdentifiedValue modulus = *star;
        modulus.key = "youngs_modulus_pa";
        modulus.value *= given.plane();
        modulus.std *= given.plane();
        modulus.stdCalibration *= given.plane();
        values.insert(values.begin(), modulus);
    }
    const CurveFitOptions& options = given.options.curve;
    const auto gain = std::find_if(values.begin(), values.end(),
                                   [](const auto& v) { return v.key == "invols_gain"; });
    // By a thermal calibration it goes as the gain's -2nd power, and is as uncertain.
    const bool isFitted = gain != values.end() && stiffness != given.cycle.stiffness;
    values.push_back({.key = "stiffness_n_m",
                      .value = stiffness,
                      .std = isFitted ? 2.0 * stiffness * gain->std / gain->value : 0.0,
                      .stdCalibration = stiffness * options.deviations.stiffness,
                      .unit = "N/m",
                      .source = isFitted ? ValueSource::Fitted
                                         : given.curve.steps.front().values.front().source});
    if (options.tip) {
        values.push_back({.key = "tip_radius_m",
                          .value = options.tip->radius,
                          .stdCalibration = options.tip->radius * options.deviations.tipRadius,
                          .unit = "m",
                          .source = ValueSource::Assumed});
    } else {
        std::transform(values.begin(), values.end(), values.begin(), withoutRadius);
    }
    values.push_back({.key = "poisson_ratio",
                      .value = options.poissonRatio,
                      .unit = "",
                      .source = ValueSource::Assumed});
}

/// Fits again with each calibration one deviation off, and adds the changes in quadrature.
/// @param fitWith (cycle, tip radius) -> values in the order of `values`
template <class FitWith>
void addCalibration(const CycleCase& given, const FitWith& fitWith,
                    std::vector<IdentifiedValue>& values) {
    const CalibrationDeviations& off = given.options.curve.deviations;
    const auto add = [&](const std::vector<double>& other) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i].stdCalibration =
                std::hypot(values[i].stdCalibration, other[i] - values[i].value);
        }
    };
    MeasuredCycle steeper = given.cycle;
    for (CycleBranch* branch : {&steeper.approach, &steeper.dwell, &steeper.retract}) {
        for (double& force : branch->force) {
            force *= 1.0 + off.invols;
        }
    }
    add(fitWith(steeper, given.tipRadius()));
    if (given.options.curve.tip) {
        add(fitWith(given.cycle, given.tipRadius() * (1.0 + off.tipRadius)));
    }
    for (IdentifiedValue& value : values) {
        // Forces and what is in proportion to them go with the spring constant.
        const bool isForce = value.unit == "Pa" || value.unit == "J/m^2" || value.unit == "N s";
        value.stdCalibration =
            std::hypot(value.stdCalibration, isForce ? off.stiffness * value.value : 0.0);
    }
}

std::vector<IdentifiedValue> valuesOf(const AdhesiveFit& fit) {
    std::vector<IdentifiedValue> values = fit.bounded.identified();
    if (const auto work = retractWork(fit)) {
        values.push_back(*work);
    }
    return values;
}

std::vector<double> numbersOf(const std::vector<IdentifiedValue>& values) {
    std::vector<double> numbers;
    std::transform(values.begin(), values.end(), std::back_inserter(numbers),
                   [](const IdentifiedValue& value) { return value.value; });
    return numbers;
}

std::vector<IdentifiedValue> adhesiveValues(const CycleCase& given, const AdhesiveFit& fit,
                                            const AdhesiveFitOptions& options) {
    std::vector<IdentifiedValue> values = valuesOf(fit);
    AdhesiveFitOptions again = options;
    again.law = fit.parameters.law;
    addCalibration(
        given,
        [&](const MeasuredCycle& cycle, double radius) {
            again.tipRadius = radius;
            return numbersOf(valuesOf(adhesiveFit(cycle, again)));
        },
        values);
    if (options.fixedModulus) {
        values.push_back({.key = "e_star_pa",
                          .value = *options.fixedModulus,
                          .unit = "Pa",
                          .source = ValueSource::Assumed});
    }
    addDerived(given, fit.parameters.lever.trueStiffness(), values);
    return values;
}

/// The figures in forces of another calibration. @param factor of the forces
CycleFigures scaled(CycleFigures figures, double factor) {
    if (figures.snapInForce) {
        *figures.snapInForce *= factor;
    }
    for (double CycleFigures::*each : {&CycleFigures::lowestForce, &CycleFigures::approachSlope,
                                       &CycleFigures::retractSlope, &CycleFigures::loopEnergy}) {
        figures.*each *= factor;
    }
    return figures;
}

void addFigures(const CycleFigures& measured, const CycleFigures& found,
                std::vector<FitNumber>& tests) {
    const auto both = [&](const std::string& key, const std::optional<double>& one,
                          const std::optional<double>& other) {
        if (one) {
            tests.push_back({key, *one});
        }
        if (other) {
            tests.push_back({key + "_simulated", *other});
        }
    };
    both("snap_in_base_m", measured.snapInBase, found.snapInBase);
    both("snap_in_force_n", measured.snapInForce, found.snapInForce);
    both("pull_off_base_m", measured.pullOffBase, found.pullOffBase);
    both("lowest_force_n", measured.lowestForce, found.lowestForce);
    both("approach_slope_n_m", measured.approachSlope, found.approachSlope);
    both("retract_slope_n_m", measured.retractSlope, found.retractSlope);
    both("loop_energy_j", measured.loopEnergy, found.loopEnergy);
}

/// A branch beside its simulation, in forces of the corrected calibration.
/// @param factor of the file's forces
ComparedBranch comparedBranch(const BranchSamples& samples, const CycleBranch& corrected,
                              const std::vector<double>& fitted, const std::vector<double>& forward,
                              double factor, double contact, double stiffness) {
    ComparedBranch result;
    result.measured = samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double force = factor * corrected.force[i];
        result.measured.force[i] *= factor;
        result.corrected.push_back(force);
        result.separation.push_back(contact - samples.base[i] + (force / stiffness));
        result.fitted.push_back(factor * fitted[i]);
        result.forward.push_back(factor * forward[i]);
    }
    return result;
}

void addBranches(const CycleCase& given, const SimulatedCycle& forces, double factor,
                 double contact, double stiffness, CurveIdentification& result) {
    result.approach = comparedBranch(given.curve.approach, given.cycle.approach, forces.approach,
                                     forces.approach, factor, contact, stiffness);
    result.retract = comparedBranch(given.curve.retract, given.cycle.retract, forces.retract,
                                    forces.retract, factor, contact, stiffness);
    result.forceRange = factor * given.cycle.forceRange();
    result.noise = factor * given.cycle.noise;
}

/// Sentences on parameters that the data do not determine or tell apart.
void addDoubts(const BoundedFit& fit, CurveIdentification& result) {
    for (const std::string& key : fit.notIdentified()) {
        result.reasons.push_back(key + " is not identified: it is at a bound, or smaller than its "
                                       "deviation");
    }
    for (const CorrelatedPair& pair : fit.correlated()) {
        result.reasons.push_back(formatted("the curve cannot tell %s and %s apart: their "
                                           "correlation is %.3f",
                                           pair.first.c_str(), pair.second.c_str(),
                                           pair.correlation));
    }
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        for (std::size_t j = i + 1; j < fit.parameters.size(); ++j) {
            result.correlations.push_back(
                {fit.parameters[i].key, fit.parameters[j].key,
                 fit.fit.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))});
        }
    }
}

/// @param isDoubtful a term of the model is not seen in the curve
void judgeCycle(const CycleResiduals& rms, const CycleFigures& measured, const CycleFigures& found,
                bool isDoubtful, CurveIdentification& result) {
    const double loop = std::abs((found.loopEnergy / measured.loopEnergy) - 1.0);
    const bool loopAgrees = loop <= kLoopMargin;
    result.verdict =
        verdictOf(rms.contact, std::max(rms.cycle, rms.forwardCycle), isDoubtful || !loopAgrees);
    result.reasons.push_back(formatted(
        "residual: %.2f %% of the force range in contact, %.2f %% of the cycle without the jumps, "
        "%.2f %% with them, %.2f %% simulated from the base motion",
        100.0 * rms.contact, 100.0 * rms.cycle, 100.0 * rms.cycleWithJumps,
        100.0 * rms.forwardCycle));
    if (!loopAgrees) {
        result.reasons.push_back(formatted("the energy of the loop is %.3g J, simulated %.3g J",
                                           measured.loopEnergy, found.loopEnergy));
    }
    result.reasons.push_back(formatted("lowest force %.4g nN, simulated %.4g nN",
                                       1e9 * measured.lowestForce, 1e9 * found.lowestForce));
}

/// One adhesive fit with its simulation.
struct AdhesiveRun {
    std::string key;
    AdhesiveFitOptions options;
    AdhesiveFit fit;
    SimulatedCycle forces;
    CycleResiduals rms;
};

AdhesiveRun runAdhesive(const CycleCase& given, const std::string& key,
                        const AdhesiveFitOptions& options) {
    AdhesiveRun run{.key = key, .options = options, .fit = adhesiveFit(given.cycle, options)};
    run.forces = simulated(AdhesiveCycle(run.fit.parameters), given.cycle);
    run.rms = cycleResiduals(given.cycle, run.fit.events, run.forces, run.forces);
    return run;
}

/// The fits that are asked for, the main one last.
std::vector<AdhesiveRun> adhesiveRuns(const CycleCase& given) {
    const AdhesiveFitOptions main = adhesiveOptions(given);
    std::vector<AdhesiveRun> runs;
    if (main.freeGain && given.options.law == SampleLaw::Maugis) {
        AdhesiveFitOptions rigid = main;
        rigid.fixedModulus = kRigidModulus;
        runs.push_back(runAdhesive(given, "rigid", rigid));
        runs.push_back(runAdhesive(given, "elastic", main));
    } else if (main.twoWorks) {
        AdhesiveFitOptions one = main;
        one.twoWorks = false;
        runs.push_back(runAdhesive(given, "one", one));
        runs.push_back(runAdhesive(given, "two", main));
    } else {
        runs.push_back(runAdhesive(given, "one", main));
    }
    return runs;
}

void identifyAdhesive(const CycleCase& given, CurveIdentification& result) {
    for (const AdhesiveRun& run : adhesiveRuns(given)) {
        FitVariant variant{.key = run.key,
                           .parameters = adhesiveValues(given, run.fit, run.options),
                           .residuals = {}};
        addResidualsOf(run.rms, variant.residuals);
        result.variants.push_back(std::move(variant));
        if (run.key != "rigid" && !(given.options.twoWorks && run.key == "one")) {
            const AdhesiveParameters& found = run.fit.parameters;
            const double factor = 1.0 / found.lever.forceFactor();
            result.model = std::string(nameOf(found.law)) + ", " + run.key;
            result.law = found.law;
            result.parameters = result.variants.back().parameters;
            addResidualsOf(run.rms, result.residuals);
            addBranches(given, run.forces, factor, found.contactPoint, found.lever.trueStiffness(),
                        result);
            const CycleFigures measured = scaled(cycleFigures(given.cycle, run.fit.events), factor);
            const CycleFigures simulation = scaled(
                simulatedFigures(given.cycle, run.fit.events, AdhesiveCycle(found), run.forces),
                factor);
            addFigures(measured, simulation, result.tests);
            judgeCycle(run.rms, measured, simulation, false, result);
            addDoubts(run.fit.bounded, result);
        }
    }
}

void identifyRelaxing(const CycleCase& given, CurveIdentification& result) {
    RelaxationFitOptions options;
    options.tipRadius = given.tipRadius();
    options.sphere = given.isSphere();
    options.poissonRatio = given.options.curve.poissonRatio;
    options.relaxation = given.options.relaxation;
    options.drag = given.options.drag;
    options.branch = given.options.branch;
    const RelaxationFit fit = relaxationFit(given.cycle, options);
    result.model = std::string("elastic") + (options.relaxation ? ", relaxation" : "") +
                   (options.drag ? ", wall drag" : "");
    result.law = options.sphere ? ContactLaw::Sneddon : ContactLaw::Hertz;
    result.parameters = fit.bounded.identified();
    addCalibration(
        given,
        [&](const MeasuredCycle& cycle, double radius) {
            RelaxationFitOptions again = options;
            again.tipRadius = radius;
            return numbersOf(relaxationFit(cycle, again).bounded.identified());
        },
        result.parameters);
    addDerived(given, given.cycle.stiffness, result.parameters);
    addResidualsOf(fit.residuals, result.residuals);
    addBranches(given, simulated(fit, given.cycle), 1.0, fit.parameters.contactPoint,
                given.cycle.stiffness, result);
    addFigures(fit.measured, fit.simulated, result.tests);
    judgeCycle(fit.residuals, fit.measured, fit.simulated, !fit.bounded.notIdentified().empty(),
               result);
    addDoubts(fit.bounded, result);
}

CycleBranch withoutBaseline(const BranchSamples& branch, const CurveBaseline& line, double offset) {
    CycleBranch result{branch.time, branch.base, branch.force};
    for (std::size_t i = 0; i < branch.size(); ++i) {
        result.force[i] -= line.at(branch.base[i]) + offset;
    }
    return result;
}

CurveIdentification identifyCycle(const MeasuredForceCurve& curve, const CycleFitOptions& options) {
    CurveIdentification result;
    result.model = nameOf(options.law);
    result.tip = options.curve.tip;
    try {
        const CycleCase given = cycleCase(curve, options);
        result.steps = given.curve.steps;
        options.law == SampleLaw::Elastic ? identifyRelaxing(given, result)
                                          : identifyAdhesive(given, result);
        if (!options.curve.tip) {
            result.reasons.emplace_back("no tip is named: modulus and adhesion are known times the "
                                        "root of the tip's radius and times the radius alone");
        }
    } catch (const Error& error) {  // no contact, no times
        result = {};
        result.model = nameOf(options.law);
        result.reasons = {error.what()};
    }
    return result;
}

/// Adds the strongest pull of the retract, as measured.
void addPullOff(const CalibrationDeviations& off, CurveIdentification& result) {
    const std::vector<double>& force = result.retract.corrected;
    if (result.verdict == FitVerdict::Refused || force.empty()) {
        return;
    }
    const double pull = std::max(0.0, -*std::min_element(force.begin(), force.end()));
    result.parameters.push_back({.key = "pull_off_force_n",
                                 .value = pull,
                                 .std = result.noise,
                                 .stdCalibration = pull * std::hypot(off.stiffness, off.invols),
                                 .unit = "N",
                                 .source = ValueSource::Measured});
}

}  // namespace

MeasuredCycle measuredCycle(const PreparedCurve& curve) {
    const CurveBaseline& line = curve.baseline;
    MeasuredCycle cycle;
    cycle.approach = withoutBaseline(curve.approach, line, 0.0);
    cycle.dwell = withoutBaseline(curve.dwell, line, 0.0);
    cycle.retract = withoutBaseline(curve.retract, line, line.retractOffset);
    cycle.stiffness = curve.stiffness;
    cycle.noise = line.noise;
    return cycle;
}

CurveIdentification identifyCurve(const MeasuredForceCurve& curve, const CycleFitOptions& options) {
    if (!options.isPlain()) {
        requireTogether(options);
        CurveIdentification result = identifyCycle(curve, options);
        addPullOff(options.curve.deviations, result);
        result.fitsApproach = options.branch != FittedBranch::Retract;
        result.fitsRetract = options.branch != FittedBranch::Approach;
        return result;
    }
    CurveFitOptions elastic = options.curve;
    elastic.fitsRetract = options.branch == FittedBranch::Retract;
    elastic.judgesRetract = options.branch != FittedBranch::Approach;
    CurveIdentification result = identifyElastic(curve, elastic);
    addPullOff(options.curve.deviations, result);
    return result;
}

ModelComparison compareCurve(const MeasuredForceCurve& curve, const CycleFitOptions& options) {
    requireRoundTip(options);
    if (!options.curve.tip) {
        throw Error("a comparison of models needs the tip: --tip sphere:R or paraboloid:R");
    }
    try {
        const CycleCase given = cycleCase(curve, options);
        return compareModels(given.cycle, {.tipRadius = given.tipRadius(),
                                           .sphere = given.isSphere(),
                                           .poissonRatio = options.curve.poissonRatio});
    } catch (const Error& error) {  // no contact
        ModelComparison nothing;
        nothing.reasons = {error.what()};
        return nothing;
    }
}

}  // namespace asperity
