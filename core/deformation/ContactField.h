#pragma once

#include "core/contact/displacement/SurfaceProfile.h"
#include "core/deformation/ContactDeformation.h"
#include "core/deformation/HalfSpaceAnswer.h"
#include "core/surface/TangentFrame.h"

#include <memory>

namespace asperity {

struct Scene;

/// Gap and pressure between tip and sample at one state of the believed model, at places of the
/// surface at rest. Of several closest points it is the main one. Source: docs/theory.md 4.
class ContactField {
public:
    /// @param scene     outlives the field
    /// @param halfSpace whose pressure is taken where the scene asks for the half-space and the
    ///                  answer still holds, else that of the contact law; or null
    ContactField(const Scene& scene, const TipState& state,
                 const HalfSpaceAnswer* halfSpace = nullptr);

    /// Distance between the deformed bodies along the contact's normal, >= 0, 0 in contact; not a
    /// number where the tip is not above the place [m].
    /// @param rest    of the surface at rest [m]
    /// @param sample  its displacement into the sample [m]
    /// @param tip     displacement of the tip's surface there, into the tip [m]
    [[nodiscard]] double gap(const Vector3& rest, double sample, double tip) const noexcept;
    /// On the sample, > 0 compression [Pa]: as contactPressure(), or the half-space's.
    [[nodiscard]] double pressure(const Vector3& rest) const noexcept;
    /// Whether the pressure is the half-space's.
    [[nodiscard]] bool isHalfSpace() const noexcept { return pixels_ != nullptr; }

private:
    TipContact contact_;
    CohesiveContact profile_;
    double reach_;  ///< of the tip from the contact's axis [m]
    TangentFrame frame_;
    std::shared_ptr<const PixelField> pixels_;  ///< pressures of the half-space
};

}  // namespace asperity
