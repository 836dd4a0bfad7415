#include "core/experiment/Perception.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kFrameTime = 1.0 / 60.0;  // of the window [s]
constexpr double kAdaptation = 0.3;        // in which a hand gets used to a force [s]

}  // namespace

OperatorSight::OperatorSight(const OperatorTraits& person, double scale, const Vector3& lineOfSight)
    : person_(person)
    , scale_(scale)
    , lineOfSight_(lineOfSight)
    , length_(static_cast<std::size_t>(std::ceil(person.sightTime / kFrameTime)) + 1) {
    frames_.reserve(length_);
}

void OperatorSight::show(const ShownMoment& moment, double timeStep) {
    sinceFrame_ += timeStep;
    if (!frames_.empty() && sinceFrame_ < kFrameTime) {
        return;
    }
    sinceFrame_ = 0.0;
    if (frames_.size() < length_) {
        frames_.push_back(moment);
        newest_ = frames_.size() - 1;
    } else {
        newest_ = (newest_ + 1) % frames_.size();
        frames_[newest_] = moment;
    }
}

/// The oldest frame that is kept.
const ShownMoment& OperatorSight::seen() const {
    return frames_.size() < length_ ? frames_.front() : frames_[(newest_ + 1) % frames_.size()];
}

Vector3 OperatorSight::look(Random& random) const {
    const ShownMoment& moment = seen();
    const double sigma = person_.acuity / scale_ * (moment.hidden ? person_.hiddenFactor : 1.0);
    Vector3 error(random.normal(), random.normal(), random.normal());
    error += (person_.depthFactor - 1.0) * error.dot(lineOfSight_) * lineOfSight_;
    return moment.tip + sigma * error;
}

void OperatorTouch::feel(const Vector3& force, double timeStep) {
    if (since_ >= 0.0) {
        since_ += timeStep;
        noticed_ = noticed_ || since_ >= person_.touchTime;
    }
    const double least = std::max(person_.leastForce, person_.forceShare * usual_.norm());
    if (since_ < 0.0 && (force - usual_).norm() > least) {
        since_ = 0.0;
    }
    usual_ += std::min(1.0, timeStep / kAdaptation) * (force - usual_);
}

bool OperatorTouch::takeNotice() {
    if (!noticed_) {
        return false;
    }
    noticed_ = false;
    since_ = -1.0;
    return true;
}

}  // namespace asperity
