#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/BoxNewton.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/KnownParts.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/closest/PartFacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

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

    [[nodiscard]] bool contains(const Vector2& position, double margin) const noexcept {
        return std::abs(position.x() - center.x()) <= half.x() + margin &&
               std::abs(position.y() - center.y()) <= half.y() + margin;
    }
};

/// The part as the range of a search, its sides on the scan's edge where they reach it.
[[nodiscard]] Box boxOf(const Part& part, const BSplineSurface& surface) noexcept;

/// Number of minima of the distance that a part can hold.
enum class MinimaIn : std::uint8_t { None, OneAtMost, Unknown };

[[nodiscard]] MinimaIn minimaIn(const Part& part, const Box& box,
                                const BSplineSurface& surface) noexcept;

/// Two minima found from different starts are one when they are nearer to each other [m].
[[nodiscard]] inline double sameMinimum(const BSplineSurface& surface) noexcept {
    constexpr double kPixels = 1e-4;
    return kPixels * std::min(surface.grid().pitchX, surface.grid().pitchY);
}

/// Looks into parts of cells for closest points of one query: each part is quartered until the
/// distance has no minimum in it, or one that is known or found. Allocation-free, bounded, never
/// throws.
class PartSearch {
public:
    /// Looks at the surface that its descents may take before it gives up, but for the last one's.
    static constexpr int kMaxEvaluations = 4096;

    /// @param points holds at least one local closest point; those found are added
    PartSearch(const BSplineSurface& surface, const Vector3& query, const SearchReach& reach,
               ClosestPointList& points) noexcept;

    /// Distance beyond which a closest point does not matter: falls as nearer ones are found [m].
    [[nodiscard]] double limit() const noexcept;
    /// Counts one more look. @return whether there is still time for it
    bool mayLook() noexcept;
    /// Returns whether the search ended before all was looked at, having done as much as it may.
    [[nodiscard]] bool hasGivenUp() noexcept;
    /// Looks at the surface that its descents took so far.
    [[nodiscard]] int evaluations() const noexcept { return evaluations_; }
    /// Looks into the parts of a batch, a bit a lane.
    void lookInto(const PartBatch& batch, unsigned lanes) noexcept;
    /// Looks into those parts of which too little is known, and notes what it finds.
    void lookInto(KnownParts& parts) noexcept;
    /// Takes up the nearest position known as a closest point, though it may be none, where it is
    /// nearer than all closest points: for a search that is not complete. `start` is one more
    /// position to descend from.
    void settleForNearest(const Vector2& start) noexcept;
    /// Returns whether no part was left undecided, and nothing is known to be nearer than the
    /// closest point.
    [[nodiscard]] bool isComplete() const noexcept;

private:
    [[nodiscard]] double nearest() const;
    [[nodiscard]] double nearestDescent() const;
    void take(const BoxMinimum& minimum);
    [[nodiscard]] unsigned unclearIn(const PartBatch& batch, unsigned lanes, PartFacts& facts);
    [[nodiscard]] bool holdsKnownPointAlone(const KnownParts& parts, std::size_t part) const;
    void lookInto(std::span<const std::size_t> indices, KnownParts& parts);
    void lookInto(const PartBatch& batch, std::span<const std::size_t> indices, KnownParts& parts);
    [[nodiscard]] bool isKnown(const BoxMinimum& minimum) const;
    [[nodiscard]] BoxMinimum fromItsSurroundings(const BoxMinimum& minimum);
    BoxMinimum descend(const Box& box, const Vector2& start, double escapeStep);
    void lowerLimit(const Part& part);
    [[nodiscard]] bool holdsKnownPoint(const Part& part) const;
    void findIn(const Part& part, const Box& box);
    [[nodiscard]] bool isPushedOutOfScan(const BoxMinimum& minimum, const Box& box) const;

    const BSplineSurface& surface_;
    Vector3 query_;
    SearchReach reach_;
    ClosestPointList& points_;
    Vector2 pitch_;  ///< [m]
    HalfSquaredDistance objective_;
    SurfaceRounding rounding_;
    /// End of the best of the descents from positions that are nearer than all closest points: no
    /// closest point that is nearest lies farther. The part that holds it is still to be found.
    std::optional<BoxMinimum> nearestDescent_;
    int looks_ = 0;
    int evaluations_ = 0;
    bool complete_ = true;
};

}  // namespace asperity
