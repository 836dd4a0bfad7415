#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/surface/Curvature.h"

#include <cstddef>
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
    Likely,       ///< the likeliest other places were looked at; nothing is proven
    Nearest,      ///< every other place is farther, to kSameDistance
    OutOfReach,   ///< nothing lies within reach; the foot is a local minimum beyond it
    ManyFeet,     ///< too many places are as near: they could not all be told apart in bounded time
    NotConverged  ///< the foot itself is not found to rounding
};

/// How hard the nearest foot is looked for.
enum class FootEffort : std::uint8_t {
    Local,     ///< downhill from the last foot alone, as the paper does
    Global,    ///< at the likeliest other places, too: bounded, and rarely wrong
    Certified  ///< until no other place can be nearer
};

template <>
inline constexpr auto kEnumTable<FootProof> =
    std::to_array<EnumRow<FootProof>>({{FootProof::NotSought, "not_sought"},
                                       {FootProof::Likely, "likely"},
                                       {FootProof::Nearest, "nearest"},
                                       {FootProof::OutOfReach, "out_of_reach"},
                                       {FootProof::ManyFeet, "many_feet"},
                                       {FootProof::NotConverged, "not_converged"}});

template <>
inline constexpr auto kEnumTable<FootEffort> =
    std::to_array<EnumRow<FootEffort>>({{FootEffort::Local, "local"},
                                        {FootEffort::Global, "global"},
                                        {FootEffort::Certified, "certified"}});

/// Whether a search left it open that there are other feet than those it found.
[[nodiscard]] inline bool mayMissFeet(FootProof proof) noexcept {
    return proof == FootProof::NotSought || proof == FootProof::Likely ||
           proof == FootProof::ManyFeet;
}

/// More places than these do not touch a sphere at once on any real scan.
inline constexpr std::size_t kMaxFeet = 4;

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
