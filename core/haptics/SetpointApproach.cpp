#include "core/haptics/SetpointApproach.h"

#include "core/contact/laws/ForceCurve.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kNoiseMargin = 12.0;  // setpoint over the deviation of the descent's line
constexpr double kRestMargin = 100.0;  // and over that of a mean at rest: k is known to a tenth
constexpr long kShortestRest = 10;     // ticks: their scatter is known to a quarter
constexpr long kLongestRest = 256;
constexpr double kHalf = 0.5;           // of the setpoint: from there on the force's rise is taken
constexpr int kMoves = 4;               // each leaves a quarter or so of what was missing
constexpr double kSettlingShare = 0.5;  // of the dwell
constexpr double kJump = 2.0;  // rise over the fastest that the lever allows; on flanks it is less

/// Variance of RecentLine::end() over that of a value.
double lineVariance(double length) {
    return 2.0 * (2.0 * length - 1.0) / (length * (length + 1.0));
}

/// Ticks over which the line must go; one where there is no noise.
std::size_t lineLength(double deviation, double setpoint) {
    const double allowed = setpoint / kNoiseMargin;
    std::size_t length = 1;
    while (length < RecentLine::kMaxLength &&
           lineVariance(static_cast<double>(length)) * deviation * deviation > allowed * allowed) {
        ++length;
    }
    return length;
}

// Share of the duration; a descent at its limit and the way back still fit.
constexpr double kBaselineShare = 0.02;
constexpr double kDescentShare = 0.36;  // to the setpoint, as expected
constexpr double kLimitShare = 0.45;    // at most
constexpr double kDwellShare = 0.05;

/// Returns the base's depth below first touch at a position, for a force without adhesion [m]:
/// Hertz and the lever. Source: docs/theory.md 2.2.
double depthByHertz(const Scene& scene, const Vector3& position, double force) {
    const ContactPair pair = scene.belief.pairAt(position, scene.belief.tipRadius());
    const double stiffness = 4.0 / 3.0 * pair.reducedModulus * std::sqrt(pair.tipRadius);
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    return std::pow(force / stiffness, 2.0 / 3.0) + compliance * force;
}

/// The same by the scene's law [m]; 0 where it does not reach the force.
double depthByLaw(const Scene& scene, const Vector3& position, double force) {
    const ProbeSystem& belief = scene.belief;
    const ContactModel model = belief.contact.withPair(belief.pairAt(position, belief.tipRadius()));
    return basePositionAt(model, belief.cantilever.compliance()(2, 2), force).value_or(0.0);
}

}  // namespace

// Welford's recurrence: no cancellation, however large the mean.
void RunningMoments::add(double value) noexcept {
    ++count_;
    const double distance = value - mean_;
    mean_ += distance / static_cast<double>(count_);
    squares_ += distance * (value - mean_);
}

double RunningMoments::deviation() const noexcept {
    return count_ < 2 ? 0.0 : std::sqrt(squares_ / static_cast<double>(count_ - 1));
}

double RunningMoments::meanDeviation() const noexcept {
    return count_ < 2 ? 0.0 : deviation() / std::sqrt(static_cast<double>(count_));
}

RecentLine::RecentLine(std::size_t length) noexcept
    : length_(std::clamp<std::size_t>(length, 1, kMaxLength)) {}

void RecentLine::add(double value) noexcept {
    values_.at(count_ % length_) = value;
    ++count_;
}

// Weights of a least-squares line through equidistant values, at the last one.
double RecentLine::end() const noexcept {
    const auto length = static_cast<double>(length_);
    double sum = 0.0;
    for (std::size_t i = 0; i < length_; ++i) {
        const auto order = static_cast<double>(i + 1);  // the oldest first
        sum += (3.0 * order - length - 1.0) * values_.at((count_ + i) % length_);
    }
    return 2.0 * sum / (length * (length + 1.0));
}

