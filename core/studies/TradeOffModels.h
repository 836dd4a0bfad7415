#pragma once

#include "core/scene/ForceModelOptions.h"

#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// How exactly a picture shows the surface around the contact.
struct FrameOptions {
    DeformationModel deformation = DeformationModel::ClosedForm;
    int samples = 97;  ///< of the patch, a side
};

/// For people: "closed form, 97 x 97".
[[nodiscard]] std::string nameOf(const FrameOptions& options);

/// The models that a tick of this scene can take: each law that its sample allows, with each solver
/// but the one afresh and each search for closest points, and all other terms; then the scene's own
/// model, and the same with all other terms but one.
[[nodiscard]] std::vector<ForceModelOptions> tickModels(const Scene& scene);

/// All options for its picture.
[[nodiscard]] std::vector<FrameOptions> frameOptions();

}  // namespace asperity
