#include "core/haptics/HandPilot.h"

#include <utility>

namespace asperity {

void HandPilot::displace(const Vector3& displacement) {
    journey_.clear();
    target_ += displacement;
}

void HandPilot::setVelocity(const Vector3& velocity) {
    if (!velocity.isZero()) {
        journey_.clear();
    }
    velocity_ = velocity;
}

void HandPilot::follow(HandPath journey) {
    journey_ = std::move(journey);
    journeyTime_ = journey_.front().time;
}

Vector3 HandPilot::advance(double seconds, const HandMapping& mapping) {
    target_ += seconds * velocity_;
    if (traveling()) {
        journeyTime_ += seconds;
        target_ = mapping.handFor(positionAt(journey_, journeyTime_));
        if (journeyTime_ >= journey_.back().time) {
            journey_.clear();
        }
    }
    return target_;
}

}  // namespace asperity
