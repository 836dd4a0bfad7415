#include "core/haptics/cycle/CycleDetector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kEndShare = 0.75;  ///< of the force at the deepest position
constexpr double kMinTicks = 4.0;
constexpr double kSure = 10.0;  ///< standard deviations of a slope

constexpr int kTicksOff = 5;           ///< in a row that end a cycle: one may be noise
constexpr double kResidualPull = 0.5;  ///< of the strongest: attraction that a free tip may feel

constexpr double kSlide = 1e-9;  ///< sideways, more than the jitter of a device [m]
/// Sideways motion of the tip: more than a lever that presses bends sideways on a slope [m].
constexpr double kTipSlide = 5e-9;

/// Returns whether the base goes along the sample rather than to it or from it.
bool slides(const BaseMotion& base) noexcept {
    return std::hypot(base.velocity.x(), base.velocity.y()) > std::abs(base.velocity.z());
}

/// Returns the standard deviation of a trend, but not more than that of a settled one [N]: just
/// after a jump it rests on one tick, and any force would seem as strong as the strongest.
double settledSigma(const ForceTrend& trend, const ForceDistancePoint& point) noexcept {
    constexpr double kSettled = 0.42;  // of a tick's, see ForceTrend
    return std::min(trend.sigma(), kSettled * point.sigma);
}

/// A reading with what else it may have missed [N].
std::optional<Reading> withMissed(std::optional<Reading> reading, double missed) noexcept {
    if (reading) {
        reading->sigma = std::hypot(reading->sigma, missed);
    }
    return reading;
}

}  // namespace

void UnloadingFit::restart(const ForceDistancePoint& deepest, double force) noexcept {
    *this = {};
    open_ = force > 0.0;
    endForce_ = kEndShare * force;
    first_ = deepest;
    add(deepest);
}

void UnloadingFit::take(const ForceDistancePoint& point, double force) noexcept {
    open_ = open_ && force >= endForce_;
    if (open_) {
        add(point);
    }
}

void UnloadingFit::add(const ForceDistancePoint& point) noexcept {
    const double base = point.baseDistance - first_.baseDistance;
    const double separation = point.separation - first_.separation;
    const double force = point.force - first_.force;
    count_ += 1.0;
    base_ += base;
    force_ += force;
    separation_ += separation;
    baseBase_ += base * base;
    baseForce_ += base * force;
    baseSeparation_ += base * separation;
    separation2_ += separation * separation;
    force2_ += force * force;
}

Reading UnloadingFit::slopeOf(double sum, double sumOfSquares,
                              double sumOfProducts) const noexcept {
    const double spread = baseBase_ - base_ * base_ / count_;
    const double slope = (sumOfProducts - base_ * sum / count_) / spread;
    const double scatter = sumOfSquares - sum * sum / count_ - slope * slope * spread;
    return {.value = slope, .sigma = std::sqrt(std::max(0.0, scatter) / (count_ - 2.0) / spread)};
}

std::optional<Reading> UnloadingFit::stiffness() const noexcept {
    if (count_ < kMinTicks || !(baseBase_ * count_ > base_ * base_)) {
        return std::nullopt;
    }
    const Reading force = slopeOf(force_, force2_, baseForce_);
    const Reading separation = slopeOf(separation_, separation2_, baseSeparation_);
    if (!(force.value < -kSure * force.sigma) || !(separation.value > kSure * separation.sigma)) {
        return std::nullopt;
    }
    const double stiffness = -force.value / separation.value;
    // The same noise moves both slopes, in opposite directions.
    const double share = separation.sigma / separation.value - force.sigma / force.value;
    return Reading{.value = stiffness, .sigma = stiffness * share};
}

Reading StrongestForce::meanOf(const std::array<HalfForce, 2>& halves) noexcept {
    return {.value = 0.5 * (halves[0].force + halves[1].force),
            .sigma = 0.5 * std::hypot(halves[0].sigma, halves[1].sigma)};
}

bool StrongestForce::take(const std::array<HalfForce, 2>& halves, double force,
                          const DepthBeside& depth) noexcept {
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const double sure = halves[i].smooth - (caution_ * halves[i].smoothSigma);
        if (!reading_ || sure > strongest_[i]) {
            strongest_[i] = sure;
            measured_[i] = halves[1 - i];
            measuredDepth_[i] = depth.halves[1 - i];
            pickSigma_[i] = depth.stiffness > 0.0 ? halves[i].smoothSigma / depth.stiffness : 0.0;
        }
    }
    const bool isStrongest = !reading_ || force > strongestForce_;
    strongestForce_ = isStrongest ? force : strongestForce_;
    reading_ = meanOf(measured_);
    return isStrongest;
}

