#pragma once

#include "core/scene/Scene.h"

#include <string>
#include <vector>

namespace asperity {

/// How exactly a tick reckons.
struct TickTier {
    ContactLaw law = ContactLaw::Split;
    SolverTier solver = SolverTier::Newton;
    FootEffort footSearch = FootEffort::Certified;
    DecouplingTier decoupling = DecouplingTier::Estimator;
    bool friction = true;  ///< as in SceneModel, and the rest
    bool torsion = true;
    bool mountTilt = true;
    bool curvature = true;

    bool operator==(const TickTier&) const = default;
    /// For people: "Maugis-Dugdale, table, certified feet, without friction".
    [[nodiscard]] std::string name() const;
};

/// How exactly a picture shows the surface around the contact.
struct FrameTier {
    DeformationTier deformation = DeformationTier::ClosedForm;
    int samples = 97;  ///< of the patch, a side

    /// For people: "closed form, 97 x 97".
    [[nodiscard]] std::string name() const;
};

/// The ways for a tick of this scene to reckon with a force: each law that its sample allows, with
/// each solver but the one afresh and each search for feet, and all other terms; then the scene's
/// own way, and the same with all other terms but one.
[[nodiscard]] std::vector<TickTier> tickTiers(const Scene& scene);

/// All ways for its picture.
[[nodiscard]] std::vector<FrameTier> frameTiers();

[[nodiscard]] SceneModel modelWithTier(SceneModel model, const TickTier& tier);

/// The tier that a model's tick belongs to; terms that its law has no room for count as in.
[[nodiscard]] TickTier tierOf(const SceneModel& model) noexcept;

}  // namespace asperity