Vector3 SetpointApproach::advance(double timeStep, double force, bool hasEquilibrium) noexcept {
    if (!std::exchange(started_, true)) {
        return start_;
    }
    inPhase_ += timeStep;
    if (!isBlocked()) {
        unsolved_ = hasEquilibrium ? 0.0 : unsolved_ + timeStep;
    }
    switch (phase_) {
    case ApproachPhase::Baseline:
        free_.add(force);
        if (inPhase_ >= plan_.baseline) {
            beginDescent();
        }
        break;
    case ApproachPhase::Descent:
        descend(timeStep, force);
        break;
    case ApproachPhase::Settling:
        settle(timeStep, force);
        break;
    case ApproachPhase::Dwell:
        rest_.add(force);
        if (inPhase_ >= plan_.dwell) {
            enter(ApproachPhase::Retract);
        }
        break;
    case ApproachPhase::Retract:
        retract(timeStep);
        break;
    case ApproachPhase::Done:
        break;
    }
    return start_ - depth_ * Vector3::UnitZ();
}

double SetpointApproach::measuredDeviation() const noexcept {
    return std::hypot(rest_.meanDeviation(), free_.meanDeviation());
}

void SetpointApproach::enter(ApproachPhase phase) noexcept {
    phase_ = phase;
    inPhase_ = 0.0;
}

void SetpointApproach::beginDescent() noexcept {
    recent_ = RecentLine(lineLength(free_.deviation(), plan_.setpoint));
    ticksAbove_ = 0;
    enter(ApproachPhase::Descent);
}

void SetpointApproach::descend(double timeStep, double force) noexcept {
    if (!std::isfinite(force) || isBlocked()) {
        enter(ApproachPhase::Retract);
        return;
    }
    recent_.add(force);
    if (recent_.isFull()) {
        const double reached = recent_.end() - free_.mean();
        if (reached >= plan_.setpoint) {
            beginSettling(timeStep);
            return;
        }
        ticksAbove_ += reached >= kHalf * plan_.setpoint ? 1 : 0;
    }
    depth_ = std::min(depth_ + timeStep * plan_.speed, plan_.maxDescent);
    if (depth_ >= plan_.maxDescent) {
        enter(ApproachPhase::Retract);
    }
}

/// Half of the dwell is for it, at most. Where the force passed half of the setpoint is told by how
/// many ticks were above it: noise takes as many of them away after that as it adds before.
void SetpointApproach::beginSettling(double timeStep) noexcept {
    const double room = kSettlingShare * plan_.dwell / (timeStep * (kMoves + 1));
    longestRest_ = static_cast<long>(std::clamp(room, 1.0, static_cast<double>(kLongestRest)));
    rest_ = {};
    halfDepth_ = depth_ - (static_cast<double>(ticksAbove_) + 0.5) * timeStep * plan_.speed;
    goal_ = depth_;
    moves_ = 0;
    enter(ApproachPhase::Settling);
}

void SetpointApproach::settle(double timeStep, double force) noexcept {
    if (!std::isfinite(force) || isBlocked()) {
        enter(ApproachPhase::Retract);
        return;
    }
    if (depth_ != goal_) {
        const double step = timeStep * plan_.speed;
        depth_ = std::clamp(goal_, depth_ - step, depth_ + step);
        return;
    }
    rest_.add(force);
    if (!isRestKnown() || (moves_ == 0 && !takeSlope())) {
        return;
    }
    if (moves_ == kMoves) {
        dwell();
        return;
    }
    const double missing = plan_.setpoint - measuredForce();
    goal_ = std::clamp(depth_ + missing / slope_, halfDepth_, plan_.maxDescent);
    ++moves_;
    rest_ = {};
}

bool SetpointApproach::isRestKnown() const noexcept {
    const bool isGood = rest_.meanDeviation() <= plan_.setpoint / kRestMargin;
    return rest_.count() >= longestRest_ || (rest_.count() >= kShortestRest && isGood);
}

