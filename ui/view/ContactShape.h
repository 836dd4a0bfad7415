#pragma once

#include "core/deformation/ContactDeformation.h"
#include "core/surface/deformation/SurfaceDeformation.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <vector>

namespace asperity {

struct Scene;

/// The surface around the contact, as ContactDeformation has it for one tick of the model: sampled
/// most finely at the contact, and at rest along the border of its rectangle, where it joins the
/// surface around it. Sides on the scan's edge join nothing: there the surface moves as it does
/// inside. World frame; derived afresh for every picture.
class ContactShape {
public:
    /// @param area    rectangle to sample
    /// @param samples   along each side, at least 3
    /// @param halfSpace what model HalfSpace shows where it still holds, else the closed form; or
    /// null
    ContactShape(const Scene& scene, const TipState& state, const ScanWindow& area, int samples,
                 const HalfSpaceAnswer* halfSpace = nullptr);
    ~ContactShape() = default;
    ContactShape(const ContactShape&) = delete;
    ContactShape& operator=(const ContactShape&) = delete;

    /// Rest and deformed points; the normals are those of the surface at rest.
    [[nodiscard]] const SurfacePatch& patch() const { return patch_; }
    /// Displacement of each sample into the surface [m].
    [[nodiscard]] const std::vector<double>& displacements() const { return displacements_; }
    [[nodiscard]] double largestDisplacement() const;  ///< magnitude [m]
    [[nodiscard]] double lowest() const;               ///< height of the deformed surface [m]

    [[nodiscard]] const ScanWindow& area() const { return area_; }  ///< that is sampled
    /// Returns the deformed position of a point of the surface at rest [m].
    [[nodiscard]] Vector3 moved(const Vector3& rest) const;
    /// Returns how far the tip's own surface has moved into the tip, at this distance from the
    /// contact's axis [m].
    [[nodiscard]] double tipDisplacement(double distance) const {
        return deformation_.tipDisplacement(distance);
    }

    /// Between tip and surface, along the contact's axis; not a number beside the tip [m].
    /// @param displacement of that position into the sample [m]
    [[nodiscard]] double gap(const Vector3& rest, double displacement) const;
    /// On the surface, > 0 compression [Pa].
    [[nodiscard]] double pressure(const Vector3& rest) const { return field_.pressure(rest); }

    /// Unit vector out of the sample, along the contact's axis.
    [[nodiscard]] const Vector3& outward() const { return contact().normal; }
    [[nodiscard]] const TipContact& contact() const { return deformation_.contact(); }
    /// Returns the point where the contact's axis meets the deformed surface [m].
    [[nodiscard]] Vector3 contactPoint() const;

private:
    void sample(const BSplineSurface& surface, int samples);
    [[nodiscard]] double room() const;
    [[nodiscard]] double fade() const;
    [[nodiscard]] double blend(double x, double y) const;

    ScanWindow area_;
    ScanWindow rest_;  ///< where the surface is at rest: area_, without end beyond the scan's edges
    ContactDeformation deformation_;
    ContactField field_;
    SurfacePatch patch_;
    std::vector<double> displacements_;
};

/// The tip so far above that position that nothing touches and nothing pulls: a surface at rest.
[[nodiscard]] TipState atRest(TipState state);

/// Returns whether the model's state can be drawn completely.
[[nodiscard]] bool isDrawable(const TipState& state);

}  // namespace asperity
