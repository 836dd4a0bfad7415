#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/DetectorCalibration.h"

#include <cstdint>
#include <string>

namespace asperity {

/// Model that computes a force from the signals.
enum class DecouplingModel : std::uint8_t {
    Planar,    ///< nothing assumed but that the force lies in the plane of normal and motion
    Estimator  ///< weighted least squares of all that is known
};

template <>
inline constexpr auto kEnumTable<DecouplingModel> = std::to_array<EnumRow<DecouplingModel>>(
    {{DecouplingModel::Planar, "planar"}, {DecouplingModel::Estimator, "estimator"}});

/// A normal that is less certain has no direction, and what it does to the force is not linear
/// [rad].
inline constexpr double kMaxNormalDeviation = 1.0;

/// Signals of one instant and what is known besides; vectors in the lab frame.
struct DecouplingInput {
    LeverSignals signals;
    LeverSignals sigma;                 ///< standard deviation of the signals [rad], > 0
    Vector3 normal = Vector3::UnitZ();  ///< out of the sample; of any length from 1e-30 on
    /// Standard deviation of the normal's direction about each axis across it [rad], 0 to
    /// kMaxNormalDeviation.
    double normalDeviation = 0.0;
    Vector3 velocity = Vector3::Zero();  ///< of the tip relative to the sample [m/s]
    double frictionCoefficient = 0.0;    ///< mu
    double shearStrength = 0.0;          ///< tau [Pa]
    double contactArea = 0.0;            ///< A [m^2]
    double normalForceModel = 0.0;       ///< N of the contact model [N]
    double normalForceSigma = 0.0;       ///< its standard deviation [N], > 0
    /// Standard deviation of the friction law beside its 30 % [N]: what InnovationMonitor found
    double frictionLawError = 0.0;
};

/// Geometry that the estimate met (docs/theory.md 6.3).
enum class DecouplingCase : std::uint8_t {
    Regular,       ///< planarity and signals determine the force
    NearSingular,  ///< condition > 100: planarity says little, model and friction law decide
    NoSliding,     ///< no tangential velocity: no direction of friction
    InvalidInput,  ///< an input was not finite, beyond 1e12 in SI, negative where it must not be,
                   ///< or the normal had no direction; force and covariance are zero
};

template <>
inline constexpr auto kEnumTable<DecouplingCase> =
    std::to_array<EnumRow<DecouplingCase>>({{DecouplingCase::Regular, "regular"},
                                            {DecouplingCase::NearSingular, "near_singular"},
                                            {DecouplingCase::NoSliding, "no_sliding"},
                                            {DecouplingCase::InvalidInput, "invalid_input"}});

/// Signs that the estimated force breaks the assumptions. Source: docs/theory.md 6.5 (e).
struct Plausibility {
    bool pushesAlong = false;  ///< T < 0 (by more than 1 pN): friction would drive the tip
    /// |T| > max(0, mu N + tau A) by three standard deviations of estimate and friction law, or the
    /// torsion shows more than the estimate holds, by five of what that leaves open
    bool excessFriction = false;
    /// N is not that of the contact model, by three standard deviations of what the model may
    /// still differ by from an estimate that it took part in
    bool contradictsModel = false;

    [[nodiscard]] bool holds() const noexcept {
        return !pushesAlong && !excessFriction && !contradictsModel;
    }
};

struct ForceEstimate {
    Vector3 force = Vector3::Zero();       ///< on the tip, lab frame [N]
    Matrix3 covariance = Matrix3::Zero();  ///< of the force, lab frame [N^2]
    Vector3 deflection = Vector3::Zero();  ///< of the tip under the force, lab frame [m]
    double condition = 0.0;  ///< of (N, T) -> signals, 2-norm; inf: singular or no sliding
    DecouplingCase kind = DecouplingCase::Regular;
    Plausibility plausibility;
};

/// The case in words and what is not plausible, joined by '|', e.g. "regular|excess_friction".
[[nodiscard]] std::string caseText(const ForceEstimate& estimate);

/// Force by weighted least squares of signals, planarity, friction law and contact model:
/// continuous in every direction of motion and at rest. Where the contact model pulls so hard that
/// mu N + tau A < 0, the friction law fades into T = 0 (docs/theory.md 8), over one standard
/// deviation of N. No allocation. Source: docs/theory.md 6.5, 6.7.
[[nodiscard]] ForceEstimate estimateForce(const Cantilever& cantilever,
                                          const DecouplingInput& input) noexcept;

/// The force that two signals give when nothing is assumed but that it lies in the plane of normal
/// and motion. What the paper does; estimateForce() also knows what to do where this is singular.
struct PlanarForce {
    Vector3 force = Vector3::Zero();  ///< lab frame [N]; zero where singular
    double determinant = 0.0;         ///< p.b, plane normal times blind direction
    bool singular = true;             ///< |determinant| < 1e-12, or no sliding
};

/// @param normal unit, out of the sample, lab frame
/// @param velocity of the tip relative to the sample, lab frame [m/s]
/// Source: docs/theory.md 6.3.
[[nodiscard]] PlanarForce planarForce(const Cantilever& cantilever, const LeverSignals& signals,
                                      const Vector3& normal, const Vector3& velocity) noexcept;

/// The planar force as an estimate; where it is singular, the contact model's force along the
/// normal, with that one's variance. The covariance is that of the signals' noise alone, and
/// nothing is held against the friction law. No allocation.
[[nodiscard]] ForceEstimate planarEstimate(const Cantilever& cantilever,
                                           const DecouplingInput& input) noexcept;

}  // namespace asperity