bool SetpointApproach::takeSlope() noexcept {
    const double rise = measuredForce() - kHalf * plan_.setpoint;
    const double way = depth_ - halfDepth_;
    if (!(rise > 0.0)) {  // it was noise
        beginDescent();
        return false;
    }
    if (measuredForce() > plan_.setpoint && rise > kJump * plan_.stiffness * way) {
        dwell();
        return false;
    }
    slope_ = rise < plan_.stiffness * way ? rise / way : plan_.stiffness;
    return true;
}

void SetpointApproach::dwell() noexcept {
    engaged_ = true;
    rest_ = {};
    phase_ = ApproachPhase::Dwell;  // since it began to settle
}

void SetpointApproach::retract(double timeStep) noexcept {
    depth_ = std::max(depth_ - timeStep * plan_.speed, 0.0);
    if (depth_ == 0.0) {
        enter(ApproachPhase::Done);
    }
}

double expectedDepth(const Scene& scene, const Vector3& position, double force) {
    return std::max(depthByHertz(scene, position, force), depthByLaw(scene, position, force));
}

PlannedApproach planApproach(const Scene& scene, const PathPlan& plan) {
    const Vector3 start = pathStart(scene, plan);
    const double clearance = start.z() - touchHeight(scene, start.x(), start.y());
    const double setpoint = plan.setpoint.value_or(scene.description.setpoint);
    const double expected = clearance + depthByHertz(scene, start, setpoint);
    // Adhesion holds a soft sample on a cone far above where Hertz has the setpoint.
    const double needed = clearance + depthByLaw(scene, start, setpoint);
    const double descent = needed > kLimitShare / kDescentShare * expected ? needed : expected;
    const double speed = descent / (kDescentShare * plan.duration);
    return {.start = start,
            .plan = {.setpoint = setpoint,
                     .speed = speed,
                     .stiffness = 1.0 / scene.belief.cantilever.compliance()(2, 2),
                     .baseline = kBaselineShare * plan.duration,
                     .dwell = kDwellShare * plan.duration,
                     .maxDescent = speed * kLimitShare * plan.duration}};
}

ApproachDevice::ApproachDevice(const PlannedApproach& approach, double positionGain)
    : ApproachDevice({{0.0, approach.start}}, approach.plan, positionGain,
                     approach.start / positionGain) {}

ApproachDevice::ApproachDevice(DevicePath leadIn, const ApproachPlan& plan, double positionGain,
                               Vector3 start)
    : leadIn_(std::move(leadIn))
    , approach_(plan, leadIn_.back().position)
    , positionGain_(positionGain)
    , start_(std::move(start)) {}

DeviceState ApproachDevice::advance(double timeStep) noexcept {
    const Vector3 moved = nextBase(timeStep) - leadIn_.front().position;
    if (approach_.hasMeasured() && !measured_) {
        measuredForce_ = approach_.measuredForce();
        measuredDeviation_ = approach_.measuredDeviation();
        freeForce_ = approach_.freeForce();
        measured_ = true;
    }
    blocked_ = approach_.isBlocked();
    engaged_ = approach_.hasEngaged();
    phase_ = approach_.phase();
    return {.position = start_ + moved / positionGain_};
}

Vector3 ApproachDevice::nextBase(double timeStep) noexcept {
    if (std::exchange(started_, true)) {
        time_ += timeStep;
    }
    return time_ < leadIn_.back().time ? positionAt(leadIn_, time_)
                                       : approach_.advance(timeStep, force_, hasEquilibrium_);
}

void ApproachDevice::observe(const TickOutput& output) noexcept {
    force_ = approach_.axis().dot(output.estimate.force);
    hasEquilibrium_ = !output.flags.has(Validity::NotInEquilibrium) &&
                      !output.flags.has(Validity::FrictionLock) &&
                      output.fault != Fault::RecordEnded;
}

}  // namespace asperity
