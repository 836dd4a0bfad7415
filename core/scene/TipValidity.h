#pragma once

#include "core/Vector.h"
#include "core/contact/laws/ContactModel.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/Validity.h"

#include <cstdint>

namespace asperity {

class BSplineSurface;
class HeightMoments;
struct ClosestPoint;
struct ProbeSystem;
struct SampleMaterial;
struct Scene;
struct TipState;

/// Returns where the topography under a tip is not what one effective radius makes of it. Nothing
/// for exact shapes and models without the sample's curvature. No allocation, at most some 100
/// look-ups of the surface.
///
/// - curvature unresolved: what smoothing and pixels have blurred, to first order l^2/2 times the
///   Laplacian (l^2: the variance of the low-pass and of a pixel), changes R_eff by more than a
///   tenth;
/// - contact beyond the asperity: along the contact's rim the surface leaves the paraboloid of the
///   contact point, averaged over all directions and at the radius that weighs as the contact's
///   pressure does, by more than a tenth of the gap r^2/(2 R_eff) there;
/// - attraction of the sample beside it: shareBeside() exceeds the scene's tolerance where the
///   model leaves it out. What other contact points carry is not taken off.
///
/// Each is a ratio: lengths, forces and energies scaled together change nothing, but for D0, the
/// atomic separation of two solids.
/// Source: docs/theory.md 1.1, 3.8.
[[nodiscard]] ValidityFlags asperityValidity(const Scene& scene, const ProbeSystem& system,
                                             const TipState& state) noexcept;

/// Attraction of a tip by the sample beside its contact, see bodyForce(), over the pull-off force
/// 1.5 pi w R_eff; < 0: it pulls. Sought where R is more than 1.5 R_eff: below, the law's tail has
/// all but a twentieth of it.
/// @param tip apex [m] @param foot its contact
[[nodiscard]] double shareBeside(const HeightMoments& sample, const ProbeSystem& system,
                                 const Vector3& tip, const ClosestPoint& foot,
                                 double effectiveRadius) noexcept;

/// Returns whether the tip adheres and is more than 1.5 times as blunt as the contact at any of 8 x
/// 8 positions where it comes down on the scan.
[[nodiscard]] bool isBluntTip(const BSplineSurface& surface, const ProbeSystem& system) noexcept;

/// Returns whether shareBeside() exceeds a tolerance at any of these: whether a scene has the term
/// before its model is fitted.
[[nodiscard]] bool isAttractedBeside(const HeightMoments& sample, const ProbeSystem& system,
                                     double tolerance) noexcept;

/// State that asperityValidity() passes from tick to tick. Its look-ups cost a tenth of a tick, and
/// flags are not read a thousand times a second: they are made in the first tick of a contact and
/// in every eighth after it.
struct AsperityMemory {
    std::uint32_t flags = 0;    ///< bits of the last flags, all in the lower half
    std::uint32_t holdFor = 0;  ///< further ticks of the contact; 0: none is known

    bool operator==(const AsperityMemory&) const = default;
};

/// The same for one tick of many, at most seven ticks old.
[[nodiscard]] ValidityFlags asperityValidity(const Scene& scene, const ProbeSystem& system,
                                             const TipState& state,
                                             AsperityMemory& memory) noexcept;

/// Returns what the state of a tip on the scan does not hold for, from the state alone, without
/// signals or an estimate. No allocation.
/// @param system that the state is of: what is believed, or what is true
/// @param material of that system
[[nodiscard]] ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                                        const SampleMaterial& material,
                                        const TipState& state) noexcept;
/// The same for one tick of many, see AsperityMemory.
[[nodiscard]] ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                                        const SampleMaterial& material, const TipState& state,
                                        AsperityMemory& memory) noexcept;

/// Returns whether attraction across a gap moves a tip on its lever by more than a twentieth of the
/// separation: where not, retardation does not matter. @param compliance along the normal [m/N]
[[nodiscard]] bool isPulledByFar(const ContactState& state, double compliance) noexcept;

/// Returns what a law's attraction does not hold for at one of its states: retardation, which the
/// tail neglects, and adhesion that is limited by strength. No allocation.
///
/// Retarded: the tail's lost share would let the lever move the tip by more than a twentieth of the
/// separation.
///
/// Limited by strength: a JKR reading of pull-off, w = 2 F / (3 pi R), would be wrong by more than
/// a twentieth. It is where the tip is pulled by more than 1.05 times JKR's 1.5 pi w R, a meniscus
/// taken off: lambda is below 1.23 then, and more than half of the interface's strength pulls at
/// pull-off. And it is after a preload under which the sample yields, if the contact is so small
/// that, left flat, it parts with its full strength all over: that pull-off grows with the preload.
/// @param compliance of the lever along the normal [m/N]
/// @param yields     the sample yields in this state: flag ElasticLimit of contactValidity()
/// Source: docs/theory.md 2.5, 2.11, 3.7.
[[nodiscard]] ValidityFlags attractionValidity(const ContactModel& model, const ContactState& state,
                                               double compliance, bool yields) noexcept;

/// Returns what a contact law does not hold for at one of its states on a material: large contact,
/// elastic limit, thin film, law out of range (leavesLawsRange()). No allocation.
///
/// The elastic limit is the pressure in the middle at which yield begins, yieldPressure(), by the
/// stated hardness or by an estimate, hardnessOf().
/// A film is thin for laws on a half-space where it makes the contact 5 % stiffer, by the exact
/// solution for the film's Poisson ratio (a/t = 0.042 for 0.5, 0.061 for 0); for `hertz_film` from
/// a/t = 2 on, the end of the reference. Source: docs/theory.md 2.10, 4.4.
[[nodiscard]] ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                                            const SampleMaterial& material) noexcept;

/// Returns whether a sphere without shank touches so widely that the usual shank would touch, too.
[[nodiscard]] bool isBeyondSphere(const ContactModel& model, const ContactState& state) noexcept;

/// Returns whether a contact law leaves out what acts on the tip at one of its states: adhesion,
/// its range, or the curvature of a sphere beyond that of its paraboloid. No allocation.
///
/// - without adhesion (`hertz`, `sneddon`, `hertz_film`): adhesive pairs below 280 pi w R of load,
///   where adhesion changes the contact radius by more than 5 %;
/// - `dmt`: lambda above 2.5e-4, where the ring of attraction, by lifting the sample by 1.5
///   sqrt(lambda) units, changes the force at a given indentation by 5 % (2.5, 2.7);
/// - `jkr`, `jkr_sphere`: lambda below 4.8 (1 % of the unloaded radius);
/// - all three, while apart, within the range of adhesion, which they do not have;
/// - `jkr`, `md`, `split`: attraction beyond 0.3 R of the axis, where the gap under the paraboloid
///   is 2.3 % narrower than under the sphere; while apart, and `dmt` always, tips whose attraction
///   reaches so far when they are bonded without load;
/// - `md_sphere`, `split_sphere` without a cone: attraction up to the sphere's equator.
///
/// The range of adhesion is that of the model, ContactModel::cohesiveRange().
/// Source: docs/theory.md 2.4, 2.5, 2.9, 4.4.
[[nodiscard]] bool leavesLawsRange(const ContactModel& model, const ContactState& state) noexcept;

/// Returns the transition parameter of an adhesive pair, also where its law takes no part in it.
[[nodiscard]] double pairLambda(const ContactModel& model) noexcept;

}  // namespace asperity
