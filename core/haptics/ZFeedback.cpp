#include "core/haptics/ZFeedback.h"

#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kContactShare = 0.1;  // of the setpoint
constexpr double kRestShare = 0.01;    // of an error, corrected in a tick at rest
constexpr double kSlopeStep = 0.02;    // of the setpoint, over which the series stiffness is taken
constexpr double kSoftest = 1e-4;      // share that is planned for

/// Stiffness of lever and contact in series over the lever's, as the scene expects it at a force.
double seriesShareAt(const Scene& scene, const Vector3& base, double force) {
    const double step = kSlopeStep * force;
    const double way = expectedDepth(scene, base, force + step) - expectedDepth(scene, base, force);
    const double share = scene.belief.cantilever.compliance()(2, 2) * step / way;
    return way > 0.0 ? std::clamp(share, kSoftest, 1.0) : 1.0;
}

}  // namespace

FeedbackPlan planFeedback(const Scene& scene, const Vector3& base, double setpoint,
                          double freeForce) {
    const double clearance =
        waitingPosition(scene, base.head<2>()).z() - touchHeight(scene, base.x(), base.y());
    const double room = clearance + 2.0 * expectedDepth(scene, base, setpoint);
    return {.setpoint = setpoint,
            .freeForce = freeForce,
            .stiffness = 1.0 / scene.belief.cantilever.compliance()(2, 2),
            .seriesShare = seriesShareAt(scene, base, setpoint),
            .lowest = -scene.surface.heightScale() - room,
            .highest = scene.surface.heightScale() + room,
            .axis = bendingAxis(scene.belief.cantilever)};
}

double ZFeedback::advance(double timeStep, double force, double height, double gain,
                          bool moves) noexcept {
    const double above = force - plan_.freeForce;
    const bool touches = above >= kContactShare * plan_.setpoint;
    const bool follows = wanted_ == height_ || height != height_;
    height_ = height;
    error_ = above - plan_.setpoint;
    const double missing = error_ / plan_.stiffness;
    const double pole = 1.0 - std::sqrt(1.0 - plan_.seriesShare * gain);
    const double learned = pole * pole / plan_.seriesShare * missing;
    speed_ = touches && follows && moves ? speed_ + learned : 0.0;
    lost_ = touches ? 0.0 : lost_ + timeStep;
    const bool rests = touches && !moves;
    const double share = rests ? std::min(gain, kRestShare / plan_.seriesShare) : gain;
    const double wanted = height + share * missing + speed_;
    wanted_ = std::clamp(wanted, plan_.lowest, plan_.highest);
    if (wanted_ != wanted) {
        state_ = FeedbackState::RangeLeft;
    } else {
        state_ = lost_ < kContactTimeout ? FeedbackState::Holding : FeedbackState::ContactLost;
    }
    return wanted_;
}

FeedbackDevice::FeedbackDevice(std::unique_ptr<HapticDevice> lateral, const FeedbackPlan& plan,
                               double height, double positionGain)
    : lateral_(std::move(lateral))
    , feedback_(plan)
    , stiffness_(plan.stiffness)
    , axis_(plan.axis)
    , freeForce_(plan.freeForce)
    , positionGain_(positionGain)
    , force_(plan.freeForce + plan.setpoint)
    , height_(height)
    , setpoint_(plan.setpoint) {}

DeviceState FeedbackDevice::advance(double timeStep) noexcept {
    if (!std::exchange(started_, true)) {
        position_ = lateral_->advance(timeStep).position;
        return {.position = position_};
    }
    if (std::isfinite(force_) && std::isfinite(height_)) {
        feedback_.setSetpoint(setpoint_);
        const double height = feedback_.advance(timeStep, force_, height_, gain_, moves_);
        position_.z() += (height - height_) / positionGain_;
        error_ = feedback_.error();
        state_ = feedback_.state();
    }
    if (lateral_->piloted() == nullptr && feedback_.state() != FeedbackState::Holding) {
        stopped_ = true;
    }
    moves_ = false;
    if (!stopped_) {
        followAlong(lateral_->advance(timeStep).position, timeStep);
    }
    return {.position = position_};
}

void FeedbackDevice::followAlong(const Vector3& target, double timeStep) noexcept {
    Vector2 way = target.head<2>() - position_.head<2>();
    if (lateral_->piloted() != nullptr) {
        const double step = setpoint_ / stiffness_ / positionGain_;
        maxSpeed_ = step / timeStep;
        const double most = feedback_.error() > setpoint_ ? 0.0 : step;
        way *= way.norm() > most ? most / way.norm() : 1.0;
    }
    position_.head<2>() += way;
    moves_ = !way.isZero(0.0);
}

void FeedbackDevice::observe(const TickOutput& output) noexcept {
    force_ = axis_.dot(output.estimate.force);
    height_ = output.base.position.z();
    lateral_->observe(output);
}

void FeedbackDevice::hold(double setpoint, double gain) noexcept {
    setpoint_ = setpoint;
    gain_ = gain;
}

}  // namespace asperity
