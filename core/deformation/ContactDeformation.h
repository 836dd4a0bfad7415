#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/TangentFrame.h"
#include "core/surface/deformation/DisplacementField.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// The rim of a contact about as wide as the tip, or wider, is so sharp that the samples of a
/// picture make teeth of it: over how wide a stretch to either side the displacement is averaged
/// where it is drawn [m]. 0 for narrower contacts, which are drawn exactly.
[[nodiscard]] double rimRounding(const ContactState& contact, double tipRadius) noexcept;

/// A function of the distance from the axis, averaged over a stretch to either side.
template <class Function>
double averagedOverRim(const Function& function, double distance, double stretch) {
    if (stretch == 0.0) {
        return function(distance);
    }
    constexpr int kSteps = 8;
    double sum = 0.0;
    for (int step = 1 - kSteps; step < kSteps; ++step) {
        const double position = std::abs(distance + stretch * step / (kSteps - 1));
        sum += (kSteps - std::abs(step)) * function(position);
    }
    return sum / (kSteps * kSteps);
}

/// A function of the distance from the contact's axis, sampled once and interpolated, at any
/// distance: densest about the contact's rim, where the deformed surface bends most. Between the
/// samples it follows cubics, to about 1e-5 of its largest value beside a kink and far better
/// elsewhere.
class RadialTable {
public:
    /// @param function [m -> m], with a limit far away
    /// @param rim      radius of the contact, or 0 [m]
    /// @param scale    about the distance beyond the rim within which most happens, > 0 [m]
    RadialTable(const std::function<double(double)>& function, double rim, double scale);

    [[nodiscard]] double at(double distance) const;

private:
    static constexpr int kInside = 64;    // intervals up to the rim
    static constexpr int kOutside = 256;  // and beyond it

    double rim_;                                  ///< [m]
    double scale_;                                ///< [m]
    std::array<double, kInside + 1> inside_{};    ///< from the rim to the axis [m]
    std::array<double, kOutside + 1> outside_{};  ///< from the rim to far away [m]
};

struct Scene;

/// Deformation of sample and tip in one state of the believed model, as it is drawn in the window
/// and in pictures, and written to files. The closed form and the half-space share the displacement
/// between the two; the other models move the sample alone. The rim of a contact about as wide as
/// the tip is rounded, see rimRounding(). Off the tick: allocates.
class ContactDeformation {
public:
    /// @param halfSpace what model HalfSpace shows where it is valid and still holds, else the
    /// closed form; or null
    ContactDeformation(const Scene& scene, const TipState& state, DeformationModel model,
                       const HalfSpaceAnswer* halfSpace = nullptr);

    [[nodiscard]] const TipContact& contact() const noexcept { return contact_; }
    /// Returns the displacement of a point of the undeformed surface; world [m].
    [[nodiscard]] const DisplacementField& field() const noexcept { return field_; }
    /// Returns how far the tip's own surface has moved into the tip, at this distance from the
    /// contact's axis [m].
    [[nodiscard]] double tipDisplacement(double distance) const {
        return closedForm_ != nullptr ? (1.0 - share_) * closedForm_->at(distance) : 0.0;
    }

private:
    [[nodiscard]] DisplacementField fieldFor(const BSplineSurface& surface, DeformationModel model,
                                             const HalfSpaceAnswer* halfSpace) const;

    TipContact contact_;
    double share_;  ///< of the sample in the displacement, the tip takes the rest
    /// Displacement of sample and tip together, and the field's. Null where the sample moves alone.
    std::shared_ptr<const RadialTable> closedForm_;
    DisplacementField field_;
};

/// Tip and surface at a state, as they are drawn.
[[nodiscard]] TipContact tipContact(const Scene& scene, const TipState& state);

/// The sample's part of the displacement where the tip is; the tip takes the rest, of models that
/// share it.
[[nodiscard]] double shareOfSample(const Scene& scene, const TipState& state,
                                   DeformationModel model);

struct Scene;

