#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// A tip on a curved sample as the contact laws see it: a tip on a flat one.
struct EffectiveRadius {
    double radius = 0.0;       ///< [m]
    bool tipFits = true;       ///< false: valley about as narrow as the tip or narrower
    bool anisotropic = false;  ///< the two relative curvatures differ by more than a factor of 2
};

/// R_eff = [(1/R + kappa_1)(1/R + kappa_2)]^(-1/2), each factor at least a tenth of 1/R: below, the
/// tip does not fit the valley. A bump has no such bound, however sharp. R_eff is never below
/// kMinTipRadius.
/// Good to a few per cent unless `anisotropic`; valid only if `tipFits`. For values that are no
/// numbers or a tip outside the laws' range `tipFits` is false and the radius is R.
/// @param tipRadius R [m]  @param largest, smallest principal curvatures of the sample, > 0 for a
///        bump [1/m]. Source: docs/theory.md 1.
[[nodiscard]] EffectiveRadius effectiveRadius(double tipRadius, double largest,
                                              double smallest) noexcept;

/// An isotropic linear elastic material.
struct Elastic {
    double youngsModulus = 0.0;  ///< [Pa], > 0
    double poissonRatio = 0.0;   ///< 0 .. 0.5

    bool operator==(const Elastic&) const = default;
};

/// Sample and tip as one pair: what every contact law needs.
struct ContactPair {
    double tipRadius = 0.0;       ///< effective radius R [m]
    double reducedModulus = 0.0;  ///< E* [Pa]
    double workOfAdhesion = 0.0;  ///< w of the pair [J/m^2], >= 0

    bool operator==(const ContactPair&) const = default;
};

/// E* of two bodies [Pa]; infinite where both are rigid, and 0, which no contact law accepts, where
/// one of them is no elastic body. Source: Hertz (1882); docs/theory.md 1.
[[nodiscard]] double reducedModulus(const Elastic& sample, const Elastic& tip) noexcept;

/// The part of the common surface displacement that the sample takes, 0 .. 1 (the tip takes the
/// rest; 0 where reducedModulus() is 0 or infinite). Source: docs/theory.md 4.3, rendering rule
/// (ii).
[[nodiscard]] double sampleShare(const Elastic& sample, const Elastic& tip) noexcept;

/// Outcome of the search for an equilibrium: found, or the reason why not. Each range is far beyond
/// any instrument and near enough that no power of its ends overflows.
enum class ContactStatus : std::uint8_t {
    Solved,
    TipRadiusOutOfRange,      ///< not within 1e-12 .. 1 m
    ModulusOutOfRange,        ///< reduced modulus not within 1e-1 .. 1e15 Pa
    AdhesionOutOfRange,       ///< work of adhesion not within 0 .. 1e3 J/m^2
    StressOutOfRange,         ///< cohesive stress not such that the range w / sigma0 is 1 fm .. 1 m
    FilmThicknessOutOfRange,  ///< neither 0, a half-space, nor within 1e-12 .. 1 m
    PoissonRatioOutOfRange,   ///< of a film, not within 0 .. 0.5
    ConeHalfAngleOutOfRange,  ///< neither 0, no cone, nor within 0.01 .. 1.55 rad
    LawWithoutCone,           ///< a law that takes the tip for a paraboloid, and a cone
    ApproachOutOfRange,       ///< beyond +-1e3 m
    ComplianceOutOfRange,     ///< not within 0 .. 1e6 m/N
};

/// Texts for people: what would have been right.
template <>
inline constexpr auto kEnumTable<ContactStatus> = std::to_array<EnumRow<ContactStatus>>(
    {{ContactStatus::Solved, "ok", "nothing is wrong"},
     {ContactStatus::TipRadiusOutOfRange, "tip_radius_out_of_range",
      "the tip radius must lie between 1e-12 and 1 m"},
     {ContactStatus::ModulusOutOfRange, "modulus_out_of_range",
      "the reduced modulus must lie between 0.1 and 1e15 Pa"},
     {ContactStatus::AdhesionOutOfRange, "adhesion_out_of_range",
      "the work of adhesion must lie between 0 and 1000 J/m^2"},
     {ContactStatus::StressOutOfRange, "cohesive_stress_out_of_range",
      "the range of the cohesive stress, w / sigma0, must lie between 1e-15 and 1 m"},
     {ContactStatus::FilmThicknessOutOfRange, "film_thickness_out_of_range",
      "the film's thickness must lie between 1e-12 and 1 m"},
     {ContactStatus::PoissonRatioOutOfRange, "poisson_ratio_out_of_range",
      "the film's Poisson ratio must lie between 0 and 0.5"},
     {ContactStatus::ConeHalfAngleOutOfRange, "cone_half_angle_out_of_range",
      "the half angle of the tip's cone must be 0 or lie between 0.01 and 1.55 rad"},
     {ContactStatus::LawWithoutCone, "law_without_cone",
      "a law of a paraboloid leaves out the tip's cone: sneddon, jkr_sphere, md_sphere and "
      "split_sphere have it"},
     {ContactStatus::ApproachOutOfRange, "approach_out_of_range",
      "the approach of tip or lever base must lie within 1000 m of first touch"},
     {ContactStatus::ComplianceOutOfRange, "compliance_out_of_range",
      "the lever's compliance must lie between 0 and 1e6 m/N"}});

