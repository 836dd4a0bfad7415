#include "core/scene/TipValidity.h"

#include "core/contact/ContactState.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/probe/BodySum.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/Scene.h"
#include "core/surface/Curvature.h"
#include "core/surface/HeightMoments.h"
#include "core/surface/RoundTip.h"
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

/// Returns whether smoothing and pixels blur the curvature at the contact point.
bool isUnresolved(const Scene& scene, const ProbeSystem& system, const Vector3& position) noexcept {
    const BSplineSurface& surface = scene.surface;
    const HeightSample middle = surface.at(position.x(), position.y());
    HeightSample sharp = middle;
    const auto sharpenAlong = [&](double pitch, const Vector3& axis) {
        const double smoothing = smoothingVariance(scene.description.sample, pitch);
        const double step = std::sqrt(smoothing + (pitch * pitch));
        const Vector3 before = position - step * axis;
        const Vector3 after = position + step * axis;
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
        const Vector3 position =
            frame_.origin + distance * (direction[0] * frame_.along + direction[1] * frame_.across);
        return (surface_.at(position.x(), position.y()).height - position.z()) * frame_.normal.z();
    }

private:
    const BSplineSurface& surface_;
    TangentFrame frame_;
};

/// Returns whether the contact is wider than the asperity is a paraboloid.
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

/// By how much of its indentation other contacts may lower one until it is said; about 1.5 times as
/// much of its force.
constexpr double kInteraction = 0.05;

/// Returns what the law of the tip's position does not hold for; nothing where no law acts, which
/// saves making it.
ValidityFlags lawValidity(const ProbeSystem& system, const SampleMaterial& material,
                          const TipState& state) noexcept {
    const ContactState& contact = state.contact;
    const Vector3& normal = state.closest.normal;
    const double compliance = normal.dot(system.cantilever.compliance() * normal);
    const bool touches = contact.contactRadius > 0.0;
    ValidityFlags flags;
    if (!touches && !isPulledByFar(contact, compliance)) {
        return flags;
    }
    const ContactModel model = contactModelAt(system, state);
    if (touches) {
        flags.add(contactValidity(model, contact, material));
    }
    flags.add(attractionValidity(model, contact, compliance, flags.has(Validity::ElasticLimit)));
    return flags;
}

/// All but what takes the topography around the contact.
ValidityFlags quickValidity(const Scene& scene, const ProbeSystem& system,
                            const SampleMaterial& material, const TipState& state) noexcept {
    const Vector3& closest = state.closest.point;
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(state.contactRatio, 1.0));
    // An exact shape goes on beyond the window in which it is drawn.
    const bool isDrawn = scene.surface.contains(closest.x(), closest.y());
    flags.set(Validity::OutsideScan, !state.closest.insideScan || !(isDrawn || scene.shape));
    flags.set(Validity::FilledPixel, !scene.surface.isMeasured(closest.x(), closest.y()));
    flags.set(Validity::ClosestPointNotFound, !state.closest.converged);
    flags.set(Validity::NotInEquilibrium, !state.converged || !state.contact.solved());
    flags.set(Validity::FrictionLock, state.locked);
    const bool bonded = state.contact.branch == ContactBranch::Bonded;
    flags.set(Validity::UncertainPixel,
              bonded && scene.certainty.isUncertain(closest.x(), closest.y()));
    flags.set(Validity::Anisotropic, bonded && state.anisotropic);
    flags.set(Validity::NarrowValley, bonded && !state.tipFits);
    flags.set(Validity::SeveralContactPoints, state.points > 1);
    flags.set(Validity::OverlappingContacts, state.overlapping);
    flags.set(Validity::InteractingContacts, state.interaction > kInteraction);
    flags.set(Validity::SearchNotExhaustive, state.mayLackPoint);
    if (state.contact.contactRadius > 0.0) {
        flags.set(
            Validity::VariedMaterial,
            system.field != nullptr &&
                system.field->variesWithin(closest.x(), closest.y(), state.contact.contactRadius));
    }
    flags.set(Validity::LargeDeflection, system.cantilever.isBentTooFar(state.force));
    flags.add(lawValidity(system, material, state));
    return flags;
}

constexpr double kMaxShift = 0.05;    // of the separation
constexpr double kMaxMisread = 0.05;  // of the pull-off force
constexpr double kJkrPullOff = 1.5;   // pi w R

double separationOf(const ContactState& state) noexcept {
    return kContactSeparation - state.indentation;
}

