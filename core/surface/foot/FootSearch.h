#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/foot/FootList.h"
#include "core/surface/foot/PartSearch.h"

namespace asperity {

/// Looks everywhere for feet of `query`: local minima of its distance from the surface within
/// `reach`, and adds them to `feet`, which holds at least one local foot already.
///
/// Cells that lie too far, or around a known foot where the distance can only grow, are ruled out
/// by their bounds; the others are quartered until the distance has no minimum in them, or one that
/// is found. @return Nearest: the list is complete, as far as it has room; ManyFeet: it need not
/// be. Allocation-free, bounded, never throws.
[[nodiscard]] FootProof completeFeet(const BSplineSurface& surface, const Vector3& query,
                                     const FootReach& reach, FootList& feet) noexcept;

}  // namespace asperity
