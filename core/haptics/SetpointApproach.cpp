#include "core/haptics/SetpointApproach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kNoiseMargin = 12.0;   // setpoint over the deviation of the descent's line
constexpr double kRestMargin = 100.0;   // and over that of a mean at rest: k is known to a tenth
constexpr double kHalf = 0.5;           // of the setpoint: from there on the force's rise is taken
constexpr int kMoves = 4;               // each leaves a quarter or so of what was missing
constexpr double kSettlingShare = 0.5;  // of the dwell
constexpr double kJump = 2.0;  // rise over the fastest that the lever allows; on flanks it is less

std::size_t ticks(double count) {
    return static_cast<std::size_t>(
        std::clamp(std::ceil(count), 1.0, static_cast<double>(RecentMean::kMaxLength)));
}

/// Ticks of a mean at rest; one where there is no noise.
std::size_t meanLength(double deviation, double setpoint) {
    const double ratio = kRestMargin * deviation / setpoint;
    return ticks(ratio * ratio);
}

/// Variance of RecentMean::lineEnd() over that of a value.
double lineVariance(double length) {
    return 2.0 * (2.0 * length - 1.0) / (length * (length + 1.0));
}

/// Ticks over which the line must go; one where there is no noise.
std::size_t lineLength(double deviation, double setpoint) {
    const double allowed = setpoint / kNoiseMargin;
    std::size_t length = 1;
    while (length < RecentMean::kMaxLength &&
           lineVariance(static_cast<double>(length)) * deviation * deviation > allowed * allowed) {
        ++length;
    }
    return length;
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

RecentMean::RecentMean(std::size_t length) noexcept
    : length_(std::clamp<std::size_t>(length, 1, kMaxLength)) {}

void RecentMean::add(double value) noexcept {
    values_.at(count_ % length_) = value;
    ++count_;
}

// Summed anew: a running sum would keep the rounding of large forces.
double RecentMean::mean() const noexcept {
    const std::size_t filled = std::min(count_, length_);
    double sum = 0.0;
    for (std::size_t i = 0; i < filled; ++i) {
        sum += values_.at(i);
    }
    return filled == 0 ? 0.0 : sum / static_cast<double>(filled);
}

// Weights of a least-squares line through equidistant values, at the last one.
double RecentMean::lineEnd() const noexcept {
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
        recent_.add(force);
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
    const double ofMean = free_.deviation() / std::sqrt(static_cast<double>(recent_.length()));
    return std::hypot(ofMean, free_.meanDeviation());
}

void SetpointApproach::enter(ApproachPhase phase) noexcept {
    phase_ = phase;
    inPhase_ = 0.0;
}

void SetpointApproach::beginDescent() noexcept {
    recent_ = RecentMean(lineLength(free_.deviation(), plan_.setpoint));
    firstAbove_.reset();
    enter(ApproachPhase::Descent);
}

void SetpointApproach::descend(double timeStep, double force) noexcept {
    if (!std::isfinite(force) || isBlocked()) {
        enter(ApproachPhase::Retract);
        return;
    }
    recent_.add(force);
    if (recent_.isFull()) {
        const double reached = recent_.lineEnd() - free_.mean();
        if (reached >= plan_.setpoint) {
            beginSettling(timeStep);
            return;
        }
        if (reached < kHalf * plan_.setpoint) {
            lastBelow_ = depth_;
        } else if (!firstAbove_) {
            firstAbove_ = depth_;
        }
    }
    depth_ = std::min(depth_ + timeStep * plan_.speed, plan_.maxDescent);
    if (depth_ >= plan_.maxDescent) {
        enter(ApproachPhase::Retract);
    }
}

/// Half of the dwell is for it, at most.
void SetpointApproach::beginSettling(double timeStep) noexcept {
    const double room = kSettlingShare * plan_.dwell / (timeStep * (kMoves + 1));
    recent_ = RecentMean(
        std::min(ticks(std::floor(room)), meanLength(free_.deviation(), plan_.setpoint)));
    firstAbove_ = firstAbove_.value_or(depth_);
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
    recent_.add(force);
    if (!recent_.isFull() || (moves_ == 0 && !takeSlope())) {
        return;
    }
    if (moves_ == kMoves) {
        dwell();
        return;
    }
    const double missing = plan_.setpoint - measuredForce();
    goal_ = std::clamp(depth_ + missing / slope_, halfDepth(), plan_.maxDescent);
    ++moves_;
    recent_ = RecentMean(recent_.length());
}

/// Noise has the last value below half of the setpoint too late, and the first one above it by as
/// much too early.
double SetpointApproach::halfDepth() const noexcept {
    return 0.5 * (lastBelow_ + firstAbove_.value_or(lastBelow_));
}

bool SetpointApproach::takeSlope() noexcept {
    const double rise = measuredForce() - kHalf * plan_.setpoint;
    const double way = depth_ - halfDepth();
    if (!(rise > 0.0)) {  // it was noise
        lastBelow_ = depth_;
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
    recent_ = RecentMean(recent_.length());
    phase_ = ApproachPhase::Dwell;  // since it began to settle
}

void SetpointApproach::retract(double timeStep) noexcept {
    depth_ = std::max(depth_ - timeStep * plan_.speed, 0.0);
    if (depth_ == 0.0) {
        enter(ApproachPhase::Done);
    }
}

}  // namespace asperity
