#include "core/haptics/coupling/PassivityObserver.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kLeakTime = 0.5;     // [s]
constexpr double kTolerated = 10e-3;  // [J]: lever and contact store up to 3 mJ at 3 N

}  // namespace

// The force of this very tick acts from now on: without a delay it waits in the ring for one tick.
PassivityObserver::PassivityObserver(double stiffness, double timeStep, double delay)
    : stiffness_(stiffness)
    , keptShare_(std::exp(-timeStep / kLeakTime))
    , sent_(1 + static_cast<std::size_t>(std::lround(delay / timeStep)), Vector3::Zero()) {}

void PassivityObserver::observe(const Vector3& device, const Vector3& force) noexcept {
    const Vector3 acting = sent_[oldest_];
    const Vector3 motion = started_ ? Vector3(device - device_) : Vector3::Zero();
    const double taken = -acting.dot(motion) - (stored(acting) - stored(acting_));
    energy_ = keptShare_ * energy_ + taken;
    sent_[oldest_] = force;
    oldest_ = (oldest_ + 1) % sent_.size();
    acting_ = acting;
    device_ = device;
    started_ = true;
}

bool PassivityObserver::active() const noexcept { return energy_ < -kTolerated; }

double PassivityObserver::stored(const Vector3& force) const noexcept {
    return force.squaredNorm() / (2.0 * stiffness_);
}

}  // namespace asperity
