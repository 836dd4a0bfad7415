#pragma once

#include "core/Progress.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

inline constexpr std::array kDeformationModels{
    DeformationModel::FourPoint, DeformationModel::ContactRadius, DeformationModel::ClosedForm,
    DeformationModel::HalfSpace};

/// Cost of one deformation model, and its error against the reference of its surface, at one state
/// of the tip.
struct DeformationResult {
    std::string material;
    std::string surface;  ///< "flat", "scan"
    DeformationModel model = DeformationModel::ClosedForm;
    double indentation = 0.0;   ///< [m]
    double contactRatio = 0.0;  ///< contact radius over tip radius
    double time = 0.0;          ///< median of one patch [s]; of the half-space, from the one before
    double coldTime = 0.0;      ///< median of one patch from nothing [s]
    bool compared = false;      ///< there is a reference to be compared with
    double errorRms = 0.0;      ///< over the patch, relative to the indentation
    double errorMax = 0.0;      ///< same
    double lawForce = 0.0;      ///< normal force of the contact law [N]
    double ownForce = 0.0;      ///< the half-space's own [N]; the law's for the other models
    std::optional<HalfSpaceAnswer> halfSpace;  ///< of its model
};

struct DeformationPlan {
    double load = 1e-9;  ///< normal force at which surfaces are compared [N]
    int rounds = 9;      ///< timed patches a model
    int samples = 65;    ///< per side of a patch
};

/// Each model on the paper's three materials under the scene's tip, with the law of the exact
/// sphere: on a flat sample, where the closed form is exact and the reference; and in the middle of
/// the scene's scan, where a half-space of finer pixels is the reference as long as it holds.
/// Source of the materials: Vogl, Ma, Sitti (2005), table 1; docs/theory.md 1.
/// @param progress may be null  @throw Canceled
[[nodiscard]] std::vector<DeformationResult>
studyDeformation(const Scene& scene, const DeformationPlan& plan, Progress* progress = nullptr);

}  // namespace asperity
