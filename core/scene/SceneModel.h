#pragma once

#include "core/contact/SolverTier.h"
#include "core/contact/laws/LawChoice.h"
#include "core/probe/ForceDecoupling.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/SceneDescription.h"
#include "core/surface/deformation/SurfaceDeformation.h"
#include "core/surface/foot/SurfaceFoot.h"

namespace asperity {

/// What the operator's side of a scene reckons with, and how exactly: speed against accuracy. The
/// simulated instrument always reckons with everything.
struct SceneModel {
    LawChoice law;
    SolverTier solver = SolverTier::Newton;
    DecouplingTier decoupling = DecouplingTier::Estimator;
    FootEffort footSearch = FootEffort::Certified;
    DeformationTier deformation = DeformationTier::ClosedForm;
    bool friction = true;   ///< of the tip on the sample
    bool torsion = true;    ///< of the lever, under a force across it
    bool mountTilt = true;  ///< of the lever against the scan's plane
    bool curvature = true;  ///< of the sample at the foot: effective radius
};

/// What the description asks for; where it leaves the choice, all but the half-space.
/// @throw Error as chooseLaw()
[[nodiscard]] SceneModel usualModel(const SceneDescription& scene);

/// Tip, lever and sample as this model takes them.
/// @throw Error naming what the contact law or the lever refuses
[[nodiscard]] ProbeSystem believedSystem(const SceneDescription& scene, const SceneModel& model);

}  // namespace asperity
