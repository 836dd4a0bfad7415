#pragma once

#include "core/EnumTable.h"
#include "core/scene/SceneModel.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// What the model of a scene may leave out.
enum class ModelTerm : std::uint8_t {
    Adhesion,
    VanDerWaalsTail,      ///< attraction across a gap
    SphereCorrection,     ///< the exact sphere in place of its paraboloid
    FilmBase,             ///< rigid, under a film: the film stiffens
    SampleCurvature,      ///< effective radius at the foot
    Friction,             ///< of the tip on the sample
    Torsion,              ///< of the lever, under a force across it
    MountTilt,            ///< of the lever against the scan
    GlobalSearch,         ///< for feet elsewhere than downhill
    OutsideDisplacement,  ///< of the surface, outside the contact
    HalfSpaceSolve,       ///< on the real topography, in place of the closed form
};

/// Keys are those of scene files, which say one thing of the two last.
template <>
inline constexpr auto kEnumTable<ModelTerm> = std::to_array<EnumRow<ModelTerm>>(
    {{ModelTerm::Adhesion, "adhesion"},
     {ModelTerm::VanDerWaalsTail, "van_der_waals_tail", "van der Waals tail"},
     {ModelTerm::SphereCorrection, "sphere_correction", "sphere correction"},
     {ModelTerm::FilmBase, "film_base", "film's base"},
     {ModelTerm::SampleCurvature, "curvature", "sample curvature"},
     {ModelTerm::Friction, "friction"},
     {ModelTerm::Torsion, "torsion", "lever torsion"},
     {ModelTerm::MountTilt, "mount_tilt", "mount tilt"},
     {ModelTerm::GlobalSearch, "foot_search", "global search"},
     {ModelTerm::OutsideDisplacement, "deformation", "outside displacement"},
     {ModelTerm::HalfSpaceSolve, "deformation", "half-space solve"}});

inline constexpr auto kModelTerms = kValues<ModelTerm>;

/// Whether the contact law has it or not.
[[nodiscard]] bool isOfLaw(ModelTerm term) noexcept;

/// Whether the term is about the picture, not about the force.
[[nodiscard]] bool isOfSurface(ModelTerm term) noexcept;

/// Where a description says it; null for terms that are a matter of its foot search or deformation.
[[nodiscard]] std::optional<bool> TermChoices::*choiceMember(ModelTerm term) noexcept;

/// Whether the description itself says if the term is in.
[[nodiscard]] bool isSettled(ModelTerm term, const SceneDescription& scene) noexcept;

/// Whether no contact law has both: the exact sphere's takes the sample as flat, the film's neither
/// adheres nor is it of the exact sphere.
[[nodiscard]] bool exclude(ModelTerm a, ModelTerm b) noexcept;

/// Whether the sample has what the term is about: adhesion, a film.
[[nodiscard]] bool isPossible(ModelTerm term, const SceneDescription& scene) noexcept;

[[nodiscard]] bool has(const SceneModel& model, ModelTerm term) noexcept;

/// The model less the term, as cheap as that makes it; the same where it is not in.
[[nodiscard]] SceneModel without(SceneModel model, ModelTerm term);

/// The model with the term added, in place of those that exclude it, see exclude().
[[nodiscard]] SceneModel with(SceneModel model, ModelTerm term);

/// The description with all that it leaves open as this model has it, so that it gives the same one
/// again.
[[nodiscard]] SceneDescription settled(SceneDescription scene, const SceneModel& model);

}  // namespace asperity
