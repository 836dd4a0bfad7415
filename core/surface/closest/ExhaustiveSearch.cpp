#include "core/surface/closest/ExhaustiveSearch.h"

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/CellSweep.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/PartSearch.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>

namespace asperity {

namespace {

/// Looks into cells as a sweep names them, a batch at a time.
class CellsInBatches {
public:
    CellsInBatches(const BSplineSurface& surface, PartSearch& search)
        : surface_(surface), search_(search) {}

    [[nodiscard]] double limit() const { return search_.limit(); }
    [[nodiscard]] bool mayLook() { return search_.mayLook(); }
    [[nodiscard]] bool hasGivenUp() { return search_.hasGivenUp(); }

    void take(const CellIndex& cell) {
        cells_.push_back(cell);
        if (cells_.size() == PartBatch::kLanes) {
            lookIntoCells();
        }
    }

    void lookIntoCells() {
        if (cells_.empty()) {
            return;
        }
        PartBatch batch;
        loadCells(surface_.grid(), {cells_.data(), cells_.size()}, batch);
        search_.lookInto(batch, (1U << cells_.size()) - 1U);
        cells_.clear();
    }

private:
    const BSplineSurface& surface_;
    PartSearch& search_;
    boost::container::static_vector<CellIndex, PartBatch::kLanes> cells_;
};

/// Sorts out the cells that a sweep names: those in which no query of a ball has a closest point,
/// and those that are left open.
class CellsOfBall {
public:
    /// @param farthest how far from the ball's center a closest point may lie to matter [m]
    CellsOfBall(const BSplineSurface& surface, const QueryBall& queries, double farthest)
        : surface_(surface)
        , farthest_(farthest)
        , question_{.point = queries.center - Vector3(0.0, 0.0, surface.grid().datum),
                    .rounding = roundingOf(surface, queries.center),
                    .limit = 0.5 * farthest * farthest,
                    .scan = scanBox(surface),
                    .ball = queries.radius} {}

    [[nodiscard]] double limit() const { return farthest_; }
    [[nodiscard]] bool mayLook() { return !hasGivenUp(); }
    [[nodiscard]] bool hasGivenUp() const { return full_; }

    void take(const CellIndex& cell) {
        cells_.push_back(cell);
        if (cells_.size() == PartBatch::kLanes) {
            sortOut();
        }
    }

    void sortOut() {
        if (cells_.empty()) {
            return;
        }
        PartBatch batch;
        PartFacts facts;
        loadCells(surface_.grid(), {cells_.data(), cells_.size()}, batch);
        examine(batch, question_, facts);
        for (std::size_t lane = 0; lane < cells_.size(); ++lane) {
            if (((facts.far >> lane) & 1U) != 0) {
                continue;
            }
            const Part part(batch, facts, static_cast<int>(lane));
            if (minimaIn(part, boxOf(part, surface_), surface_) != MinimaIn::None) {
                leaveOpen(cells_[lane]);
            }
        }
        cells_.clear();
    }

    [[nodiscard]] const auto& open() const { return open_; }

private:
    void leaveOpen(const CellIndex& cell) {
        full_ = full_ || open_.size() == open_.max_size();
        if (!full_) {
            open_.push_back(cell);
        }
    }

    const BSplineSurface& surface_;
    double farthest_;
    PartQuery question_;
    boost::container::static_vector<CellIndex, PartBatch::kLanes> cells_;
    boost::container::static_vector<CellIndex, kMaxOpenCells> open_;
    bool full_ = false;
};

/// Settles what it can around the closest points known, one after another.
void settleAround(const ClosestPointList& points, CellSweep& sweep) {
    for (const ClosestPoint& closest : points.all()) {
        if (closest.converged &&
            sweep.settle(sweep.window().blocksAround(closest.point.x(), closest.point.y(), 0.0))) {
            return;
        }
    }
}

/// Looks at all that a sweep has left.
SearchProof lookInto(const BSplineSurface& surface, const Vector3& query, const SearchReach& reach,
                     const CellSweep& sweep, ClosestPointList& points) {
    PartSearch search(surface, query, reach, points);
    CellsInBatches cells(surface, search);
    sweep.visit(cells);
    cells.lookIntoCells();
    if (search.isComplete()) {
        return SearchProof::Nearest;
    }
    search.settleForNearest(sweep.likeliestPlace());
    return SearchProof::TooManyPoints;
}

}  // namespace

bool ProvenBall::covers(const Vector3& query, const SearchReach& within,
                        const ClosestPoint& nearest) const noexcept {
    const double moved = (query - queries.center).norm();
    return moved <= queries.radius && nearest.converged && anchor.holds(nearest.point.head<2>()) &&
           within.limit(nearest) + moved <= reach;
}

SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                           const SearchReach& reach, ClosestPointList& points) noexcept {
    CellSweep sweep(surface, query, reach.limit(points.all().front()));
    settleAround(points, sweep);
    return lookInto(surface, query, reach, sweep, points);
}

SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                           const SearchReach& reach, const ProvenBall& ball,
                           ClosestPointList& points) noexcept {
    if (ball.open.empty()) {
        return SearchProof::Nearest;
    }
    const ClosestPointList known = points;
    PartSearch search(surface, query, reach, points);
    CellsInBatches cells(surface, search);
    for (const CellIndex& cell : ball.open) {
        cells.take(cell);
    }
    cells.lookIntoCells();
    if (search.isComplete()) {
        return SearchProof::Nearest;
    }
    points = known;
    return completePoints(surface, query, reach, points);
}

SearchProof completePoints(const BSplineSurface& surface, const QueryBall& queries,
                           const SearchReach& reach, ClosestPointList& points,
                           ProvenBall& ball) noexcept {
    // A closest point follows its query, on most surfaces by little more than the query moves.
    constexpr double kWander = 1.0;
    const ClosestPoint& nearest = points.all().front();
    const Vector2 place = nearest.point.head<2>();
    const double wander = kWander * queries.radius;
    // The closest point of a query in the ball may lie one radius farther from it than that of the
    // center, and so may others that matter; from the center these lie one radius more.
    const double farthest =
        std::min(reach.farthest + queries.radius, reach.limit(nearest) + 2.0 * queries.radius);
    CellSweep sweep(surface, queries.center, farthest, queries.radius);
    ball.queries.radius = -1.0;
    if (!nearest.converged) {
        settleAround(points, sweep);
        return lookInto(surface, queries.center, reach, sweep, points);
    }
    CellsOfBall cells(surface, queries, farthest);
    if (!sweep.settle(sweep.window().blocksAround(place.x(), place.y(), wander))) {
        sweep.visit(cells);
        cells.sortOut();
    }
    if (cells.hasGivenUp()) {
        settleAround(points, sweep);
        return lookInto(surface, queries.center, reach, sweep, points);
    }
    ball = {.queries = queries,
            .reach = farthest,
            .anchor = {.low = place - Vector2::Constant(wander),
                       .high = place + Vector2::Constant(wander)},
            .open = cells.open()};
    return completePoints(surface, queries.center, reach, ball, points);
}

}  // namespace asperity
