#pragma once

#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/ContactOptions.h"
#include "core/probe/ForceDecoupling.h"
#include "core/surface/closest/ClosestPoint.h"
#include "core/surface/deformation/DeformationModel.h"

namespace asperity {

/// Approximations of a scene's model and settings of its solver: speed against accuracy. The
/// simulated instrument always has everything.
struct ForceModelOptions {
    ContactLaw law = ContactLaw::Split;
    SolverSetting solver = SolverSetting::Newton;
    SearchEffort closestPointSearch = SearchEffort::Certified;
    DecouplingModel decoupling = DecouplingModel::Estimator;
    DeformationModel deformation = DeformationModel::ClosedForm;  ///< of the surface; no force
    bool friction = true;                                         ///< of the tip on the sample
    bool torsion = true;          ///< of the lever, under a force across it
    bool mountTilt = true;        ///< of the lever against the scan's plane
    bool curvature = true;        ///< of the sample at the closest point: effective radius
    bool bodyAttraction = false;  ///< of the tip by the sample beside the contact
    bool retractWork = false;     ///< of adhesion, another one than that on approach
    bool relaxation = false;      ///< of the sample
    bool drag = false;            ///< of the liquid on the tip

    bool operator==(const ForceModelOptions&) const = default;
};

/// The options with all that does not move a force at its default: the deformation, the curvature
/// under a law that takes the sample as flat, attraction beside the contact of a law without a
/// tail. Equal ones give the same force.
[[nodiscard]] ForceModelOptions ofForce(ForceModelOptions options) noexcept;

}  // namespace asperity
