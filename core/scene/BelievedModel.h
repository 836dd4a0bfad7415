#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/SimulatedAfm.h"
#include "core/scene/ForceModelOptions.h"
#include "core/scene/SceneDescription.h"

namespace asperity {

/// The contact law for a material of a scene: as chooseLaw(), and a law of JKR where the material
/// has two works of adhesion. @throw Error as chooseLaw()
[[nodiscard]] LawChoice lawFor(const SceneDescription& scene, const SampleMaterial& material);

/// Terms of a material of a scene that depend on time, all of them.
[[nodiscard]] TimeTerms timeTerms(const SceneDescription& scene, const SampleMaterial& material);

/// The contact law of a scene's model before it is fitted, as the scene says or as its materials
/// require, and why. @throw Error as chooseLaw()
[[nodiscard]] LawChoice usualLaw(const SceneDescription& scene);

/// Returns the model that the description asks for; what it leaves open has all but the half-space.
/// @throw Error as chooseLaw()
[[nodiscard]] ForceModelOptions usualModel(const SceneDescription& scene);

/// The description with all that it leaves open as this model has it, so that it gives the same one
/// again.
[[nodiscard]] SceneDescription settled(SceneDescription scene, const ForceModelOptions& model);

/// Tip, lever and sample as this model takes them.
/// @throw Error naming what the contact law or the lever refuses
[[nodiscard]] ProbeSystem believedSystem(const SceneDescription& scene,
                                         const ForceModelOptions& model);

struct Scene;
struct SceneDescription;

/// Tip, lever and sample as a description says that they truly are.
/// @throw Error naming what the contact law or the lever refuses
[[nodiscard]] ProbeSystem trueSystem(const SceneDescription& description);

/// Returns the simulated instrument of a scene: what its description says is true, whatever the
/// model believes.
[[nodiscard]] InstrumentTruth truthOf(const Scene& scene);

}  // namespace asperity
