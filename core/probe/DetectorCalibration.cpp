#include "core/probe/DetectorCalibration.h"

#include "core/Error.h"

#include <cmath>

namespace asperity {

LeverSignals leverSignals(const Cantilever& cantilever, const Vector3& force) noexcept {
    const Vector3 local = cantilever.rotation() * force;
    return {.bending =
                (cantilever.bendingPerFz() * local.z()) + (cantilever.bendingPerFx() * local.x()),
            .torsion = cantilever.torsionPerFy() * local.y()};
}

Vector3 bendingAxis(const Cantilever& cantilever) noexcept {
    const Vector3 local(cantilever.bendingPerFx(), 0.0, cantilever.bendingPerFz());
    const Vector3 axis = cantilever.rotation().transpose() * local;
    return axis / axis.z();
}

namespace {

/// Slope per deflection on a hard wall [rad/m].
double slopePerDeflection(const Cantilever& cantilever) noexcept {
    return 3.0 / (2.0 * cantilever.geometry().loadPoint());
}

}  // namespace

double shownDeflectionPerForce(const Cantilever& cantilever) noexcept {
    return std::abs(leverSignals(cantilever, Vector3::UnitZ()).bending) /
           slopePerDeflection(cantilever);
}

VoltsToSignals::VoltsToSignals(const Cantilever& cantilever, const DetectorCalibration& detector) {
    if (!detector.invOls || !detector.torsionPerVolt) {
        throw Error("signals in volts need inv_ols_m_v and lateral_sensitivity_rad_v of the probe");
    }
    const double determinant = 1.0 - (detector.verticalCrossTalk * detector.lateralCrossTalk);
    if (!(std::abs(determinant) > 1e-3)) {
        throw Error("cross_talk_vertical times cross_talk_lateral must not be 1: the detector "
                    "could not separate bending from torsion");
    }
    // measured = [1, vertical; lateral, 1] true, in volts.
    Eigen::Matrix2d unmixed;
    unmixed << 1.0, -detector.verticalCrossTalk, -detector.lateralCrossTalk, 1.0;
    const double bendingPerVolt = *detector.invOls * slopePerDeflection(cantilever);
    perVolt_ = Eigen::Vector2d(bendingPerVolt, *detector.torsionPerVolt).asDiagonal() * unmixed;
    perVolt_ /= determinant;
}

LeverSignals VoltsToSignals::signals(const DetectorVolts& volts) const noexcept {
    const Eigen::Vector2d slopes = perVolt_ * Eigen::Vector2d(volts.vertical, volts.lateral);
    return {.bending = slopes.x(), .torsion = slopes.y()};
}

LeverSignals VoltsToSignals::sigma(const DetectorVolts& sigma) const noexcept {
    return {.bending = std::hypot(perVolt_(0, 0) * sigma.vertical, perVolt_(0, 1) * sigma.lateral),
            .torsion = std::hypot(perVolt_(1, 0) * sigma.vertical, perVolt_(1, 1) * sigma.lateral)};
}

}  // namespace asperity
