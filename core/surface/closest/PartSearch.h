#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/KnownParts.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/closest/Part.h"
#include "core/surface/closest/SearchReach.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

namespace asperity {

/// Two minima found from different starts are one when they stand nearer to each other [m].
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

    /// How far a closest point may lie to matter: falls as nearer closest points are found [m].
    [[nodiscard]] double limit() const noexcept;
    /// Counts one more look; whether there is still time for it.
    bool mayLook() noexcept;
    /// Whether the search is over before all was looked at: it has done as much as one may.
    [[nodiscard]] bool hasGivenUp() noexcept;
    /// Looks at the surface that its descents took so far.
    [[nodiscard]] int evaluations() const noexcept { return evaluations_; }
    /// Looks into the parts of a batch, a bit a lane.
    void lookInto(const PartBatch& batch, unsigned lanes) noexcept;
    /// Looks into those parts of which too little is known, and notes what it finds.
    void lookInto(KnownParts& parts) noexcept;
    /// Takes up the nearest place known as a closest point, though it may be none, where it is
    /// nearer than all closest points: for a search that is not complete. `start` is one more place
    /// to descend from.
    void settleForNearest(const Vector2& start) noexcept;
    /// Whether no part was left undecided, and nothing is known to be nearer than the closest
    /// point.
    [[nodiscard]] bool isComplete() const noexcept;

private:
    [[nodiscard]] double nearest() const;
    [[nodiscard]] double nearestPlace() const;
    void take(const BoxMinimum& minimum);
    [[nodiscard]] unsigned unclearIn(const PartBatch& batch, unsigned lanes, PartFacts& facts);
    [[nodiscard]] bool holdsKnownPointAlone(const KnownParts& parts, std::size_t part) const;
    void lookInto(std::span<const std::size_t> places, KnownParts& parts);
    void lookInto(const PartBatch& batch, std::span<const std::size_t> places, KnownParts& parts);
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
    /// Where the best of the descents from places that are nearer than all closest points got to:
    /// no closest point that is nearest lies farther. The part that holds it is still to be found.
    std::optional<BoxMinimum> nearestPlace_;
    int looks_ = 0;
    int evaluations_ = 0;
    bool complete_ = true;
};

}  // namespace asperity
