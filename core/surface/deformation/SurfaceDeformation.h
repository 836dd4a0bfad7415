#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/surface/RoundTip.h"
#include "core/surface/deformation/DeformationModel.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace asperity {

class BSplineSurface;

/// A piece of the surface around the contact, sampled finely: where it lies at rest and where the
/// tip has moved it. Grids are row-major, bottom row (smallest y) first; world frame [m].
struct SurfacePatch {
    int columns = 0;
    int rows = 0;
    std::vector<Vector3> rest;     ///< undeformed surface points
    std::vector<Vector3> points;   ///< deformed surface points
    std::vector<Vector3> normals;  ///< of the deformed surface, unit, out of the sample

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// Contact between tip and surface; world frame.
struct TipContact {
    Vector3 closest = Vector3::Zero();    ///< of the tip's center on the undeformed surface [m]
    Vector3 normal = Vector3::UnitZ();    ///< of the undeformed surface there, unit
    Vector3 tipCenter = Vector3::Zero();  ///< [m]
    double tipRadius = 0.0;               ///< [m]
    double contactRadius = 0.0;           ///< 0: no contact [m]
    double indentation = 0.0;             ///< < 0 where the surface is drawn up to the tip [m]
    double coneHalfAngle = 0.0;           ///< of the tip [rad]; 0: no cone

    [[nodiscard]] RoundTip tip() const noexcept { return {tipRadius, coneHalfAngle}; }
};

/// Displacement of the surface into the sample at a distance from the contact's axis [m -> m].
using RadialDisplacement = std::function<double(double)>;

/// Displacement of a point of the undeformed surface; world [m].
using DisplacementField = std::function<Vector3(const Vector3&)>;

/// Samples of a patch: a square around the closest point, cut off at the scan's edges.
struct PatchGrid {
    double halfWidth = 0.0;  ///< along x and y [m]
    int samples = 0;         ///< per side, at least 2
};

/// The patch around the contact, deformed. Off the tick: allocates.
///
/// FourPoint and ContactRadius move control points of the surface refined around the contact
/// (spacing about the contact radius, and at most an eighth of it); without contact they move
/// nothing. ContactRadius leaves a step at the contact's rim, since the surface outside does not
/// follow. ClosedForm moves each point by `displacement` against the contact normal, and so does
/// HalfSpace, which where it is solved has a field of its own; the other models do not use it.
/// Source: Vogl, Ma, Sitti (2005), section III; docs/theory.md 4.
/// @throw Error when the contact is not finite, a size is not positive, the grid has fewer than 2
///        or more than kMaxPatchSamples samples a side, or ClosedForm is given no displacement
[[nodiscard]] SurfacePatch deformedPatch(const BSplineSurface& surface, const TipContact& contact,
                                         const PatchGrid& grid, DeformationModel model,
                                         const RadialDisplacement& displacement = {});

/// The patch around the contact, each point moved by a field. @throw Error as above
[[nodiscard]] SurfacePatch deformedPatch(const BSplineSurface& surface, const TipContact& contact,
                                         const PatchGrid& grid, const DisplacementField& field);

inline constexpr int kMaxPatchSamples = 2048;

}  // namespace asperity
