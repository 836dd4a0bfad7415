#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/fidelity/SceneNeeds.h"

namespace asperity {

/// What a scene and a run of it have of a term of the force:
///
/// - adhesion: the largest pull and the largest push at the tip [N];
/// - van der Waals tail: the transition parameter;
/// - exact sphere, film's base: the widest contact, in tip radii and in film thicknesses;
/// - curvature of the sample, global search: the largest of sample and of hollows over the tip's;
///   infinite for the search on a shape, which may come near at several places;
/// - body attraction: the largest force of it [N];
/// - friction: coefficient and shear strength [Pa];
/// - torsion: how the tip yields across the lever, over its yielding along z;
/// - tilt: of the mount [rad].
/// @param scene has the model of the run, the term in
[[nodiscard]] TermFact factOf(ModelTerm term, const Scene& scene, const ModelRun& run);

}  // namespace asperity
