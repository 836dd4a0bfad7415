#include "core/haptics/SetpointApproach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kNoiseMargin = 6.0;  // setpoint over the deviation of the mean

/// Ticks over which the mean must go; one where there is no noise.
std::size_t meanLength(double deviation, double setpoint) {
    const double ratio = kNoiseMargin * deviation / setpoint;
    const double ticks =
        std::clamp(std::ceil(ratio * ratio), 1.0, static_cast<double>(RecentMean::kMaxLength));
    return static_cast<std::size_t>(ticks);
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
    return free_.deviation() / std::sqrt(static_cast<double>(recent_.length()));
}

void SetpointApproach::enter(ApproachPhase phase) noexcept {
    phase_ = phase;
    inPhase_ = 0.0;
}

void SetpointApproach::beginDescent() noexcept {
    recent_ = RecentMean(meanLength(free_.deviation(), plan_.setpoint));
    enter(ApproachPhase::Descent);
}

void SetpointApproach::descend(double timeStep, double force) noexcept {
    if (!std::isfinite(force) || isBlocked()) {
        enter(ApproachPhase::Retract);
        return;
    }
    recent_.add(force);
    if (recent_.isFull() && recent_.mean() - free_.mean() >= plan_.setpoint) {
        engaged_ = true;
        recent_ = RecentMean(recent_.length());
        enter(ApproachPhase::Dwell);
        return;
    }
    depth_ = std::min(depth_ + timeStep * plan_.speed, plan_.maxDescent);
    if (depth_ >= plan_.maxDescent) {
        enter(ApproachPhase::Retract);
    }
}

void SetpointApproach::retract(double timeStep) noexcept {
    depth_ = std::max(depth_ - timeStep * plan_.speed, 0.0);
    if (depth_ == 0.0) {
        enter(ApproachPhase::Done);
    }
}

}  // namespace asperity
