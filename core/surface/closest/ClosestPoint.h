#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/surface/Curvature.h"

#include <cstddef>
#include <cstdint>

namespace asperity {

/// Start of a search; kept from one query to the next.
struct SearchGuess {
    double x = 0.0;  ///< world [m]
    double y = 0.0;  ///< world [m]
    bool valid = false;
};

/// Proof that no other surface point is nearer, or the reason why there is none.
enum class SearchProof : std::uint8_t {
    NotSought,      ///< the closest point is a local minimum; nobody looked elsewhere
    Likely,         ///< the likeliest other positions were looked at; nothing is proven
    Nearest,        ///< every other position is farther, to kSameDistance
    OutOfReach,     ///< nothing lies within reach; the closest point is a local minimum beyond it
    TooManyPoints,  ///< too many positions are as near: they could not all be told apart in bounded
                    ///< time
    NotConverged    ///< the closest point itself is not found to rounding
};

/// Effort spent on the search for the closest point.
enum class SearchEffort : std::uint8_t {
    Local,     ///< downhill from the last closest point alone, as the paper does
    Global,    ///< at the likeliest other positions, too: bounded, and rarely wrong
    Certified  ///< until no other position can be nearer
};

template <>
inline constexpr auto kEnumTable<SearchProof> =
    std::to_array<EnumRow<SearchProof>>({{SearchProof::NotSought, "not_sought"},
                                         {SearchProof::Likely, "likely"},
                                         {SearchProof::Nearest, "nearest"},
                                         {SearchProof::OutOfReach, "out_of_reach"},
                                         {SearchProof::TooManyPoints, "too_many_points"},
                                         {SearchProof::NotConverged, "not_converged"}});

template <>
inline constexpr auto kEnumTable<SearchEffort> =
    std::to_array<EnumRow<SearchEffort>>({{SearchEffort::Local, "local"},
                                          {SearchEffort::Global, "global"},
                                          {SearchEffort::Certified, "certified"}});

/// Returns whether a search left open that there are other closest points than those it found.
[[nodiscard]] inline bool mayMissPoints(SearchProof proof) noexcept {
    return proof == SearchProof::NotSought || proof == SearchProof::Likely ||
           proof == SearchProof::TooManyPoints;
}

/// Positions whose forces on a tip are summed. Where more bear, the search's proof says so.
inline constexpr std::size_t kMaxContactPoints = 4;

/// Two distances nearer to each other than this are the same [relative].
inline constexpr double kSameDistance = 1e-9;

/// The point on the surface that is nearest to a query.
struct ClosestPoint {
    Vector3 point = Vector3::Zero();    ///< on the surface, world [m]
    Vector3 normal = Vector3::UnitZ();  ///< unit, out of the sample
    double distance = 0.0;              ///< signed, < 0 below the surface [m]
    PrincipalCurvatures curvatures;     ///< of the surface there
    int iterations = 0;                 ///< Newton steps spent, over all starts
    bool converged = false;             ///< the gradient condition holds to rounding
    bool insideScan = true;             ///< the closest point lies within the scan
    SearchProof proof = SearchProof::NotSought;

    [[nodiscard]] bool certified() const noexcept { return proof == SearchProof::Nearest; }
    [[nodiscard]] SearchGuess guess() const noexcept { return {point.x(), point.y(), converged}; }
};

}  // namespace asperity
