#include "core/scene/AsperityValidity.h"

#include "core/contact/EffectiveRadius.h"
#include "core/probe/BodySum.h"
#include "core/scene/Scene.h"
#include "core/surface/Curvature.h"
#include "core/surface/HeightMoments.h"
#include "core/surface/TangentFrame.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/sample/SampleSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kMaxChange = 0.1;  // of the effective radius
constexpr double kBluntTip = 1.5;   // tip radius over effective radius
/// Directions around the contact, unit vectors in its plane: six, so that what varies as the first
/// to fifth harmonic of the angle has no part in their mean.
constexpr double kHalfRoot3 = 0.5 * std::numbers::sqrt3;
constexpr std::array<std::array<double, 2>, 6> kDirections{{{1.0, 0.0},
                                                            {0.5, kHalfRoot3},
                                                            {-0.5, kHalfRoot3},
                                                            {-1.0, 0.0},
                                                            {-0.5, -kHalfRoot3},
                                                            {0.5, -kHalfRoot3}}};
constexpr double kShare = 1.0 / static_cast<double>(kDirections.size());
constexpr double kSquare = 1.0 / 12.0;  // variance of a pixel's square, of its side squared

/// Effective radius of a surface's own height and derivatives.
EffectiveRadius radiusOf(const HeightSample& sample, double tipRadius) noexcept {
    const PrincipalCurvatures bend = principalCurvatures(sample);
    return effectiveRadius(tipRadius, bend.largest, bend.smallest);
}

/// Adds what smoothing and pixels took from the middle's slopes and curvatures along one axis.
/// @param blur their variance along it, of the distance of both neighbors squared
void sharpen(HeightSample& sharp, const HeightSample& middle, const HeightSample& before,
             const HeightSample& after, double blur) noexcept {
    const auto lost = [&](double HeightSample::*value) {
        return 0.5 * blur * (before.*value + after.*value - 2.0 * middle.*value);
    };
    for (double HeightSample::*value : {&HeightSample::dx, &HeightSample::dy, &HeightSample::dxx,
                                        &HeightSample::dxy, &HeightSample::dyy}) {
        sharp.*value -= lost(value);
    }
}

/// Variance of the scene's low-pass along an axis [m^2]. @param pitch of a pixel [m]
double smoothingVariance(const SampleDescription& sample, double pitch) noexcept {
    const double length = sample.smoothingLength > 0.0
                              ? sample.smoothingLength
                              : sample.smoothingPixels.value_or(0.0) * pitch;
    return length * length;
}

/// Whether smoothing and pixels blur the curvature at the contact point.
bool isUnresolved(const Scene& scene, const ProbeSystem& system, const Vector3& place) noexcept {
    const BSplineSurface& surface = scene.surface;
    const HeightSample middle = surface.at(place.x(), place.y());
    HeightSample sharp = middle;
    const auto sharpenAlong = [&](double pitch, const Vector3& axis) {
        const double smoothing = smoothingVariance(scene.description.sample, pitch);
        const double step = std::sqrt(smoothing + (pitch * pitch));
        const Vector3 before = place - step * axis;
        const Vector3 after = place + step * axis;
        sharpen(sharp, middle, surface.at(before.x(), before.y()), surface.at(after.x(), after.y()),
                (smoothing + (kSquare * pitch * pitch)) / (step * step));
    };
    sharpenAlong(surface.grid().pitchX, Vector3::UnitX());
    sharpenAlong(surface.grid().pitchY, Vector3::UnitY());
    const double blurred = radiusOf(middle, system.tipRadius()).radius;
    return std::abs(radiusOf(sharp, system.tipRadius()).radius - blurred) > kMaxChange * blurred;
}

/// Heights of the surface over the tangent plane of the contact point.
class Surroundings {
public:
    Surroundings(const Scene& scene, const TipState& state) noexcept
        : surface_(scene.surface)
        , frame_(tangentFrame(state.closest.point, state.closest.normal)) {}

    /// Height above the plane along its normal [m], at a distance [m].
    [[nodiscard]] double height(double distance,
                                const std::array<double, 2>& direction) const noexcept {
        const Vector3 place =
            frame_.origin + distance * (direction[0] * frame_.along + direction[1] * frame_.across);
        return (surface_.at(place.x(), place.y()).height - place.z()) * frame_.normal.z();
    }

private:
    const BSplineSurface& surface_;
    TangentFrame frame_;
};

/// Whether the contact is wider than the asperity is a paraboloid.
bool isBeyondAsperity(const Surroundings& around, const TipState& state) noexcept {
    constexpr double kRim = 0.8546;  // (8/15)^(1/4): what r^4 weighs under a flat punch's pressure
    const double distance = kRim * state.contact.contactRadius;
    double sum = 0.0;
    for (const auto& direction : kDirections) {
        sum += around.height(distance, direction);
    }
    const PrincipalCurvatures& bend = state.closest.curvatures;
    const double square = distance * distance;
    const double left = sum * kShare + 0.25 * (bend.largest + bend.smallest) * square;
    return std::abs(left) > kMaxChange * square / (2.0 * state.effectiveRadius);
}

}  // namespace

