#include "core/probe/recorded/RecordedAfm.h"

#include "core/surface/closest/ContactPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity {

RecordedAfm::RecordedAfm(std::shared_ptr<const PlayedCurve> curve, const SampleSurface& surface,
                         double tipRadius, const Cantilever& cantilever)
    : curve_(std::move(curve))
    , player_(*curve_)
    , surface_(surface)
    , tipRadius_(tipRadius)
    , cantilever_(cantilever) {}

AfmMeasurement RecordedAfm::exchange(const BaseMotion& target) noexcept {
    const Vector3& base = target.position;
    if (!base.allFinite()) {
        return {.signals = {}, .connected = false};
    }
    if (!hasTouched_) {
        findPlace(base);
    }
    const PlayedForce played = player_.moveTo(base.z() - place_.z());
    hasTouched_ = hasTouched_ || player_.touches();
    const double bending = leverSignals(cantilever_, Vector3(0.0, 0.0, played.force)).bending;
    return {.signals = {.bending = bending, .torsion = 0.0},
            .connected = !played.beyond,
            .extrapolated = played.extrapolated,
            .aside = isAside(base),
            .ended = played.beyond};
}

bool RecordedAfm::isAside(const Vector3& base) const noexcept {
    return (base - place_).head<2>().norm() > kAside * tipRadius_;
}

/// Lowers or lifts the tip straight below the base until it just touches the surface: Newton's
/// steps, far away those of the distance itself, which cannot lead into the sample. Those that one
/// exchange leaves are for the next.
void RecordedAfm::findPlace(const Vector3& base) noexcept {
    constexpr int kSteps = 8;
    constexpr double kTouching = 1e-12;  // of the tip radius
    constexpr double kSteepest = 0.1;    // z of the normal on a flank that the steps follow
    if (isFound_ && base.head<2>() == place_.head<2>()) {
        return;
    }
    place_ = {base.x(), base.y(), isSought_ ? place_.z() : base.z()};
    isSought_ = true;
    isFound_ = false;
    const std::array<SearchGuess, 1> below{SearchGuess{base.x(), base.y(), true}};
    for (int i = 0; i < kSteps && !isFound_; ++i) {
        const Vector3 center = place_ + tipRadius_ * Vector3::UnitZ();
        const ClosestPoint nearest =
            surface_.contactPoints({center, tipRadius_}, 0.0, below, tracker_).list.all().front();
        const double gap = nearest.distance - tipRadius_;
        place_.z() -= gap < tipRadius_ ? gap / std::max(nearest.normal.z(), kSteepest) : gap;
        isFound_ = std::abs(gap) <= kTouching * tipRadius_;
    }
}

}  // namespace asperity
