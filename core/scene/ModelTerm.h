#pragma once

#include "core/EnumTable.h"
#include "core/scene/ForceModelOptions.h"
#include "core/scene/ModelChoices.h"

#include <array>
#include <cstdint>
#include <optional>

namespace asperity {

struct SceneDescription;

/// Term that the model of a scene may leave out.
enum class ModelTerm : std::uint8_t {
    Adhesion,
    VanDerWaalsTail,      ///< attraction across a gap
    SphereCorrection,     ///< the exact sphere instead of its paraboloid
    FilmBase,             ///< rigid, under a film: the film stiffens
    SampleCurvature,      ///< effective radius at the closest point
    BodyAttraction,       ///< of the tip by the sample beside the contact
    RetractWork,          ///< of adhesion: a contact costs more to open than its closing gave
    Relaxation,           ///< of the sample under load
    Drag,                 ///< of the liquid between tip and sample
    Friction,             ///< of the tip on the sample
    Torsion,              ///< of the lever, under a force across it
    MountTilt,            ///< of the lever against the scan
    GlobalSearch,         ///< for closest points elsewhere than downhill
    OutsideDisplacement,  ///< of the surface, outside the contact
    HalfSpaceSolve,       ///< on the real topography, instead of the closed form
};

/// Traits of a term: what a scene file and a panel call it, and where it is written.
struct ModelTermTraits {
    ModelTerm value;
    const char* key;   ///< in scene files, which say one thing of the two last
    const char* name;  ///< for people
    /// Choice of a scene for it; null where closest point search or deformation decides.
    std::optional<bool> ModelChoices::*choice = nullptr;
    /// Option of a model for it; null where law, closest point search or deformation decides.
    bool ForceModelOptions::*option = nullptr;
    bool usual = true;  ///< whether a model has it as long as nobody knows whether it matters
};

template <>
inline constexpr auto kEnumTable<ModelTerm> = std::to_array<ModelTermTraits>(
    {{ModelTerm::Adhesion, "adhesion", "adhesion", &ModelChoices::adhesion},
     {ModelTerm::VanDerWaalsTail, "van_der_waals_tail", "van der Waals tail",
      &ModelChoices::vanDerWaalsTail},
     {ModelTerm::SphereCorrection, "sphere_correction", "sphere correction",
      &ModelChoices::sphereCorrection},
     {ModelTerm::FilmBase, "film_base", "film's base", &ModelChoices::filmBase},
     {ModelTerm::SampleCurvature, "curvature", "sample curvature", &ModelChoices::curvature,
      &ForceModelOptions::curvature},
     {ModelTerm::BodyAttraction, "body_attraction", "body attraction",
      &ModelChoices::bodyAttraction, &ForceModelOptions::bodyAttraction, false},
     {ModelTerm::RetractWork, "retract_work", "work on retract", &ModelChoices::retractWork,
      &ForceModelOptions::retractWork, false},
     {ModelTerm::Relaxation, "relaxation", "relaxation", &ModelChoices::relaxation,
      &ForceModelOptions::relaxation, false},
     {ModelTerm::Drag, "drag", "drag", &ModelChoices::drag, &ForceModelOptions::drag, false},
     {ModelTerm::Friction, "friction", "friction", &ModelChoices::friction,
      &ForceModelOptions::friction},
     {ModelTerm::Torsion, "torsion", "lever torsion", &ModelChoices::torsion,
      &ForceModelOptions::torsion},
     {ModelTerm::MountTilt, "mount_tilt", "mount tilt", &ModelChoices::mountTilt,
      &ForceModelOptions::mountTilt},
     {ModelTerm::GlobalSearch, "closest_point_search", "global search"},
     {ModelTerm::OutsideDisplacement, "deformation", "outside displacement"},
     {ModelTerm::HalfSpaceSolve, "deformation", "half-space solve"}});

inline constexpr auto kModelTerms = kValues<ModelTerm>;

/// Terms that a model simply has or has not, whatever its law.
inline constexpr std::array kSwitchedTerms{ModelTerm::Friction,       ModelTerm::Torsion,
                                           ModelTerm::MountTilt,      ModelTerm::SampleCurvature,
                                           ModelTerm::BodyAttraction, ModelTerm::RetractWork,
                                           ModelTerm::Relaxation,     ModelTerm::Drag};

/// Those of them that a model has where the sample has something to put in.
inline constexpr std::array kMaterialTerms{ModelTerm::RetractWork, ModelTerm::Relaxation,
                                           ModelTerm::Drag};

[[nodiscard]] constexpr const ModelTermTraits& traitsOf(ModelTerm term) noexcept {
    return *rowOf(term);
}

/// Returns whether the contact law decides if the term is in.
[[nodiscard]] constexpr bool isOfLaw(ModelTerm term) noexcept {
    return traitsOf(term).choice != nullptr && traitsOf(term).option == nullptr;
}

/// Returns whether the term is about the picture, not about the force.
[[nodiscard]] constexpr bool isOfSurface(ModelTerm term) noexcept {
    return term == ModelTerm::OutsideDisplacement || term == ModelTerm::HalfSpaceSolve;
}

/// Returns whether no contact law has both: that of the exact sphere treats the sample as flat; the
/// film's has no adhesion and no exact sphere; two works of adhesion need an edge, which no law
/// with a tail has; a sample that relaxes has no adhesion.
[[nodiscard]] bool exclude(ModelTerm a, ModelTerm b) noexcept;

/// Returns whether the sample has what the term is about: adhesion, a film, a topography around the
/// contact.
[[nodiscard]] bool isPossible(ModelTerm term, const SceneDescription& scene) noexcept;

[[nodiscard]] bool has(const ForceModelOptions& model, ModelTerm term) noexcept;

/// The model less the term, as cheap as that makes it; the same where it is not in.
[[nodiscard]] ForceModelOptions without(ForceModelOptions model, ModelTerm term) noexcept;

/// The model with the term added, instead of those that exclude it, see exclude().
[[nodiscard]] ForceModelOptions with(ForceModelOptions model, ModelTerm term) noexcept;

}  // namespace asperity
