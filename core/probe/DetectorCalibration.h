#pragma once

#include "core/Vector.h"
#include "core/probe/CantileverModes.h"

#include <Eigen/Core>

#include <optional>

namespace asperity {

/// Signals of the optical lever: the slope at the tip, and so of the straight rest of the beam up
/// to its free end, about two axes.
struct LeverSignals {
    double bending = 0.0;  ///< alpha = dz/dx at the tip [rad]
    double torsion = 0.0;  ///< theta [rad]
};

/// Signals that a force on the tip (lab frame [N]) causes. Source: docs/theory.md 5.2, 5.4.
[[nodiscard]] LeverSignals leverSignals(const Cantilever& cantilever,
                                        const Vector3& force) noexcept;

/// Returns the vector whose product with a force on the tip (lab frame) is the force along z that
/// the bending shows: 1 along z; along the lever it is what friction pretends. Source:
/// docs/theory.md 5.4.
[[nodiscard]] Vector3 bendingAxis(const Cantilever& cantilever) noexcept;

/// Deflection per force along z that an optical lever calibrated on a hard wall shows [m/N]: what
/// an instrument's setpoint in nanometers counts. Source: docs/theory.md 5.2.
[[nodiscard]] double shownDeflectionPerForce(const Cantilever& cantilever) noexcept;

/// Relation of the photodiode's volts to the lever's slopes. Source: docs/theory.md 5.2.
struct DetectorCalibration {
    /// Inverse optical lever sensitivity: deflection along the lever's normal per volt of the
    /// vertical signal, measured on a hard wall [m/V].
    std::optional<double> invOls;
    std::optional<double> torsionPerVolt;  ///< of the lateral signal [rad/V]
    double verticalCrossTalk = 0.0;  ///< volts in the vertical signal per volt of the lateral one
    double lateralCrossTalk = 0.0;   ///< volts in the lateral signal per volt of the vertical one

    bool operator==(const DetectorCalibration&) const = default;
};

/// Signals of the two channels of the photodiode.
struct DetectorVolts {
    double vertical = 0.0;  ///< [V]
    double lateral = 0.0;   ///< [V]
};

/// Turns volts into slopes. On a hard wall a pure end force bends the lever, so that the slope is
/// alpha = 3 / (2 l) times the deflection, l from clamp to tip.
class VoltsToSignals {
public:
    /// @throw Error when one of the two sensitivities is not known, or the cross-talk leaves the
    ///        channels indistinguishable
    VoltsToSignals(const Cantilever& cantilever, const DetectorCalibration& detector);

    /// Slopes [rad] that were measured as these volts.
    [[nodiscard]] LeverSignals signals(const DetectorVolts& volts) const noexcept;
    /// Standard deviations [rad] of the slopes for independent ones of the volts. What cross-talk
    /// leaves of correlation between them is not told.
    [[nodiscard]] LeverSignals sigma(const DetectorVolts& sigma) const noexcept;

private:
    Eigen::Matrix2d perVolt_ = Eigen::Matrix2d::Zero();  ///< (alpha, theta) per (vertical, lateral)
};

}  // namespace asperity
