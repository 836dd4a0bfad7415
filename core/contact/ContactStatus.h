#pragma once

#include "core/EnumTable.h"
#include "core/contact/Material.h"

#include <cstdint>

namespace asperity {

/// Whether an equilibrium was found, and if not, why. Each range is far beyond any instrument and
/// near enough that no power of its ends overflows.
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

/// For people: what would have been right.
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

/// What is wrong with a pair first, or Solved. @param cohesiveStress sigma0 [Pa]
[[nodiscard]] ContactStatus checkPair(const ContactPair& pair, double cohesiveStress) noexcept;

/// What is wrong with a film first, or Solved. @param thickness [m]; 0: a half-space
[[nodiscard]] ContactStatus checkFilm(double thickness, double poissonRatio) noexcept;

inline constexpr double kMinConeHalfAngle = 0.01;  ///< [rad]
inline constexpr double kMaxConeHalfAngle = 1.55;  ///< [rad]

/// What is wrong with a tip's cone, or Solved. @param halfAngle [rad]; 0: no cone
[[nodiscard]] ContactStatus checkCone(double halfAngle) noexcept;

/// @throw Error with one sentence where something is wrong with a pair.
/// @param cohesiveStress sigma0 [Pa]
void requirePair(const ContactPair& pair, double cohesiveStress);

/// Softest lever of the laws [m/N].
inline constexpr double kMaxCompliance = 1e6;

/// The lever within the laws' range that is nearest to one of this compliance [m/N]; rigid where
/// that is no number or below 1e-30 m/N.
[[nodiscard]] double nearestCompliance(double compliance) noexcept;

/// What is wrong with the state asked for, or Solved.
[[nodiscard]] ContactStatus checkRequest(double approach, double compliance) noexcept;

}  // namespace asperity
