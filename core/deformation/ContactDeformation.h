#pragma once

#include "core/deformation/HalfSpaceAnswer.h"
#include "core/deformation/RadialTable.h"
#include "core/surface/deformation/DisplacementField.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <memory>

namespace asperity {

struct Scene;

/// How one state of the believed model deforms sample and tip: what the window draws, what pictures
/// show and what files hold. The closed form and the half-space share the displacement between the
/// two; the other models move the sample alone. The rim of a contact about as wide as the tip is
/// rounded, see rimRounding(). Off the tick: allocates.
class ContactDeformation {
public:
    /// @param halfSpace what model HalfSpace shows where it is valid and still holds, else the
    /// closed form; or null
    ContactDeformation(const Scene& scene, const TipState& state, DeformationModel model,
                       const HalfSpaceAnswer* halfSpace = nullptr);

    [[nodiscard]] const TipContact& contact() const noexcept { return contact_; }
    /// By how much a point of the surface at rest moves; world [m].
    [[nodiscard]] const DisplacementField& field() const noexcept { return field_; }
    /// By how much the tip's own surface has moved into the tip, at this distance from the
    /// contact's axis [m].
    [[nodiscard]] double tipDisplacement(double distance) const {
        return closedForm_ != nullptr ? (1.0 - share_) * closedForm_->at(distance) : 0.0;
    }

private:
    [[nodiscard]] DisplacementField fieldFor(const BSplineSurface& surface, DeformationModel model,
                                             const HalfSpaceAnswer* halfSpace) const;

    TipContact contact_;
    double share_;  ///< of the sample in the displacement, the tip takes the rest
    /// Of sample and tip together; the field's too. Null for models that move the sample alone.
    std::shared_ptr<const RadialTable> closedForm_;
    DisplacementField field_;
};

/// Tip and surface at a state, as they are drawn.
[[nodiscard]] TipContact tipContact(const Scene& scene, const TipState& state);

/// The sample's part of the displacement where the tip is; the tip takes the rest, of models that
/// share it.
[[nodiscard]] double shareOfSample(const Scene& scene, const TipState& state,
                                   DeformationModel model);

}  // namespace asperity