Reading StrongestForce::readingBeside() const noexcept {
    Reading depth = meanOf(measuredDepth_);
    depth.sigma = std::hypot(depth.sigma, 0.5 * std::hypot(pickSigma_[0], pickSigma_[1]));
    return depth;
}

void StrongestPositions::take(double force, double sigma, double position) noexcept {
    // In standard deviations: how far below the strongest a force counts as equal, and how far
    // above the first one it shows that the position is another.
    constexpr double kWeaker = 3.0;
    constexpr double kStronger = 5.0;
    if (!started_ || force > first_ + kStronger * sigma) {
        started_ = true;
        first_ = strongest_ = force;
        lowest_ = highest_ = position;
    }
    strongest_ = std::max(strongest_, force);
    if (force >= strongest_ - kWeaker * sigma) {
        lowest_ = std::min(lowest_, position);
        highest_ = std::max(highest_, position);
    }
}

double StrongestPositions::sigmaOf(double position) const noexcept {
    return std::max(position - lowest_, highest_ - position) / std::sqrt(3.0);
}

void CycleDetector::take(double time, const TickInput& input, const TickOutput& out) noexcept {
    if (!hasPoint(out)) {
        cycle_.interrupted = cycle_.interrupted || cycle_.phase == CyclePhase::Contact;
        return;
    }
    const CurveBranch branchBefore = branch_.branch();
    const double baseBefore = point_.baseDistance;
    const double forceBefore = trend_.force();
    point_ = forceDistancePoint(out);
    step_ = started_ ? point_.baseDistance - baseBefore : 0.0;
    contactStiffness_ = out.model.contact.stiffness;
    takeTrends();
    const bool turned = branch_.take(input, out) != branchBefore;
    slides_ = slides(out.base);
    base_ = out.base.position.head<2>();
    tip_ = out.model.tip.head<2>();
    const bool bonded = out.model.contact.branch == ContactBranch::Bonded;
    const bool acts = trend_.pushes() || trend_.pulls();

    const double pull = cycle_.pullOff ? cycle_.pullOff->value : 0.0;
    const bool stillPulls = trend_.pulls() && -trend_.force() > kResidualPull * pull;

    // A model without adhesion lets go where the force is zero: the pull is still to come.
    if (cycle_.complete() && stillPulls && branch_.branch() == CurveBranch::Retract) {
        cycle_.phase = CyclePhase::Contact;
    }
    // The noise may hide a weak force for some ticks: the model knows of the contact at once.
    if (cycle_.phase == CyclePhase::Apart) {
        cycle_.fromStart = (cycle_.fromStart || !started_) && (bonded || trend_.pushes());
    }
    if (cycle_.phase == CyclePhase::Contact) {
        cycle_.contacts = std::max(cycle_.contacts, out.model.points);
        takeContact(time, turned, bonded || trend_.pushes() || stillPulls);
    } else {
        takeApart(time, turned, trend_.pushes() || (bonded && acts));
    }
    takeSnapIn();
    if (started_ && (acts || cycle_.phase == CyclePhase::Contact)) {
        takeAreas(forceBefore);
    }
    started_ = true;
}

void CycleDetector::takeTrends() noexcept {
    const double deflection = point_.separation - point_.baseDistance;
    deflectionTimesForce_ += deflection * point_.force;
    forceSquares_ += point_.force * point_.force;
    trend_.take(point_.force, point_.sigma);
    depth_.take(-point_.separation, compliance() * point_.sigma);
}

double CycleDetector::compliance() const noexcept {
    return forceSquares_ > 0.0 ? std::abs(deflectionTimesForce_ / forceSquares_) : 0.0;
}

void CycleDetector::begin() noexcept {
    cycle_ = {};
    push_ = StrongestForce(StrongestForce::kGrowing);
    snapInPull_ = StrongestForce(StrongestForce::kSudden);
    pullOffPull_ = StrongestForce(StrongestForce::kGrowing);
    snapInPositions_ = {};
    areaVariance_ = 0.0;
    retracted_ = false;
    ++number_;
}

void CycleDetector::takeApart(double time, bool turned, bool touches) noexcept {
    const bool again = turned && branch_.branch() == CurveBranch::Approach;
    if (again || (touches && cycle_.complete())) {
        begin();
    }
    if (touches) {
        cycle_.phase = CyclePhase::Contact;
        cycle_.touchTime = time;
        cycle_.position = tip_;
        touched_ = base_;
        tipTouched_ = tip_;
        deepest_ = std::numeric_limits<double>::infinity();
        ticksOff_ = 0;
        takeUnloading();
    }
}

