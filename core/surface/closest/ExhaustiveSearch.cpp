#include "core/surface/closest/ExhaustiveSearch.h"

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/PartSearch.h"

#include <cmath>
#include <limits>

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

/// The cells that a sweep names for a ball of queries.
class CellsOfBall {
public:
    /// @param farthest how far from the ball's center a closest point may lie to matter [m]
    CellsOfBall(const BoundsWindow& window, double farthest)
        : cells_({.row = window.rows().first, .column = window.columns().first})
        , farthest_(farthest) {}

    [[nodiscard]] double limit() const { return farthest_; }
    [[nodiscard]] bool mayLook() const { return true; }
    [[nodiscard]] bool hasGivenUp() const { return false; }
    void take(const CellIndex& cell) { cells_.add(cell); }

    [[nodiscard]] const CellSet& all() const { return cells_; }

private:
    CellSet cells_;
    double farthest_;
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
    search.settleForNearest(sweep.likeliestPosition());
    return SearchProof::TooManyPoints;
}

/// Returns whether few enough parts are left open for all queries in a ball. Apart, so that its
/// window is gone before the open parts are looked into.
[[gnu::noinline]] bool proveBall(const BSplineSurface& surface, const QueryBall& queries,
                                 const SearchReach& reach, const ClosestPoint& nearest,
                                 ProvenBall& ball) {
    // A closest point follows its query, on most surfaces by little more than the query moves.
    constexpr double kWander = 1.0;
    const Vector2 position = nearest.point.head<2>();
    const double wander = kWander * queries.radius;
    // The closest point of a query in the ball may lie one radius farther from it than that of the
    // center, and so may others that matter; from the center these lie one radius more.
    const double farthest =
        std::min(reach.farthest + queries.radius, reach.limit(nearest) + 2.0 * queries.radius);
    CellSweep sweep(surface, queries.center, farthest, queries.radius);
    const BoundsWindow& window = sweep.window();
    CellsOfBall cells(window, farthest);
    if (!sweep.settle(window.blocksAround(position.x(), position.y(), wander))) {
        if (window.level() > 0) {
            return false;
        }
        sweep.visit(cells);
    }
    ball.queries = queries;
    ball.reach = farthest;
    ball.anchor = {.low = position - Vector2::Constant(wander),
                   .high = position + Vector2::Constant(wander)};
    return ball.open.keepCells(cells.all(), queries.center);
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
                           const SearchReach& reach, ProvenBall& ball,
                           ClosestPointList& points) noexcept {
    if (ball.open.empty()) {
        return SearchProof::Nearest;
    }
    const ClosestPointList known = points;
    PartSearch search(surface, query, reach, points);
    search.lookInto(ball.open);
    if (search.isComplete()) {
        return SearchProof::Nearest;
    }
    ball = {};
    points = known;
    return completePoints(surface, query, reach, points);
}

SearchProof completePoints(const BSplineSurface& surface, const QueryBall& queries,
                           const SearchReach& reach, ClosestPointList& points,
                           ProvenBall& ball) noexcept {
    const ClosestPoint& nearest = points.all().front();
    if (!nearest.converged || !proveBall(surface, queries, reach, nearest, ball)) {
        ball = {};
        return completePoints(surface, queries.center, reach, points);
    }
    return completePoints(surface, queries.center, reach, ball, points);
}

bool CellSweep::settle(const WindowBlocks& blocks) noexcept {
    int around = BoundsWindow::kMaxBlocks;
    for (int row = blocks.rows.first; row < blocks.rows.end(); ++row) {
        for (int column = blocks.columns.first; column < blocks.columns.end(); ++column) {
            around = std::min(around, window_.settledAround(row, column));
        }
    }
    settled_.push_back({blocks, around});
    return around == BoundsWindow::kMaxBlocks;
}

bool CellSweep::isSettled(int row, int column) const noexcept {
    const auto farthest = [](const BlockRun& run, int at) {
        return std::max(std::abs(at - run.first), std::abs(at - (run.end() - 1)));
    };
    return std::ranges::any_of(settled_, [&](const Settled& settled) {
        return std::max(farthest(settled.blocks.rows, row),
                        farthest(settled.blocks.columns, column)) <= settled.around;
    });
}

double CellSweep::squaredDistance(int level, const CellIndex& block) const noexcept {
    const BoxBounds bounds = surface_.bounds().at(level, block.row, block.column);
    const double away = std::max({query_.z() - bounds.highest, bounds.lowest - query_.z(), 0.0});
    return blocksAlongX(surface_, level).squaredDistance(query_.x(), block.column) +
           blocksAlongY(surface_, level).squaredDistance(query_.y(), block.row) + away * away;
}

Vector2 CellSweep::likeliestPosition() const noexcept {
    constexpr int kFactor = CellBounds::kFactor;
    CellIndex nearest;
    for (int level = surface_.bounds().levels() - 2; level >= 0; --level) {
        const CellBounds::Level& parts = surface_.bounds().level(level);
        const CellIndex first{.row = nearest.row * kFactor, .column = nearest.column * kFactor};
        const CellIndex end{.row = std::min(first.row + kFactor, parts.rows),
                            .column = std::min(first.column + kFactor, parts.columns)};
        double least = std::numeric_limits<double>::infinity();
        for (CellIndex part = first; part.row < end.row; ++part.row) {
            for (part.column = first.column; part.column < end.column; ++part.column) {
                const double squared = squaredDistance(level, part);
                if (squared < least) {
                    least = squared;
                    nearest = part;
                }
            }
        }
    }
    const BlockAxis x = blocksAlongX(surface_, 0);
    const BlockAxis y = blocksAlongY(surface_, 0);
    return {0.5 * (x.low(nearest.column) + x.high(nearest.column)),
            0.5 * (y.low(nearest.row) + y.high(nearest.row))};
}

}  // namespace asperity