/// Returns whether the tip would be elsewhere if light took its time, as it does.
bool isRetarded(const ContactModel& model, const ContactState& state, double compliance) noexcept {
    if (model.tail() == nullptr || !isPulledByFar(state, compliance)) {
        return false;
    }
    const double separation = separationOf(state);
    const double lost = -model.tail()->attraction().force(separation) * retardedShare(separation);
    return lost * compliance > kMaxShift * separation;
}

/// Largest radius of a flat contact that pulls off with its full strength all over [m], not by a
/// crack from its rim. Source: docs/theory.md 2.11, equation (2.8).
double strengthRadius(const ContactPair& pair, double strength) noexcept {
    return 8.0 * pair.reducedModulus * pair.workOfAdhesion /
           (std::numbers::pi * strength * strength);
}

/// Returns whether JKR would misread w from the pull-off force.
/// @param yields the sample flows under the contact, which stays flat when the load is gone
bool isLimitedByStrength(const ContactModel& model, const ContactState& state,
                         bool yields) noexcept {
    const ContactPair& pair = model.pair();
    if (!isAdhesive(model.law()) || state.branch != ContactBranch::Bonded ||
        pair.workOfAdhesion < kMinAdhesion) {
        return false;
    }
    const double jkr = kJkrPullOff * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
    const double pull = -(state.force + model.meniscusPull());
    if (traitsOf(model.law()).attraction != Attraction::Inside &&
        pull > (1.0 + kMaxMisread) * jkr) {
        return true;
    }
    const double radius = state.contactRadius;
    const double strength = pair.workOfAdhesion / model.cohesiveRange();
    return yields && radius < strengthRadius(pair, strength) &&
           strength * std::numbers::pi * radius * radius > kMaxMisread * jkr;
}

/// Returns whether the sample yields somewhere under the contact.
bool yields(const ContactModel& model, const ContactState& state,
            const SampleMaterial& material) noexcept {
    const double hardness = hardnessOf(material).value;
    return hardness > 0.0 && state.contactRadius > 0.0 &&
           contactPressure(contactProfile(model, state), 0.0) >
               yieldPressure(hardness, material.elastic.poissonRatio);
}

constexpr double kMaxLambdaDmt = 2.5e-4;       // lambda
constexpr double kMinLambdaJkr = 4.8;          // lambda
constexpr double kMaxReach = 0.3;              // of the tip radius
constexpr double kAdhesionOutweighed = 280.0;  // load over pi w R

bool isApart(const ContactState& state) noexcept { return state.branch == ContactBranch::Far; }

/// Radius up to which a tip that is bonded without load is attracted [m]: JKR's contact, the widest
/// of all, and around it where the undeformed gap is within the adhesion's range.
double unloadedReach(const ContactModel& model) noexcept {
    const ContactPair& pair = model.pair();
    const double contact = std::cbrt(6.0) * maugisUnits(pair).radius;
    return std::sqrt((contact * contact) + (2.0 * pair.tipRadius * model.cohesiveRange()));
}

bool reachesTooFar(const ContactModel& model, double reach) noexcept {
    return reach > kMaxReach * model.pair().tipRadius;
}

/// Returns how far from the axis the law's attraction reaches, or will once it has snapped in [m].
double reachOf(const ContactModel& model, const ContactState& state) noexcept {
    return isApart(state) ? unloadedReach(model) : state.cohesiveRadius;
}

bool isWithinRange(const ContactModel& model, const ContactState& state) noexcept {
    return isApart(state) && state.indentation > -model.cohesiveRange();
}

}  // namespace

namespace {

/// The tip where it comes down vertically and touches first.
struct Touch {
    Vector3 tip = Vector3::Zero();  ///< apex [m]
    ClosestPoint foot;
    double effectiveRadius = 0.0;  ///< [m]
};

Touch touchAt(const SampleSurface& sample, const ProbeSystem& system, const Vector2& position,
              double above, ClosestPointTracker& tracker) noexcept {
    constexpr int kSteps = 8;  // down by the distance left, which the gap along z is never below
    const double radius = system.tipRadius();
    Touch touch{.tip = {position.x(), position.y(), above}, .foot = {}};
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 center = touch.tip + Vector3(0.0, 0.0, radius);
        touch.foot = *sample.contactPoints({center, radius}, 0.0, {}, tracker).list.all().begin();
        touch.tip.z() -= touch.foot.distance - radius;
    }
    const PrincipalCurvatures bend =
        system.takesCurvature() ? touch.foot.curvatures : PrincipalCurvatures{};
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
                   const ClosestPoint& foot, double effectiveRadius) noexcept {
    const BodyTraction traction = bodyTraction(system, system.pairAt(foot.point, effectiveRadius));
    if (traction.workOfAdhesion < kMinAdhesion || !isBlunt(system, effectiveRadius)) {
        return 0.0;
    }
    return bodyForce(sample, traction, tip, {&foot.point, 1}, foot.normal).force / traction.pullOff;
}

