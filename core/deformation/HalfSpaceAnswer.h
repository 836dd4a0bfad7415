#pragma once

#include "core/EnumTable.h"
#include "core/probe/TipEquilibrium.h"

#include <cstdint>
#include <memory>

namespace asperity {

class HalfSpaceField;
class PixelField;

/// Whether an answer of the half-space can be used, and why not.
enum class HalfSpaceVerdict : std::uint8_t {
    Valid,
    NotBonded,      ///< no contact: nothing to solve
    Film,           ///< the sample is a film, not a half-space
    NoZone,         ///< the contact law adheres without a cohesive zone (DMT, JKR)
    LargeContact,   ///< contact radius > 0.3 effective radii
    ReachesBorder,  ///< the contact is larger than the largest patch
    TooCoarse,      ///< contact or cohesive zone a few pixels wide
    Separate,       ///< on the real topography the tip has no contact where the law has one
    NotConverged,
    Canceled,
};

/// For people: why an answer is used or not.
template <>
inline constexpr auto kEnumTable<HalfSpaceVerdict> = std::to_array<NamedRow<HalfSpaceVerdict>>(
    {{HalfSpaceVerdict::Valid, "it is used"},
     {HalfSpaceVerdict::NotBonded, "no contact"},
     {HalfSpaceVerdict::Film, "the sample is a film"},
     {HalfSpaceVerdict::NoZone, "the contact law's adhesion has no cohesive zone"},
     {HalfSpaceVerdict::LargeContact, "contact radius above 0.3 effective radii"},
     {HalfSpaceVerdict::ReachesBorder, "the contact reaches the patch's border"},
     {HalfSpaceVerdict::TooCoarse, "contact or cohesive zone too narrow for its grid"},
     {HalfSpaceVerdict::Separate, "no contact on the real topography"},
     {HalfSpaceVerdict::NotConverged, "did not converge"},
     {HalfSpaceVerdict::Canceled, "canceled"}});

/// The half-space's own view of one state of the tip.
struct HalfSpaceAnswer {
    HalfSpaceVerdict verdict = HalfSpaceVerdict::NotBonded;
    TipState state;              ///< that was asked about
    double force = 0.0;          ///< on the tip along the closest point's normal, > 0 repulsive [N]
    double contactRadius = 0.0;  ///< of the circle of the contact's area [m]
    int iterations = 0;
    std::shared_ptr<const HalfSpaceField> field;  ///< of both bodies together; null unless valid
    /// On the sample, over the same pixels with their corner at 0 [Pa]; null unless valid.
    std::shared_ptr<const PixelField> pressure = nullptr;

    [[nodiscard]] bool valid() const noexcept { return verdict == HalfSpaceVerdict::Valid; }
};

/// Returns whether a valid answer still describes the surface at a later state: the same branch, a
/// contact of about the same width and position.
[[nodiscard]] bool stillHolds(const HalfSpaceAnswer& answer, const TipState& now);

}  // namespace asperity
