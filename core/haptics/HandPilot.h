#pragma once

#include "core/haptics/HandPath.h"

#include <utility>

namespace asperity {

/// Turns what mouse and keyboard ask for into a place for the hand, once a frame. All lengths are
/// those of the hand.
class HandPilot {
public:
    explicit HandPilot(Vector3 start) : target_(std::move(start)) {}

    /// The mouse moved by so much. Ends a journey.
    void displace(const Vector3& displacement);
    /// Keys are held that move the hand so fast [m/s]. A velocity ends a journey.
    void setVelocity(const Vector3& velocity);
    /// Goes where the path goes, seen from where the hand is now.
    void follow(HandPath journey);
    [[nodiscard]] bool travelling() const noexcept { return !journey_.empty(); }

    /// Where the hand shall be after a frame of so many seconds.
    Vector3 advance(double seconds);

private:
    Vector3 target_;
    Vector3 velocity_ = Vector3::Zero();
    HandPath journey_;
    double journeyTime_ = 0.0;  ///< [s]
};

}  // namespace asperity
