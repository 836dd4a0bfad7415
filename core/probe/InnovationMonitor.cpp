#include "core/probe/InnovationMonitor.h"

#include "core/probe/DecouplingRows.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

using decoupling::adhesiveFriction;
using decoupling::ContactGeometry;
using decoupling::frictionScale;
using decoupling::kFrictionLawDefect;
using decoupling::kPlanarityDefect;
using decoupling::NormalErrors;
using decoupling::normalErrors;

constexpr double kFalseAlarms = 1e-4;       // [1/s]
constexpr double kNormalWander = 0.05;      // [s] in which the defect of N changes by one unit
constexpr double kFrictionWander = 20.0;    // [s] same of T: it belongs to the material
constexpr double kContradiction = 3.0;      // units of N
constexpr double kWrongLaw = 0.5;           // standard deviations of the law, 15 % of friction
constexpr double kStays = 0.8;              // of a threshold, once it was passed
constexpr double kSignificanceStays = 0.5;  // same
constexpr double kVisibleFriction = 0.1;    // of the torsion's noise: a weaker law is not tested
constexpr double kJump = 25.0;              // squared innovation: the contact has changed
constexpr double kNoiseWindow = 200.0;      // measurements
constexpr double kNoisy = 1.5;              // times the stated variance: 7 deviations of the mean
constexpr double kNoiseStays = 1.25;        // same, once it was passed
constexpr double kNoiseScatter = 0.3;       // of the mean, that noise as stated can reach
constexpr double kMeanScatter = 9.0;        // variances of a defect that count for nothing
constexpr double kSlides = 0.5;             // weight of the slip direction from which it counts

double squareOf(double value) noexcept { return value * value; }

/// Response of one signal, as a force, to the two defects.
struct SignalRow {
    double normal = 0.0;      ///< [N] per unit
    double friction = 0.0;    ///< [N] per unit
    double innovation = 0.0;  ///< measured minus predicted [N]
    double variance = 0.0;    ///< of the noise [N^2]
};

struct SignalRows {
    SignalRow bending;
    SignalRow torsion;
};

/// Unit of the friction law's defect [N]. A law much weaker than the noise cannot be measured in
/// its own deviations.
double unitOfFriction(const Cantilever& cantilever, const DecouplingInput& in,
                      double stated) noexcept {
    const double noise = in.sigma.torsion / cantilever.torsionPerFy();
    return std::hypot(stated, kVisibleFriction * noise);
}

/// @param frictionUnit [N]; 0: friction is not looked at
SignalRows rowsOf(const Cantilever& cantilever, const DecouplingInput& in,
                  const ContactGeometry& geometry, double frictionUnit) noexcept {
    const double kappa = cantilever.couplingRatio();
    const Sliding& sliding = geometry.sliding;
    const double law = (in.frictionCoefficient * in.normalForceModel) + adhesiveFriction(in);
    const Vector3 slip = sliding.slip();
    const Vector3 expected = (in.normalForceModel * geometry.normal) + (std::max(0.0, law) * slip);
    const Vector3 perNormal =
        in.normalForceSigma *
        (law > 0.0 ? Vector3(geometry.normal + (in.frictionCoefficient * slip)) : geometry.normal);
    const Vector3 perFriction = frictionUnit * slip;
    // Due to neither defect: friction across the motion, and in any direction at rest.
    const double aside =
        frictionScale(in) * std::hypot(sliding.certainty * kPlanarityDefect, sliding.doubt);
    // Nor for a normal that is turned about either axis.
    const NormalErrors errors = normalErrors(in, geometry);
    const Vector3 turnedAlong =
        (errors.along * sliding.friction) - (errors.normal * geometry.normal);
    const Vector3 turnedAcross = errors.across * geometry.normal.cross(sliding.friction);
    const auto bend = [kappa](const Vector3& force) { return (kappa * force.x()) + force.z(); };
    const double bendingNoise = in.sigma.bending / cantilever.bendingPerFz();
    const double torsionNoise = in.sigma.torsion / cantilever.torsionPerFy();
    SignalRows rows;
    rows.bending = {.normal = bend(perNormal),
                    .friction = bend(perFriction),
                    .innovation = (in.signals.bending / cantilever.bendingPerFz()) - bend(expected),
                    .variance = (bendingNoise * bendingNoise) + (kappa * kappa * aside * aside) +
                                squareOf(bend(turnedAlong)) + squareOf(bend(turnedAcross))};
    rows.torsion = {.normal = perNormal.y(),
                    .friction = perFriction.y(),
                    .innovation = (in.signals.torsion / cantilever.torsionPerFy()) - expected.y(),
                    .variance = (torsionNoise * torsionNoise) + (aside * aside) +
                                squareOf(turnedAlong.y()) + squareOf(turnedAcross.y())};
    return rows;
}