/// The surface around the contact as it is deformed. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch drawnPatch(const Scene& scene, const ContactDeformation& deformation,
                                      const PatchGrid& grid);

/// The same to full precision and with a sharp rim, as studies and tests compare it: each sample by
/// the contact law itself, the half-space solved again; where that is not valid by the closed
/// form. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch exactPatch(const Scene& scene, const TipState& state,
                                      DeformationModel model, const PatchGrid& grid);

/// The surface as a valid answer of the half-space has it. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch halfSpacePatch(const Scene& scene, const HalfSpaceAnswer& answer,
                                          const PatchGrid& grid);

/// Returns the closest point once the surface has moved, world [m].
[[nodiscard]] Vector3 displacedPoint(const Scene& scene, const TipState& state,
                                     DeformationModel model);

struct Scene;

/// Gap and pressure between tip and sample at one state of the believed model, at positions of the
/// surface at rest. Of several closest points it is the main one. Source: docs/theory.md 4.
class ContactField {
public:
    /// @param scene     outlives the field
    /// @param halfSpace whose pressure is taken where the scene asks for the half-space and the
    ///                  answer still holds, else that of the contact law; or null
    ContactField(const Scene& scene, const TipState& state,
                 const HalfSpaceAnswer* halfSpace = nullptr);

    /// Distance between the deformed bodies along the contact's normal, >= 0, 0 in contact; not a
    /// number where the tip is not above the position [m].
    /// @param rest    of the surface at rest [m]
    /// @param sample  its displacement into the sample [m]
    /// @param tip     displacement of the tip's surface there, into the tip [m]
    [[nodiscard]] double gap(const Vector3& rest, double sample, double tip) const noexcept;
    /// On the sample, > 0 compression [Pa]: as contactPressure(), or the half-space's.
    [[nodiscard]] double pressure(const Vector3& rest) const noexcept;
    /// Returns whether the pressure is the half-space's.
    [[nodiscard]] bool isHalfSpace() const noexcept { return pixels_ != nullptr; }

private:
    TipContact contact_;
    CohesiveContact profile_;
    double reach_;  ///< of the tip from the contact's axis [m]
    TangentFrame frame_;
    std::shared_ptr<const PixelField> pixels_;  ///< pressures of the half-space
};

struct Scene;

/// Position and size of a section.
struct SectionPlane {
    double azimuth = 0.0;          ///< of the vertical plane through the tip's axis, from x [rad]
    double halfWidth = 0.0;        ///< seen on each side of `middle` [m]
    double middle = 0.0;           ///< of what is seen, along the plane from the tip's axis [m]
    int samples = 401;             ///< along the surface, at least 2
    double tipHeight = 0.0;        ///< of the tip's outline above the apex [m]
    double paraboloidReach = 0.0;  ///< above 0: the tip is a paraboloid to here, else a sphere [m]
};

/// Tip and sample in a vertical plane through the tip's axis. Points are (along the plane from the
/// tip's axis, world z) [m]. The surface moves along the contact's normal: on a slope partly out of
/// the plane, and the section shows what lies in it before and after of the same points.
struct ContactSection {
    Vector2 axis = Vector2::Zero();        ///< of the tip, world x, y [m]
    Vector2 direction = Vector2::UnitX();  ///< of the plane, unit
    std::vector<Vector2> rest;             ///< the undeformed surface, as far as the scan reaches
    std::vector<Vector2> deformed;         ///< the same points as they have moved
    std::vector<Vector2> tip;              ///< outline of the deformed tip, from left to right
    std::optional<std::array<Vector2, 2>> rim;  ///< ends of the contact; none without contact
    Vector2 contact = Vector2::Zero();          ///< where the contact's axis meets the surface

    /// World position of a point along the plane, on no height [m].
    [[nodiscard]] Vector2 positionAt(double along) const { return axis + along * direction; }
};

/// @param deformation of this scene and state
[[nodiscard]] ContactSection contactSection(const Scene& scene,
                                            const ContactDeformation& deformation,
                                            const SectionPlane& plane);

}  // namespace asperity