void CycleDetector::takeContact(double time, bool turned, bool held) noexcept {
    ticksOff_ = held ? 0 : ticksOff_ + 1;
    if (ticksOff_ >= kTicksOff) {
        cycle_.phase = CyclePhase::Complete;
        cycle_.offTime = time;
        return;
    }
    cycle_.slid = cycle_.slid || (base_ - touched_).norm() > kSlide ||
                  (tip_ - tipTouched_).norm() > kTipSlide;
    if (trend_.pushes()) {
        (void)push_.take(trend_.halves(1.0), trend_.push(),
                         {.halves = depth_.halves(1.0), .stiffness = contactStiffness_});
        cycle_.maxForce = push_.reading();
        cycle_.maxIndentation = push_.readingBeside();
    }
    takeUnloading();
    if (branch_.branch() != CurveBranch::Retract) {
        return;
    }
    retracted_ = true;
    if (turned) {
        cycle_.pullOff.reset();
        pullOffPull_ = StrongestForce(StrongestForce::kGrowing);
        cycle_.adhesionWork = 0.0;
    }
    takePullOff();
}

/// An attraction that comes before contact counts, too: instrument and model seldom snap in at the
/// same tick. The position lies between two ticks, and the noise lets a weaker pull further on seem
/// the strongest.
void CycleDetector::takeSnapIn() noexcept {
    const bool approaches =
        !cycle_.fromStart && !retracted_ && branch_.branch() == CurveBranch::Approach;
    if (!approaches || !trend_.pulls()) {
        return;
    }
    const bool isStrongest = snapInPull_.take(trend_.halves(-1.0), trend_.pull());
    snapInPositions_.take(trend_.pull(), settledSigma(trend_, point_), point_.baseDistance);
    Reading& position = cycle_.snapInBaseDistance;
    if (isStrongest) {
        position.value = point_.baseDistance;
        snapInPositionNoise_ = std::hypot(step_ / std::sqrt(12.0), compliance() * trend_.sigma());
        snapInMissed_ = missedByStep();
    }
    position.sigma = std::hypot(snapInPositionNoise_, snapInPositions_.sigmaOf(position.value));
    cycle_.snapIn = withMissed(snapInPull_.reading(), snapInMissed_);
}

/// A jump comes anywhere between two ticks: the base moves on by up to a step, and the
/// force with it, as lever and contact let it, at most as the lever alone.
double CycleDetector::missedByStep() const noexcept {
    const double lever = compliance() > 0.0 ? 1.0 / compliance() : 0.0;
    const double together = std::abs(contactStiffness_ * lever / (contactStiffness_ + lever));
    const double slope = together < lever ? together : lever;  // where it jumps they cancel
    return slope * std::abs(step_) / std::sqrt(3.0);           // root mean square of 0 to all of it
}

void CycleDetector::takePullOff() noexcept {
    if (!trend_.pulls()) {
        return;
    }
    const bool isStrongest = pullOffPull_.take(trend_.halves(-1.0), trend_.pull());
    if (isStrongest) {
        pullOffMissed_ = missedByStep();
        cycle_.pullOffSeparation = point_.separation;
        cycle_.pullOffBaseDistance = point_.baseDistance;
    }
    cycle_.pullOff = withMissed(pullOffPull_.reading(), pullOffMissed_);
}

/// By the trapezoidal rule, over the base distance: it has no noise.
void CycleDetector::takeAreas(double forceBefore) noexcept {
    const double force = trend_.force();
    cycle_.hysteresis -= 0.5 * (force + forceBefore) * step_;
    // A jump lies anywhere between its two ticks.
    const double jump = (force - forceBefore) * step_;
    // Each tick's own noise counts once: that of the trend is shared by neighbors.
    areaVariance_ += jump * jump / 12.0 + point_.sigma * point_.sigma * step_ * step_;
    cycle_.areaSigma = std::sqrt(areaVariance_);
    if (cycle_.phase == CyclePhase::Contact && branch_.branch() == CurveBranch::Retract) {
        const double pull = std::max(0.0, -force) + std::max(0.0, -forceBefore);
        cycle_.adhesionWork += 0.5 * pull * step_;
    }
}

/// Where the tip slides, roughness changes the distance: unloading begins after that.
void CycleDetector::takeUnloading() noexcept {
    if (slides_ || point_.baseDistance < deepest_) {
        deepest_ = point_.baseDistance;
        unloading_.restart(point_, trend_.force());
    } else {
        unloading_.take(point_, trend_.force());
    }
    cycle_.stiffness = unloading_.stiffness();
}

}  // namespace asperity