/// Innovation that the defects known so far do not explain.
double unexplained(const SignalRow& row, const InnovationMemory& memory) noexcept {
    return row.innovation - (row.normal * memory.normalDefect) -
           (row.friction * memory.frictionDefect);
}

/// Returns what of a signal's variance the defects leave open: that of N, that of T [N^2].
double ofNormal(const SignalRow& row, const InnovationMemory& memory) noexcept {
    return row.normal * row.normal * memory.normalVariance;
}
double ofFriction(const SignalRow& row, double frictionVariance) noexcept {
    return row.friction * row.friction * frictionVariance;
}

/// Forgets the defect of N: the contact is another one now.
void forgetNormal(InnovationMemory& memory) noexcept {
    memory.normalDefect = 0.0;
    memory.normalVariance = InnovationMemory::kWide;
}

/// The bending gives N. Friction along the beam shows in it a sixth as much at most: it is noise
/// here, as large as stated, and nothing is learned of it.
double bendingVariance(const SignalRow& row, const InnovationMemory& memory) noexcept {
    return ofNormal(row, memory) + ofFriction(row, std::min(memory.frictionVariance, 1.0)) +
           row.variance;
}

/// Where the tip has just snapped in or let go in truth alone, N jumps.
bool hasJumped(const SignalRow& bending, const InnovationMemory& memory) noexcept {
    const double rest = unexplained(bending, memory);
    return rest * rest > kJump * bendingVariance(bending, memory);
}

/// Returns the squared innovation over its variance.
double takeBending(const SignalRow& row, InnovationMemory& memory) noexcept {
    const double rest = unexplained(row, memory);
    const double variance = bendingVariance(row, memory);
    const double gain = memory.normalVariance * row.normal / variance;
    memory.normalDefect += gain * rest;
    memory.normalVariance *= (variance - ofNormal(row, memory)) / variance;
    return rest * rest / variance;
}

/// The torsion gives T, with N as the bending gave it.
double takeTorsion(const SignalRow& row, InnovationMemory& memory) noexcept {
    const double rest = unexplained(row, memory);
    const double known = ofNormal(row, memory) + row.variance;
    const double variance = known + ofFriction(row, memory.frictionVariance);
    const double gain = memory.frictionVariance * row.friction / variance;
    memory.frictionDefect += gain * rest;
    memory.frictionVariance *= known / variance;
    return rest * rest / variance;
}

/// Noise beyond what is stated makes a defect less certain.
double scatter(double noise) noexcept { return std::max(1.0, noise); }

/// Mean square over the window, of what is stated. A single far one is an event, not noise.
void follow(double& noise, double square) noexcept {
    noise += (scatter(noise) * std::min(square, kJump) - noise) / kNoiseWindow;
}

void wander(double timeStep, InnovationMemory& memory) noexcept {
    memory.normalVariance =
        std::min(InnovationMemory::kWide, memory.normalVariance + timeStep / kNormalWander);
    memory.frictionVariance =
        std::min(InnovationMemory::kWide, memory.frictionVariance + timeStep / kFrictionWander);
}

