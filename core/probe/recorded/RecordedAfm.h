#pragma once

#include "core/probe/AfmController.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/recorded/CurvePlayer.h"
#include "core/surface/closest/ClosestPointTracker.h"
#include "core/surface/sample/SampleSurface.h"

#include <memory>

namespace asperity {

/// An instrument that plays a measured force curve: base in, recorded signals out.
///
/// Along z the base is aligned by the record's own: its contact point is where the unbent tip of
/// the scene would first touch the surface, straight below the base. Until the record shows that it
/// holds to the sample, that is the place below the base wherever it is; from then on the place
/// stays, and a base that is farther aside of it than kAside tip radii gets the same signals with a
/// flag. See CurvePlayer for what is played.
///
/// The bending is what the scene's lever shows under the recorded force along z, which is that of
/// the curve's own lever; the torsion is zero. Nothing is added to the recorded noise, and the age
/// is zero. Below the deepest sample the measurement has `ended` and no signals.
class RecordedAfm final : public AfmController {
public:
    /// Lateral distance from the place of the record, in tip radii, from which on it is another.
    static constexpr double kAside = 0.1;

    /// @param tipRadius of the scene [m] @param surface must outlive the instrument
    RecordedAfm(std::shared_ptr<const PlayedCurve> curve, const SampleSurface& surface,
                double tipRadius, const Cantilever& cantilever);

    AfmMeasurement exchange(const BaseMotion& target) noexcept override;

private:
    [[nodiscard]] bool isAside(const Vector3& base) const noexcept;
    void findPlace(const Vector3& base) noexcept;

    std::shared_ptr<const PlayedCurve> curve_;
    CurvePlayer player_;
    SampleSurface surface_;
    double tipRadius_;  ///< [m]
    Cantilever cantilever_;
    ClosestPointTracker tracker_;
    Vector3 place_ = Vector3::Zero();  ///< of the apex at the first touch, world [m]
    bool isSought_ = false;            ///< the place is one that was looked for
    bool isFound_ = false;             ///< it lies on the surface
    bool hasTouched_ = false;          ///< it stays
};

}  // namespace asperity
