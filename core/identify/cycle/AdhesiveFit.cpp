#include "core/identify/cycle/AdhesiveFit.h"

#include "core/Error.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/identify/cycle/MeasuredCycle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

using Eigen::Index;
using std::numbers::pi;

/// Samples of a branch at most: more of them only cost time.
constexpr std::size_t kBins = 500;

/// One fit with a given law.
class AdhesiveProblem {
public:
    AdhesiveProblem(const MeasuredCycle& cycle, const AdhesiveFitOptions& options, ContactLaw law)
        : options_(options)
        , law_(law)
        , events_(cycleEvents(cycle))
        , approach_(binned(cycle.approach, events_.contactBegin, cycle.approach.size(), kBins))
        , retract_(binned(cycle.retract, 0, events_.contactEnd, kBins))
        , range_(cycle.forceRange())
        , stiffness_(cycle.stiffness)
        , slope_(contactSlope(options.branch == FittedBranch::Retract ? retract_ : approach_)) {
        if (events_.pullOff) {
            pullOffBase_ = cycle.retract.base[events_.pullOff->before];
        }
    }

    [[nodiscard]] AdhesiveFit solve();

private:
    [[nodiscard]] bool sees(FittedBranch branch) const {
        return options_.branch == FittedBranch::Both || options_.branch == branch;
    }
    [[nodiscard]] bool isElastic() const { return !isAdhesive(law_); }
    [[nodiscard]] bool hasRange() const { return traitsOf(law_).attraction == Attraction::Zone; }
    [[nodiscard]] bool hasGain() const { return options_.freeGain; }
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] AdhesiveParameters first(double gain) const;
    [[nodiscard]] AdhesiveParameters placed(AdhesiveParameters parameters) const;
    [[nodiscard]] AdhesiveParameters start() const;
    [[nodiscard]] double squares(const AdhesiveParameters& parameters) const;
    [[nodiscard]] std::vector<FreeParameter> freeParameters(const AdhesiveParameters& start) const;
    [[nodiscard]] AdhesiveParameters with(AdhesiveParameters parameters,
                                          const std::vector<double>& values) const;
    void residuals(const AdhesiveParameters& parameters, Eigen::VectorXd& out) const;
    void addEvents(const AdhesiveCycle& model, Eigen::VectorXd& out, Index at) const;

    const AdhesiveFitOptions& options_;
    ContactLaw law_;
    CycleEvents events_;
    CycleBranch approach_;
    CycleBranch retract_;
    double range_;                       ///< of the force [N]
    double stiffness_;                   ///< of the lever by the file [N/m]
    double slope_;                       ///< of the force over the base in contact [N/m]
    std::optional<double> pullOffBase_;  ///< [m]
};

constexpr int kEvents = 3;

std::size_t AdhesiveProblem::count() const {
    return (sees(FittedBranch::Approach) ? approach_.size() : 0) +
           (sees(FittedBranch::Retract) ? retract_.size() : 0) + kEvents;
}

/// The retract follows the approach whether that is seen or not: a held contact comes from it.
void AdhesiveProblem::residuals(const AdhesiveParameters& parameters, Eigen::VectorXd& out) const {
    if (!isWithinLaw(parameters)) {
        out.setConstant(std::numeric_limits<double>::infinity());
        return;
    }
    const AdhesiveCycle model(parameters);
    ContactMemory memory = model.bonded();
    Index at = 0;
    const auto follow = [&](const CycleBranch& samples, bool seen) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double force = model.bondedForce(samples.base[i], memory);
            if (seen) {
                out[at++] = (force - samples.force[i]) / range_;
            }
        }
    };
    follow(approach_, sees(FittedBranch::Approach));
    if (sees(FittedBranch::Retract)) {
        follow(retract_, true);
    }
    addEvents(model, out, at);
}

void AdhesiveProblem::addEvents(const AdhesiveCycle& model, Eigen::VectorXd& out, Index at) const {
    const double byForce = options_.pullOffWeight / range_;
    const double byPlace = options_.placeWeight * stiffness_ / range_;
    out.tail(out.size() - at).setZero();
    if (sees(FittedBranch::Retract) && pullOffBase_ && model.pullOff()) {
        out[at] = byForce * (model.lowestForce() - events_.lowestForce);
        out[at + 1] = byPlace * (*model.pullOff() - *pullOffBase_);
    }
    if (hasRange() && events_.snapIn) {
        out[at + 2] = byPlace * (*model.snapIn() - events_.snapIn->base);
    }
}