bool isBluntTip(const BSplineSurface& surface, const ProbeSystem& system) noexcept {
    return system.contact.pair().workOfAdhesion >= kMinAdhesion &&
           anyTouch(surface, system,
                    [&](const Touch& touch) { return isBlunt(system, touch.effectiveRadius); });
}

bool isAttractedBeside(const HeightMoments& sample, const ProbeSystem& system,
                       double tolerance) noexcept {
    return anyTouch(sample.surface(), system, [&](const Touch& touch) {
        return std::abs(shareBeside(sample, system, touch.tip, touch.foot, touch.effectiveRadius)) >
               tolerance;
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
        memory = {.flags =
                      static_cast<std::uint32_t>(asperityValidity(scene, system, state).bits()),
                  .holdFor = kTicks - 1};
    }
    return ValidityFlags(memory.flags);
}

ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                          const SampleMaterial& material, const TipState& state) noexcept {
    ValidityFlags flags = quickValidity(scene, system, material, state);
    flags.add(asperityValidity(scene, system, state));
    return flags;
}

ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                          const SampleMaterial& material, const TipState& state,
                          AsperityMemory& memory) noexcept {
    ValidityFlags flags = quickValidity(scene, system, material, state);
    flags.add(asperityValidity(scene, system, state, memory));
    return flags;
}

bool isPulledByFar(const ContactState& state, double compliance) noexcept {
    return state.branch == ContactBranch::Far &&
           -state.force * compliance > kMaxShift * separationOf(state);
}

ValidityFlags attractionValidity(const ContactModel& model, const ContactState& state,
                                 double compliance, bool yields) noexcept {
    ValidityFlags flags;
    flags.set(Validity::RetardedAttraction, isRetarded(model, state, compliance));
    flags.set(Validity::StrengthLimited, isLimitedByStrength(model, state, yields));
    return flags;
}

bool isBeyondSphere(const ContactModel& model, const ContactState& state) noexcept {
    return !leavesOutCone(model.law()) && model.coneHalfAngle() == 0.0 &&
           state.contactRadius > model.pair().tipRadius * std::cos(kShankHalfAngle);
}

ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                              const SampleMaterial& material) noexcept {
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(state.contactRadius, model.pair().tipRadius));
    flags.set(Validity::ElasticLimit, yields(model, state, material));
    flags.set(Validity::ThinFilm, state.contactRadius > model.widestFilmContact());
    flags.set(Validity::BeyondSphere, isBeyondSphere(model, state));
    flags.set(Validity::LawOutOfRange, leavesLawsRange(model, state));
    return flags;
}

double pairLambda(const ContactModel& model) noexcept {
    const ContactPair& pair = model.pair();
    return transitionParameter(maugisUnits(pair), pair.workOfAdhesion / model.cohesiveRange());
}

bool leavesLawsRange(const ContactModel& model, const ContactState& state) noexcept {
    const ContactPair& pair = model.pair();
    const double unit = maugisUnits(pair).force;
    if (pair.workOfAdhesion < kMinAdhesion || state.force > kAdhesionOutweighed * unit) {
        return false;
    }
    const LawTraits& law = traitsOf(model.law());
    switch (law.attraction) {
    case Attraction::None:
        return true;
    case Attraction::Outside:
        return pairLambda(model) > kMaxLambdaDmt || isWithinRange(model, state) ||
               reachesTooFar(model, unloadedReach(model));
    case Attraction::Inside:
        return pairLambda(model) < kMinLambdaJkr || isWithinRange(model, state) ||
               (!law.sphere && reachesTooFar(model, reachOf(model, state)));
    case Attraction::Zone:
        return law.sphere ? model.coneHalfAngle() == 0.0 && state.cohesiveRadius >= pair.tipRadius
                          : reachesTooFar(model, reachOf(model, state));
    }
    return false;
}

}  // namespace asperity
