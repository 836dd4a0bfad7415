#include "ui/plot/CycleTrace.h"

#include "ui/plot/ForceDistancePlot.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinSpacing = 10e-12;  ///< [m]: a few ticks, whose noise their mean reduces
constexpr double kJump = 6.0;           ///< standard deviations of a tick
/// Points that are kept of the way to the sample, and of all before the way back from it.
constexpr std::size_t kKeptBefore = CycleTrace::kRoom / 8;
constexpr std::size_t kKeptOfContact = 3 * CycleTrace::kRoom / 4;

double between(double a, double b) { return 0.5 * (a + b); }

}  // namespace

BranchNames branchNames() {
    return {.approach = QString::fromUtf8(nameOf(CurveBranch::Approach)),
            .retract = QString::fromUtf8(nameOf(CurveBranch::Retract))};
}

void CycleTrace::take(const CycleDetector& detector) noexcept {
    const ForceDistancePoint& tick = detector.point();
    const CyclePhase phase = detector.cycle().phase;
    const TracePoint point{.separation = tick.separation,
                           .baseDistance = tick.baseDistance,
                           .force = tick.force,
                           .branch = detector.branch(),
                           .contact = phase == CyclePhase::Contact};
    if (phase != phase_) {
        enter(phase);
    }
    TracePoint* const last = size_ > 0 ? &points_[size_ - 1] : nullptr;
    const bool parted = last == nullptr || ticks_ == 0.0 || last->branch != point.branch ||
                        std::abs(point.baseDistance - firstBase_) >= spacing_ ||
                        std::abs(point.force - last->force) > kJump * tick.sigma;
    if (parted) {
        begin(point);
        return;
    }
    const double share = 1.0 / (ticks_ + 1.0);
    last->separation += share * (point.separation - last->separation);
    last->baseDistance += share * (point.baseDistance - last->baseDistance);
    last->force += share * (point.force - last->force);
    ticks_ += 1.0;
}

void CycleTrace::enter(CyclePhase phase) noexcept {
    const bool touches = phase == CyclePhase::Contact && phase_ == CyclePhase::Apart;
    phase_ = phase;
    ticks_ = 0.0;
    if (touches) {
        while (size_ > kKeptBefore) {
            thin();
        }
        spacing_ = kMinSpacing;
    } else if (phase == CyclePhase::Complete && size_ > kKeptOfContact) {
        thin();
    }
}

void CycleTrace::begin(const TracePoint& point) noexcept {
    if (size_ == kRoom) {
        if (phase_ == CyclePhase::Complete) {
            return;
        }
        thin();
    }
    spacing_ = std::max(spacing_, kMinSpacing);
    points_[size_] = point;
    ++size_;
    ticks_ = 1.0;
    firstBase_ = point.baseDistance;
}

/// Puts neighbors together, two by two.
void CycleTrace::thin() noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; i += 2) {
        TracePoint point = points_[i];
        if (i + 1 < size_) {
            const TracePoint& next = points_[i + 1];
            point.separation = between(point.separation, next.separation);
            point.baseDistance = between(point.baseDistance, next.baseDistance);
            point.force = between(point.force, next.force);
            point.contact = point.contact || next.contact;
        }
        points_[kept] = point;
        ++kept;
    }
    size_ = kept;
    spacing_ *= 2.0;
}

}  // namespace asperity