double AdhesiveProblem::squares(const AdhesiveParameters& parameters) const {
    Eigen::VectorXd out(static_cast<Index>(count()));
    residuals(parameters, out);
    return out.allFinite() ? out.squaredNorm() : std::numeric_limits<double>::infinity();
}

/// A first guess for everything but the modulus and the contact point: the work of adhesion from
/// the strongest pull.
AdhesiveParameters AdhesiveProblem::first(double gain) const {
    AdhesiveParameters guess{.law = law_,
                             .tipRadius = options_.tipRadius,
                             .lever = {stiffness_, gain, options_.calibration}};
    const double pull = std::max(-events_.lowestForce, 1e-3 * range_) / guess.lever.forceFactor();
    const double factor = isJkr(law_) ? 1.5 : 2.0;
    guess.approachWork = isElastic() ? 0.0 : pull / (factor * pi * guess.tipRadius);
    guess.retractWork = guess.approachWork;
    guess.reducedModulus = options_.fixedModulus.value_or(1.0);
    return guess;
}

/// The same with the contact point that gives the largest force at its base position, and the range
/// that gives the snap-in from there.
AdhesiveParameters AdhesiveProblem::placed(AdhesiveParameters guess) const {
    const CycleBranch& seen = sees(FittedBranch::Approach) ? approach_ : retract_;
    const std::size_t top = sees(FittedBranch::Approach) ? seen.size() - 1 : 0;
    const double compliance = 1.0 / guess.lever.trueStiffness();
    const double force = seen.force[top] / guess.lever.forceFactor();
    if (hasRange()) {
        guess.cohesiveRange = 1e-3 * guess.tipRadius;
    }
    for (int i = 0; i < 2; ++i) {
        const AdhesiveCycle model(guess);
        const auto base = basePositionAt(model.growing(), compliance, force);
        guess.contactPoint = seen.base[top] - base.value_or(0.0);
        if (hasRange() && events_.snapIn && guess.contactPoint > events_.snapIn->base) {
            guess.cohesiveRange = guess.contactPoint - events_.snapIn->base;
        }
    }
    return guess;
}

/// The best of a grid of moduli, and of gains where these are free.
AdhesiveParameters AdhesiveProblem::start() const {
    const double rigidGain = stiffness_ / slope_;
    std::vector<double> gains{1.0};
    if (hasGain()) {
        gains = {rigidGain, 0.8 * rigidGain, 0.5 * rigidGain};
    }
    std::optional<AdhesiveParameters> best;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const AdhesiveParameters& guess) {
        if (!isWithinLaw(guess)) {
            return;
        }
        const AdhesiveParameters trial = placed(guess);
        const double sum = squares(trial);
        if (sum < least || !best) {
            least = sum;
            best = trial;
        }
    };
    for (const double gain : gains) {
        AdhesiveParameters guess = first(gain);
        if (options_.fixedModulus) {
            offer(guess);
            continue;
        }
        // The contact's slope S and force F of Hertz: delta = 1.5 F / S, E* = S / (2 sqrt(R delta))
        const double observed = slope_ / stiffness_ * gain;  // bending of lever over base motion
        const double together = guess.lever.trueStiffness() * std::min(observed, 0.99);
        const double contact = together / (1.0 - std::min(observed, 0.99));
        const double depth = 1.5 * range_ / guess.lever.forceFactor() / contact;
        const double modulus = contact / (2.0 * std::sqrt(guess.tipRadius * depth));
        for (double factor = 1.0 / 64.0; factor < 100.0; factor *= 2.0) {
            guess.reducedModulus = modulus * factor;
            offer(guess);
        }
    }
    if (!best) {
        throw Error("the cycle suggests a modulus or an adhesion outside the range of the laws");
    }
    return *best;
}

