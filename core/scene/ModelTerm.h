#pragma once

#include "core/scene/ForceModelOptions.h"
#include "core/scene/ModelChoices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace asperity {

struct SceneDescription;

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

/// All there is to say of a term: what a scene file and a panel call it, and where it is written.
struct ModelTermTraits {
    ModelTerm term;
    const char* name;  ///< for people
    const char* key;   ///< in scene files
    /// What a scene says of it; null where it is a matter of foot search or deformation.
    std::optional<bool> ModelChoices::*choice = nullptr;
    /// What a model has of it; null where it follows from law, foot search or deformation.
    bool ForceModelOptions::*option = nullptr;
};

/// By term.
inline constexpr std::array kModelTermTraits{
    ModelTermTraits{ModelTerm::Adhesion, "adhesion", "adhesion", &ModelChoices::adhesion},
    ModelTermTraits{ModelTerm::VanDerWaalsTail, "van der Waals tail", "van_der_waals_tail",
                    &ModelChoices::vanDerWaalsTail},
    ModelTermTraits{ModelTerm::SphereCorrection, "sphere correction", "sphere_correction",
                    &ModelChoices::sphereCorrection},
    ModelTermTraits{ModelTerm::FilmBase, "film's base", "film_base", &ModelChoices::filmBase},
    ModelTermTraits{ModelTerm::SampleCurvature, "sample curvature", "curvature",
                    &ModelChoices::curvature, &ForceModelOptions::curvature},
    ModelTermTraits{ModelTerm::Friction, "friction", "friction", &ModelChoices::friction,
                    &ForceModelOptions::friction},
    ModelTermTraits{ModelTerm::Torsion, "lever torsion", "torsion", &ModelChoices::torsion,
                    &ForceModelOptions::torsion},
    ModelTermTraits{ModelTerm::MountTilt, "mount tilt", "mount_tilt", &ModelChoices::mountTilt,
                    &ForceModelOptions::mountTilt},
    ModelTermTraits{ModelTerm::GlobalSearch, "global search", "foot_search"},
    ModelTermTraits{ModelTerm::OutsideDisplacement, "outside displacement", "deformation"},
    ModelTermTraits{ModelTerm::HalfSpaceSolve, "half-space solve", "deformation"},
};

inline constexpr auto kModelTerms = [] {
    std::array<ModelTerm, kModelTermTraits.size()> terms{};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        terms[i] = kModelTermTraits[i].term;
    }
    return terms;
}();

/// Terms that a model simply has or has not, whatever its law.
inline constexpr std::array kSwitchedTerms{ModelTerm::Friction, ModelTerm::Torsion,
                                           ModelTerm::MountTilt, ModelTerm::SampleCurvature};

[[nodiscard]] constexpr const ModelTermTraits& traitsOf(ModelTerm term) noexcept {
    return kModelTermTraits[static_cast<std::size_t>(term)];
}

/// For people: "van der Waals tail".
[[nodiscard]] constexpr const char* nameOf(ModelTerm term) noexcept { return traitsOf(term).name; }

/// As scene files call it: "van_der_waals_tail".
[[nodiscard]] constexpr const char* keyOf(ModelTerm term) noexcept { return traitsOf(term).key; }

/// Whether the contact law has it or not.
[[nodiscard]] constexpr bool isOfLaw(ModelTerm term) noexcept {
    return traitsOf(term).choice != nullptr && traitsOf(term).option == nullptr;
}

/// Whether the term is about the picture, not about the force.
[[nodiscard]] constexpr bool isOfSurface(ModelTerm term) noexcept {
    return term == ModelTerm::OutsideDisplacement || term == ModelTerm::HalfSpaceSolve;
}

/// Whether no contact law has both: the exact sphere's takes the sample as flat, the film's neither
/// adheres nor is it of the exact sphere.
[[nodiscard]] bool exclude(ModelTerm a, ModelTerm b) noexcept;

/// Whether the sample has what the term is about: adhesion, a film.
[[nodiscard]] bool isPossible(ModelTerm term, const SceneDescription& scene) noexcept;

[[nodiscard]] bool has(const ForceModelOptions& model, ModelTerm term) noexcept;

/// The model less the term, as cheap as that makes it; the same where it is not in.
[[nodiscard]] ForceModelOptions without(ForceModelOptions model, ModelTerm term) noexcept;

/// The model with the term added, in place of those that exclude it, see exclude().
[[nodiscard]] ForceModelOptions with(ForceModelOptions model, ModelTerm term) noexcept;

}  // namespace asperity
