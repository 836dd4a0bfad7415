#pragma once

#include "core/Vector.h"
#include "core/probe/Cantilever.h"
#include "core/probe/OpticalLever.h"

#include <cstdint>

namespace asperity {

/// What is known at one instant besides the signals; vectors in the lab frame.
struct DecouplingInput {
    LeverSignals signals;
    LeverSignals sigma;                  ///< standard deviation of the signals [rad], > 0
    Vector3 normal = Vector3::UnitZ();   ///< unit, out of the sample
    Vector3 velocity = Vector3::Zero();  ///< of the tip relative to the sample [m/s]
    double frictionCoefficient = 0.0;    ///< mu
    double shearStrength = 0.0;          ///< tau [Pa]
    double contactArea = 0.0;            ///< A [m^2]
    double normalForceModel = 0.0;       ///< N of the contact model [N]
    double normalForceSigma = 0.0;       ///< its standard deviation [N], > 0
};

/// Which geometry the estimate met (docs/physics.md 6.3).
enum class DecouplingCase : std::uint8_t {
    Regular,       ///< planarity and signals determine the force
    NearSingular,  ///< condition > 100: planarity says little, model and friction law decide
    NoSliding,     ///< no tangential velocity: no direction of friction
    NotFinite,  ///< an input was not finite (or beyond 1e12 in SI), or negative where it must not
                ///< be; force and covariance are zero
};

struct ForceEstimate {
    Vector3 force = Vector3::Zero();       ///< on the tip, lab frame [N]
    Matrix3 covariance = Matrix3::Zero();  ///< of the force, lab frame [N^2]
    double condition = 0.0;  ///< of (N, T) -> signals, 2-norm; inf: singular or no sliding
    DecouplingCase kind = DecouplingCase::Regular;
};

/// Force by weighted least squares of signals, planarity, friction law and contact model:
/// continuous in every direction of motion and at rest. No allocation. Source: docs/physics.md 6.5.
[[nodiscard]] ForceEstimate estimateForce(const Cantilever& cantilever,
                                          const DecouplingInput& input) noexcept;

}  // namespace asperity