std::vector<FreeParameter> AdhesiveProblem::freeParameters(const AdhesiveParameters& start) const {
    constexpr double kWide = 1e6;
    std::vector<FreeParameter> free;
    const auto add = [&](const char* key, const char* unit, double value, double wide) {
        free.push_back({key, unit, value, value / wide, value * wide, 0.0});
    };
    const double bent = range_ / stiffness_;
    free.push_back({"contact_point_m", "m", start.contactPoint, start.contactPoint - (10.0 * bent),
                    start.contactPoint + (10.0 * bent), 0.01 * bent});
    if (!options_.fixedModulus) {
        add("e_star_pa", "Pa", start.reducedModulus, kWide);
    }
    if (!isElastic()) {
        add(options_.twoWorks ? "work_of_adhesion_approach_j_m2" : "work_of_adhesion_j_m2", "J/m^2",
            start.approachWork, kWide);
    }
    if (options_.twoWorks) {
        free.push_back({"work_of_adhesion_ratio", "", 1.05, 1.0, kWide, 0.0});
    }
    if (hasRange()) {
        add("cohesive_range_m", "m", start.cohesiveRange, 1e4);
    }
    if (hasGain()) {
        add("invols_gain", "", start.lever.gain, 10.0);
    }
    return free;
}

/// In the order of freeParameters().
AdhesiveParameters AdhesiveProblem::with(AdhesiveParameters parameters,
                                         const std::vector<double>& values) const {
    auto value = values.begin();
    parameters.contactPoint = *value++;
    if (!options_.fixedModulus) {
        parameters.reducedModulus = *value++;
    }
    if (!isElastic()) {
        parameters.approachWork = *value++;
    }
    parameters.retractWork = parameters.approachWork;
    if (options_.twoWorks) {
        parameters.retractWork *= *value++;
    }
    if (hasRange()) {
        parameters.cohesiveRange = *value++;
    }
    if (hasGain()) {
        parameters.lever.gain = *value++;
    }
    return parameters;
}

AdhesiveFit AdhesiveProblem::solve() {
    const AdhesiveParameters guess = start();
    AdhesiveFit result;
    result.bounded = fitWithin(
        freeParameters(guess),
        [&](const std::vector<double>& values, Eigen::VectorXd& out) {
            residuals(with(guess, values), out);
        },
        count());
    result.parameters = with(guess, result.bounded.values);
    result.events = events_;
    return result;
}

void requireConsistent(const AdhesiveFitOptions& options) {
    if (options.twoWorks && options.law && !isJkr(*options.law)) {
        throw Error("two works of adhesion need a law of JKR: jkr or jkr_sphere");
    }
    if (options.law && (hasTail(*options.law) || isFilm(*options.law))) {
        throw Error("a cycle is identified with a law without a tail and without a film");
    }
}

/// The law for this transition parameter.
/// @param resolved whether the cycle shows a range of the adhesion
ContactLaw lawFor(double transition, bool resolved, bool sphere) {
    constexpr double kJkr = 3.2;
    constexpr double kDmt = 0.05;
    if (transition > kJkr) {
        return sphere ? ContactLaw::SphereJkr : ContactLaw::Jkr;
    }
    if (transition < kDmt && !resolved && !sphere) {
        return ContactLaw::Dmt;
    }
    return sphere ? ContactLaw::SphereMaugis : ContactLaw::Maugis;
}

double transitionOf(AdhesiveParameters parameters, double range) {
    parameters.law = ContactLaw::Maugis;
    parameters.cohesiveRange = range;
    return AdhesiveCycle(parameters).transitionParameter();
}

AdhesiveFit fitByTransition(const MeasuredCycle& cycle, const AdhesiveFitOptions& options) {
    constexpr int kMaxFits = 4;
    ContactLaw law = options.sphere ? ContactLaw::SphereMaugis : ContactLaw::Maugis;
    AdhesiveFit fit = AdhesiveProblem(cycle, options, law).solve();
    const double range = fit.parameters.cohesiveRange;
    const auto missing = fit.bounded.notIdentified();
    const bool resolved =
        std::find(missing.begin(), missing.end(), "cohesive_range_m") == missing.end();
    for (int i = 1; i < kMaxFits; ++i) {
        const ContactLaw next = options.twoWorks ? lawFor(1e9, resolved, options.sphere)
                                                 : lawFor(transitionOf(fit.parameters, range),
                                                          resolved, options.sphere);
        if (next == law) {
            break;
        }
        law = next;
        fit = AdhesiveProblem(cycle, options, law).solve();
    }
    return fit;
}

}  // namespace

AdhesiveFit adhesiveFit(const MeasuredCycle& cycle, const AdhesiveFitOptions& options) {
    requireConsistent(options);
    return options.law ? AdhesiveProblem(cycle, options, *options.law).solve()
                       : fitByTransition(cycle, options);
}

}  // namespace asperity
