#pragma once

#include "core/Simd.h"
#include "core/Vector.h"
#include "core/surface/closest/Box.h"
#include "core/surface/closest/BoxNewton.h"
#include "core/surface/closest/PartBatch.h"

namespace asperity {

/// A vector in space, for each of four parts [m].
struct Vector4 {
    Double4 x;
    Double4 y;
    Double4 z;
};

/// Half the squared distance from a query over the parts of a batch: its value and gradient at the
/// center, and what is known of it everywhere in the part. A bit a lane. Where all parts are far,
/// nothing is said of minima.
struct PartFacts {
    Double4 value;      ///< at the center [m^2]
    Double4 gradientX;  ///< at the center [m]
    Double4 gradientY;  ///< at the center [m]
    /// Of these four nothing is said where no part of the batch is near the scan's edge.
    Double4 spreadX;   ///< by which that differs elsewhere, rounding included [m]
    Double4 spreadY;   ///< by which that differs elsewhere, rounding included [m]
    Double4 bendX;     ///< least second derivative along x
    Double4 bendY;     ///< least second derivative along y
    Double4 least;     ///< nowhere is it less [m^2]
    Vector4 way;       ///< from the query to about the nearest place of the part
    Double4 alongWay;  ///< all of the part is so far along it, times its length [m^2]
    /// How far the query may move with no minimum getting into the part; <= 0: it may hold one, or
    /// is at the scan's edge [m].
    Double4 calm;
    /// How far the query may move with no second minimum getting into a convex part [m].
    Double4 convexFor;
    unsigned far = 0;             ///< farther than the limit
    unsigned withoutMinimum = 0;  ///< no minimum, unless at the scan's edge
    unsigned convex = 0;          ///< at most one minimum
};

/// What a part is asked about.
struct PartQuery {
    Vector3 point = Vector3::Zero();  ///< x and y world, z above the datum [m]
    SurfaceRounding rounding;         ///< of places and heights
    double limit = 0.0;               ///< half a squared distance [m^2]
    Box scan;                         ///< all of it
};

/// Second derivatives are bounded up the slope and across it, not along x and y: on a steep slope
/// the distance bends far more up it than across, and along x and y the two would be mixed.
void examine(const PartBatch& batch, const PartQuery& query, PartFacts& facts) noexcept;

}  // namespace asperity
