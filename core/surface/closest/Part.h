#pragma once

#include "core/surface/closest/BoxNewton.h"
#include "core/surface/closest/PartFacts.h"

#include <cmath>
#include <cstdint>

namespace asperity {

/// One part of a batch and what is known of half the squared distance over it.
struct Part {
    Vector2 center = Vector2::Zero();    ///< world [m]
    Vector2 half = Vector2::Zero();      ///< half its size [m]
    double value = 0.0;                  ///< half the squared distance of its center [m^2]
    Vector2 gradient = Vector2::Zero();  ///< of that [m]
    Vector2 spread = Vector2::Zero();    ///< by which it differs elsewhere in the part [m]
    Vector2 bend = Vector2::Zero();      ///< its least second derivatives along x and y
    bool withoutMinimum = false;         ///< unless at the scan's edge
    bool convex = false;

    Part(const PartBatch& batch, const PartFacts& facts, int lane) noexcept
        : center(batch.centerX[lane], batch.centerY[lane])
        , half(batch.halfX[lane], batch.halfY[lane])
        , value(facts.value[lane])
        , gradient(facts.gradientX[lane], facts.gradientY[lane])
        , spread(facts.spreadX[lane], facts.spreadY[lane])
        , bend(facts.bendX[lane], facts.bendY[lane])
        , withoutMinimum(((facts.withoutMinimum >> static_cast<unsigned>(lane)) & 1U) != 0)
        , convex(((facts.convex >> static_cast<unsigned>(lane)) & 1U) != 0) {}

    [[nodiscard]] bool contains(const Vector2& place, double margin) const noexcept {
        return std::abs(place.x() - center.x()) <= half.x() + margin &&
               std::abs(place.y() - center.y()) <= half.y() + margin;
    }
};

/// The part as the place of a search, its sides on the scan's edge where they reach it.
[[nodiscard]] Box boxOf(const Part& part, const BSplineSurface& surface) noexcept;

/// How many minima of the distance a part can hold.
enum class MinimaIn : std::uint8_t { None, OneAtMost, Unknown };

[[nodiscard]] MinimaIn minimaIn(const Part& part, const Box& box,
                                const BSplineSurface& surface) noexcept;

}  // namespace asperity