inline constexpr double kMinTipRadius = 1e-12;  ///< [m]
inline constexpr double kMaxTipRadius = 1.0;    ///< [m]
/// Adhesion below this counts as none [J/m^2].
inline constexpr double kMinAdhesion = 1e-12;

/// Returns the first fault of a pair, or Solved. @param cohesiveStress sigma0 [Pa]
[[nodiscard]] ContactStatus checkPair(const ContactPair& pair, double cohesiveStress) noexcept;

/// Returns the first fault of a film, or Solved. @param thickness [m]; 0: a half-space
[[nodiscard]] ContactStatus checkFilm(double thickness, double poissonRatio) noexcept;

inline constexpr double kMinConeHalfAngle = 0.01;  ///< [rad]
inline constexpr double kMaxConeHalfAngle = 1.55;  ///< [rad]

/// Returns the fault of a tip's cone, or Solved. @param halfAngle [rad]; 0: no cone
[[nodiscard]] ContactStatus checkCone(double halfAngle) noexcept;

/// @throw Error with one sentence where something is wrong with a pair.
/// @param cohesiveStress sigma0 [Pa]
void requirePair(const ContactPair& pair, double cohesiveStress);

/// Softest lever of the laws [m/N].
inline constexpr double kMaxCompliance = 1e6;

/// The lever within the laws' range that is nearest to one of this compliance [m/N]; rigid where
/// that is no number or below 1e-30 m/N.
[[nodiscard]] double nearestCompliance(double compliance) noexcept;

/// Returns the fault of the state asked for, or Solved.
[[nodiscard]] ContactStatus checkRequest(double approach, double compliance) noexcept;

/// Stable state of the tip; with adhesion the force is not a function of the gap alone.
enum class ContactBranch : std::uint8_t {
    Far,     ///< before snap-in: van der Waals attraction at most
    Bonded,  ///< after snap-in: contact, or a cohesive zone without contact
};

/// Region that the tip is in, for logs and people.
enum class TipRegion : std::uint8_t {
    Far,       ///< van der Waals attraction only
    Cohesive,  ///< bonded across a gap
    Contact,   ///< touching over a circle, or just in its middle
};

template <>
inline constexpr auto kEnumTable<TipRegion> = std::to_array<EnumRow<TipRegion>>(
    {{TipRegion::Far, "far"},
     {TipRegion::Cohesive, "cohesive", "cohesive (bonded across a gap)"},
     {TipRegion::Contact, "contact", "in contact"}});

/// State carried from one equilibrium to the next.
struct ContactMemory {
    ContactBranch branch = ContactBranch::Far;
    double coordinate = 0.0;  ///< of the state on its law's curve; 0: none
    /// Of a bonded state, where the law remembers it [m]; 0: not known, the tip comes from deeper.
    double contactRadius = 0.0;
};

/// Memory of a bonded tip whose coordinate on the curve of the law is not known.
inline constexpr ContactMemory kBondedMemory{ContactBranch::Bonded, 0.0, 0.0};

/// One equilibrium of tip and sample along the surface normal.
struct ContactState {
    double force = 0.0;           ///< on the tip, along the outward normal, > 0 repulsive [N]
    double indentation = 0.0;     ///< approach of the undeformed bodies, < 0 is a gap [m]
    double contactRadius = 0.0;   ///< [m]
    double cohesiveRadius = 0.0;  ///< outer radius of the cohesive zone [m]
    double stiffness = 0.0;       ///< d(force)/d(indentation) [N/m]
    double drag = 0.0;            ///< part of the force: of a liquid on the moving tip [N]
    double energyLost = 0.0;      ///< dissipated by a jump that led into this state [J]
    double coordinate = 0.0;      ///< on the law's curve, for ContactMemory
    ContactBranch branch = ContactBranch::Far;
    bool jumped = false;  ///< the force jumped on the way to this state, between branches
    ContactStatus status = ContactStatus::Solved;  ///< else force and lengths are zero

    [[nodiscard]] bool solved() const noexcept { return status == ContactStatus::Solved; }
    [[nodiscard]] TipRegion region() const noexcept {
        if (branch == ContactBranch::Far) {
            return TipRegion::Far;
        }
        const bool acrossGap = cohesiveRadius > 0.0 && !(contactRadius > 0.0);
        return acrossGap ? TipRegion::Cohesive : TipRegion::Contact;
    }
    [[nodiscard]] ContactMemory memory() const noexcept {
        return {branch, coordinate, branch == ContactBranch::Bonded ? contactRadius : 0.0};
    }
};

}  // namespace asperity
