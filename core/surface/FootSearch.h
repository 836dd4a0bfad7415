#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/FootList.h"

namespace asperity {

/// Looks everywhere for feet of `query`: local minima of its distance from the surface that lie
/// within `within` [m], and adds them to `feet`, which holds at least one local foot already.
///
/// Cells that lie too far, or around a known foot where the distance can only grow, are ruled out
/// by their bounds; the others are halved until the distance has no minimum in them, or one that is
/// found. @return Nearest: the list is complete, as far as it has room; ManyFeet: it need not be.
/// Allocation-free, bounded, never throws.
[[nodiscard]] FootProof completeFeet(const BSplineSurface& surface, const Vector3& query,
                                     double within, FootList& feet) noexcept;

/// As completeFeet(), but only for feet that are nearer than those known so far.
[[nodiscard]] FootProof findNearestFoot(const BSplineSurface& surface, const Vector3& query,
                                        FootList& feet) noexcept;

}  // namespace asperity