/// Square of a defect over its variance that noise exceeds with a probability of kFalseAlarms times
/// the time step: the quantile of chi-square with two degrees of freedom, one per defect. A window
/// makes the ticks dependent, so that alarms are rarer than this.
double significance(double timeStep) noexcept {
    return -2.0 * std::log(std::min(0.5, kFalseAlarms * timeStep));
}

/// Returns whether a defect is large and certain, with hysteresis.
bool isOff(double defect, double variance, double size, double threshold, bool before) noexcept {
    const double largeness = before ? kStays * size : size;
    const double certainty = before ? kSignificanceStays * threshold : threshold;
    return std::abs(defect) > largeness && defect * defect > certainty * variance;
}

bool isNoisy(const InnovationMemory& memory) noexcept {
    return std::max(memory.bendingNoise, memory.torsionNoise) >
           (memory.noisy ? kNoiseStays : kNoisy);
}

/// Returns what of the law's error, as far as it is certain, goes beyond its stated deviation [N].
double frictionLawError(const InnovationMemory& memory, double unit, double stated) noexcept {
    const double square =
        (memory.frictionDefect * memory.frictionDefect) - (kMeanScatter * memory.frictionVariance);
    return std::sqrt(std::max(0.0, (unit * unit * square) - (stated * stated)));
}

}  // namespace

InnovationVerdict monitorInnovation(const Cantilever& cantilever, const InnovationInput& input,
                                    InnovationMemory& memory) noexcept {
    const DecouplingInput& belief = input.belief;
    const ContactGeometry geometry = decoupling::geometryOf(cantilever, belief);
    const bool touches = belief.contactArea > 0.0;
    const double stated = kFrictionLawDefect * frictionScale(belief);
    const double unit = touches ? unitOfFriction(cantilever, belief, stated) : 0.0;
    // Where the contact itself is in doubt, friction is no matter of its law.
    const bool rubs = touches && !memory.contradicted;
    SignalRows rows = rowsOf(cantilever, belief, geometry, rubs ? unit : 0.0);
    rows.bending.variance *= scatter(memory.bendingNoise);
    rows.torsion.variance *= scatter(memory.torsionNoise);
    wander(input.timeStep, memory);
    const bool isNew = input.age < memory.age + (0.5 * input.timeStep);
    memory.age = input.age;
    if (isNew) {
        if (input.modelJumped || hasJumped(rows.bending, memory)) {
            forgetNormal(memory);
        }
        follow(memory.bendingNoise, takeBending(rows.bending, memory));
        follow(memory.torsionNoise, takeTorsion(rows.torsion, memory));
    }
    const double threshold = significance(input.timeStep);
    memory.contradicted = isOff(memory.normalDefect, memory.normalVariance, kContradiction,
                                threshold, memory.contradicted);
    if (rubs) {
        memory.frictionWrong = isOff(memory.frictionDefect, memory.frictionVariance,
                                     kWrongLaw * stated / unit, threshold, memory.frictionWrong);
    }
    memory.noisy = isNoisy(memory);
    const bool slides = touches && geometry.sliding.certainty > kSlides;
    const double noise = std::max(memory.bendingNoise, memory.torsionNoise) - kNoiseScatter;
    return {.modelContradicted = memory.contradicted,
            .estimateInconsistent = memory.noisy || (memory.frictionWrong && slides),
            .frictionLawError =
                geometry.sliding.certainty * std::max(frictionLawError(memory, unit, stated),
                                                      decoupling::leastLawError(belief, stated)),
            .covarianceFactor = std::max(1.0, noise)};
}

LeverSignals stalenessOf(const LeverSignals& expected, double age, double timeStep,
                         SignalHistory& memory) noexcept {
    const double kept = age > 0.0 ? std::exp(-timeStep / age) : 0.0;
    const LeverSignals last = memory.started ? memory.expected : expected;
    memory = {.expected = expected,
              .change = {.bending = kept * memory.change.bending +
                                    std::abs(expected.bending - last.bending),
                         .torsion = kept * memory.change.torsion +
                                    std::abs(expected.torsion - last.torsion)},
              .started = true};
    return age > 0.0 ? memory.change : LeverSignals{};
}

}  // namespace asperity
