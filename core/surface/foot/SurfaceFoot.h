#pragma once

#include "core/Vector.h"
#include "core/surface/Curvature.h"

#include <cstdint>

namespace asperity {

/// Where a search starts; kept from one query to the next.
struct FootGuess {
    double x = 0.0;  ///< world [m]
    double y = 0.0;  ///< world [m]
    bool valid = false;
};

/// What proves that no other surface point is nearer, or why nothing does.
enum class FootProof : std::uint8_t {
    NotSought,    ///< the foot is a local minimum; nobody looked elsewhere
    Nearest,      ///< every other place is farther, to kSameDistance
    OutOfReach,   ///< nothing lies within reach; the foot is a local minimum beyond it
    ManyFeet,     ///< too many places are as near: they could not all be told apart in bounded time
    NotConverged  ///< the foot itself is not found to rounding
};

/// Name of a proof as files and panels show it, e.g. "nearest".
[[nodiscard]] const char* proofName(FootProof proof) noexcept;

/// Two distances nearer to each other than this are the same [relative].
inline constexpr double kSameDistance = 1e-9;

/// Foot of a point on the surface: the surface point nearest to it.
struct SurfaceFoot {
    Vector3 point = Vector3::Zero();    ///< on the surface, world [m]
    Vector3 normal = Vector3::UnitZ();  ///< unit, out of the sample
    double distance = 0.0;              ///< signed, < 0 below the surface [m]
    PrincipalCurvatures curvatures;     ///< of the surface there
    int iterations = 0;                 ///< Newton steps spent, over all starts
    bool converged = false;             ///< the gradient condition holds to rounding
    bool insideScan = true;             ///< the foot lies within the scan
    FootProof proof = FootProof::NotSought;

    [[nodiscard]] bool certified() const noexcept { return proof == FootProof::Nearest; }
    [[nodiscard]] FootGuess guess() const noexcept { return {point.x(), point.y(), converged}; }
};

}  // namespace asperity
