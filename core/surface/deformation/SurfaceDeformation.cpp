#include "core/surface/deformation/SurfaceDeformation.h"

#include "core/Error.h"
#include "core/surface/closest/BoxNewton.h"
#include "core/surface/deformation/DisplacementField.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

void requireUsable(const TipContact& contact, const PatchGrid& grid) {
    const bool finite = contact.closest.allFinite() && contact.normal.allFinite() &&
                        contact.tipCenter.allFinite() && std::isfinite(contact.tipRadius) &&
                        std::isfinite(contact.contactRadius) && std::isfinite(contact.indentation);
    if (!finite) {
        throw Error("the contact to be drawn is not finite");
    }
    if (contact.tipRadius <= 0.0 || contact.contactRadius < 0.0) {
        throw Error("the tip radius must be positive and the contact radius not negative");
    }
    if (!std::isfinite(grid.halfWidth) || grid.halfWidth <= 0.0 || grid.samples < 2 ||
        grid.samples > kMaxPatchSamples) {
        throw Error("a patch needs a positive width and 2 to " + std::to_string(kMaxPatchSamples) +
                    " samples a side");
    }
}

/// The undeformed surface on a regular grid in x and y.
SurfacePatch restPatch(const BSplineSurface& surface, const Vector2& center,
                       const PatchGrid& grid) {
    const Box scan = scanBox(surface);
    const Vector2 low = scan.nearest(center - Vector2::Constant(grid.halfWidth));
    const Vector2 high = scan.nearest(center + Vector2::Constant(grid.halfWidth));
    SurfacePatch patch{
        .columns = grid.samples, .rows = grid.samples, .rest = {}, .points = {}, .normals = {}};
    patch.rest.reserve(patch.index(grid.samples, 0));
    for (int row = 0; row < grid.samples; ++row) {
        const double y = std::lerp(low.y(), high.y(), row / (grid.samples - 1.0));
        for (int column = 0; column < grid.samples; ++column) {
            const double x = std::lerp(low.x(), high.x(), column / (grid.samples - 1.0));
            patch.rest.emplace_back(x, y, surface.at(x, y).height);
        }
    }
    return patch;
}

/// Normals of the deformed points from their differences, one-sided at the patch's border.
std::vector<Vector3> normalsOf(const SurfacePatch& patch) {
    std::vector<Vector3> normals;
    normals.reserve(patch.points.size());
    for (int row = 0; row < patch.rows; ++row) {
        const int below = std::max(row - 1, 0);
        const int above = std::min(row + 1, patch.rows - 1);
        for (int column = 0; column < patch.columns; ++column) {
            const int left = std::max(column - 1, 0);
            const int right = std::min(column + 1, patch.columns - 1);
            const Vector3 alongX =
                patch.points[patch.index(row, right)] - patch.points[patch.index(row, left)];
            const Vector3 alongY =
                patch.points[patch.index(above, column)] - patch.points[patch.index(below, column)];
            normals.emplace_back(alongX.normalized().cross(alongY.normalized()).normalized());
        }
    }
    return normals;
}

}  // namespace

DisplacementField displacementField(const BSplineSurface& surface, const TipContact& contact,
                                    DeformationModel model,
                                    const RadialDisplacement& displacement) {
    if (sharesDisplacement(model)) {
        if (!displacement) {
            throw Error("the closed form needs a displacement");
        }
        return closedFormField(contact, displacement);
    }
    if (contact.contactRadius == 0.0) {
        return [](const Vector3&) -> Vector3 { return Vector3::Zero(); };
    }
    return model == DeformationModel::FourPoint ? fourPointField(surface, contact)
                                                : contactRadiusField(surface, contact);
}

SurfacePatch deformedPatch(const BSplineSurface& surface, const TipContact& contact,
                           const PatchGrid& grid, DeformationModel model,
                           const RadialDisplacement& displacement) {
    requireUsable(contact, grid);
    return deformedPatch(surface, contact, grid,
                         displacementField(surface, contact, model, displacement));
}

SurfacePatch deformedPatch(const BSplineSurface& surface, const TipContact& contact,
                           const PatchGrid& grid, const DisplacementField& field) {
    requireUsable(contact, grid);
    SurfacePatch patch = restPatch(surface, contact.closest.head<2>(), grid);
    patch.points.reserve(patch.rest.size());
    for (const Vector3& rest : patch.rest) {
        patch.points.emplace_back(rest + field(rest));
    }
    patch.normals = normalsOf(patch);
    return patch;
}

}  // namespace asperity
