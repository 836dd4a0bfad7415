#pragma once

#include "core/contact/ContactModel.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <string>
#include <vector>

namespace asperity {

/// One choice of speed against accuracy.
struct FidelityTier {
    ContactLaw law = ContactLaw::Split;
    DeformationTier deformation = DeformationTier::ClosedForm;

    /// For people: "Maugis-Dugdale, closed form".
    [[nodiscard]] std::string name() const;
};

/// For people: "four points", "contact radius", "closed form".
[[nodiscard]] const char* nameOf(DeformationTier deformation) noexcept;

/// All tiers that are offered, cheapest law first; the last one is the reference.
[[nodiscard]] std::vector<FidelityTier> fidelityTiers();

/// The scene with the believed contact law of a tier; the truth stays what it is.
[[nodiscard]] Scene sceneWithTier(Scene scene, const FidelityTier& tier);

}  // namespace asperity