namespace {

/// The tip where it comes down vertically and touches first.
struct Touch {
    Vector3 tip = Vector3::Zero();  ///< apex [m]
    ClosestPoint place;
    double effectiveRadius = 0.0;  ///< [m]
};

Touch touchAt(const SampleSurface& sample, const ProbeSystem& system, const Vector2& position,
              double above, ClosestPointTracker& tracker) noexcept {
    constexpr int kSteps = 8;  // down by the distance left, which the gap along z is never below
    const double radius = system.tipRadius();
    Touch touch{.tip = {position.x(), position.y(), above}, .place = {}};
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 center = touch.tip + Vector3(0.0, 0.0, radius);
        touch.place = *sample.contactPoints({center, radius}, 0.0, {}, tracker).list.all().begin();
        touch.tip.z() -= touch.place.distance - radius;
    }
    const PrincipalCurvatures bend =
        system.takesCurvature() ? touch.place.curvatures : PrincipalCurvatures{};
    touch.effectiveRadius = effectiveRadius(radius, bend.largest, bend.smallest).radius;
    return touch;
}

/// Calls with the tip touching a surface at 8 x 8 positions until that returns true; whether it
/// did.
template <class Visitor>
bool anyTouch(const BSplineSurface& surface, const ProbeSystem& system, const Visitor& visitor) {
    constexpr int kSide = 8;
    const double above = surface.bounds().all().highest;
    const SampleSurface sample(surface, SearchEffort::Global);
    ClosestPointTracker tracker;
    for (int i = 0; i < kSide * kSide; ++i) {
        const Vector2 position((0.5 + i % kSide) / kSide * surface.sizeX(),
                               (0.5 + i / kSide) / kSide * surface.sizeY());
        if (visitor(touchAt(sample, system, position, above, tracker))) {
            return true;
        }
    }
    return false;
}

bool isBlunt(const ProbeSystem& system, double effectiveRadius) noexcept {
    return system.tipRadius() > kBluntTip * effectiveRadius;
}

}  // namespace

double shareBeside(const HeightMoments& sample, const ProbeSystem& system, const Vector3& tip,
                   const ClosestPoint& place, double effectiveRadius) noexcept {
    const BodyTraction traction = bodyTraction(system, system.pairAt(place.point, effectiveRadius));
    if (traction.workOfAdhesion < kMinAdhesion || !isBlunt(system, effectiveRadius)) {
        return 0.0;
    }
    return bodyForce(sample, traction, tip, {&place.point, 1}, place.normal).force /
           traction.pullOff;
}

bool isBluntTip(const BSplineSurface& surface, const ProbeSystem& system) noexcept {
    return system.contact.pair().workOfAdhesion >= kMinAdhesion &&
           anyTouch(surface, system,
                    [&](const Touch& touch) { return isBlunt(system, touch.effectiveRadius); });
}

bool isAttractedBeside(const HeightMoments& sample, const ProbeSystem& system,
                       double tolerance) noexcept {
    return anyTouch(sample.surface(), system, [&](const Touch& touch) {
        return std::abs(shareBeside(sample, system, touch.tip, touch.place,
                                    touch.effectiveRadius)) > tolerance;
    });
}

ValidityFlags asperityValidity(const Scene& scene, const ProbeSystem& system,
                               const TipState& state) noexcept {
    ValidityFlags flags;
    if (scene.shape || !system.takesCurvature() || state.contact.branch != ContactBranch::Bonded) {
        return flags;
    }
    const Surroundings around(scene, state);
    flags.set(Validity::UnresolvedCurvature, isUnresolved(scene, system, state.closest.point));
    flags.set(Validity::BeyondAsperity,
              state.contact.contactRadius > 0.0 && isBeyondAsperity(around, state));
    flags.set(Validity::BodyAttraction,
              scene.moments != nullptr && !system.attractsBeside() &&
                  std::abs(shareBeside(*scene.moments, system, state.tip, state.closest,
                                       state.effectiveRadius)) > scene.description.tolerance);
    return flags;
}

ValidityFlags asperityValidity(const Scene& scene, const ProbeSystem& system, const TipState& state,
                               AsperityMemory& memory) noexcept {
    constexpr std::uint32_t kTicks = 8;
    if (state.contact.branch != ContactBranch::Bonded) {
        memory = {};
    } else if (memory.holdFor > 0) {
        --memory.holdFor;
    } else {
        memory = {.flags = asperityValidity(scene, system, state).bits(), .holdFor = kTicks - 1};
    }
    return ValidityFlags(memory.flags);
}

}  // namespace asperity
