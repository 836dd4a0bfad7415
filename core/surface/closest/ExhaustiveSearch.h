#pragma once

#include "core/Vector.h"
#include "core/surface/closest/BoundsWindow.h"
#include "core/surface/closest/Box.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/KnownParts.h"

#include <algorithm>
#include <bit>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <cstdlib>

namespace asperity {

class BSplineSurface;
class ClosestPointList;

/// Looks everywhere for closest points of `query`: local minima of its distance from the surface
/// within `reach`, and adds them to `points`, which holds at least one local closest point already.
///
/// Cells that lie too far, or around a known closest point where the distance can only grow, are
/// ruled out by their bounds; the others are quartered until the distance has no minimum in them,
/// or one that is found. @return Nearest: the list is complete, as far as it has room;
/// TooManyPoints: it need not be. Allocation-free, bounded, never throws.
[[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                                         const SearchReach& reach,
                                         ClosestPointList& points) noexcept;

/// All queries within some distance of one.
struct QueryBall {
    Vector3 center = Vector3::Zero();  ///< world [m]
    double radius = -1.0;              ///< < 0: no query [m]
};

/// Proof for all queries in a ball: one of them that has a closest point in `anchor` has no other
/// one within `reach` of the ball's center, but in the parts of cells that are left open.
struct ProvenBall {
    QueryBall queries;
    double reach = 0.0;  ///< [m]
    Box anchor;          ///< world [m]
    KnownParts open;

    /// Returns whether the proof covers a query whose nearest closest point known is this.
    [[nodiscard]] bool covers(const Vector3& query, const SearchReach& within,
                              const ClosestPoint& nearest) const noexcept;
};

/// The same for a query that a ball covers; what it finds out about the open parts is kept there.
[[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                                         const SearchReach& reach, ProvenBall& ball,
                                         ClosestPointList& points) noexcept;

/// The same for the query at the center of `queries`; @return in `ball` what is proven on the way
/// for all of them, with what is known already of its open parts. That is nothing where too many
/// are left open.
[[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const QueryBall& queries,
                                         const SearchReach& reach, ClosestPointList& points,
                                         ProvenBall& ball) noexcept;

/// Goes over the cells in which a query may have a closest point, by their bounds: leaves out those
/// that lie too far, and those around a known closest point where the distance can only grow.
/// Allocation-free.
class CellSweep {
public:
    /// @param distance how far a closest point may lie to matter [m]
    /// @param ball what is left out is left out for all queries within this distance of `query` [m]
    CellSweep(const BSplineSurface& surface, const Vector3& query, double distance,
              double ball = 0.0) noexcept
        : surface_(surface), query_(query), window_(surface, query, distance, ball) {}

    /// Leaves out what is settled around a local minimum, wherever in these blocks it lies.
    /// @return whether nothing is left
    bool settle(const WindowBlocks& blocks) noexcept;

    [[nodiscard]] const BoundsWindow& window() const noexcept { return window_; }

    /// The middle of the cell that may come nearest to the query, judged by the bounds of the
    /// blocks from the largest down: a good guess, no more [m].
    [[nodiscard]] Vector2 likeliestPosition() const noexcept;

    /// Calls search.take(CellIndex) for each cell that is left. search.limit() is how far a closest
    /// point may lie by now [m]; search.mayLook() whether there is time to look at one more block,
    /// and search.hasGivenUp() whether there is none for anything.
    template <class Search>
    void visit(Search& search) const {
        for (int row = 0; row < window_.rows().count; ++row) {
            for (BoundsWindow::Bits blocks = window_.reaching(row); blocks != 0;
                 blocks &= blocks - 1) {
                if (search.hasGivenUp()) {
                    return;
                }
                const int column = std::countr_zero(blocks);
                if (!isSettled(row, column) && window_.reaches(row, column, search.limit())) {
                    visitBlock(search, window_.level(), window_.rows().first + row,
                               window_.columns().first + column);
                }
            }
        }
    }

private:
    /// Everything whose offset from each of the blocks is at most `around`.
    struct Settled {
        WindowBlocks blocks;
        int around = -1;
    };

    template <class Search>
    void visitBlock(Search& search, int level, int row, int column) const {
        if (level == 0) {
            search.take({row, column});
            return;
        }
        constexpr int kFactor = CellBounds::kFactor;
        const CellBounds::Level& parts = surface_.bounds().level(level - 1);
        for (int i = row * kFactor; i < std::min((row + 1) * kFactor, parts.rows); ++i) {
            for (int j = column * kFactor; j < std::min((column + 1) * kFactor, parts.columns);
                 ++j) {
                if (reaches(level - 1, i, j, search.limit()) && search.mayLook()) {
                    visitBlock(search, level - 1, i, j);
                }
            }
        }
    }

    [[nodiscard]] bool reaches(int level, int row, int column, double distance) const noexcept {
        return squaredDistance(level, {.row = row, .column = column}) <= distance * distance;
    }
    /// Lower bound of a block's squared distance from the query [m^2].
    [[nodiscard]] double squaredDistance(int level, const CellIndex& block) const noexcept;
    [[nodiscard]] bool isSettled(int row, int column) const noexcept;

    const BSplineSurface& surface_;
    Vector3 query_;
    BoundsWindow window_;
    /// Around each closest point, and once more around the nearest, for a ball.
    boost::container::static_vector<Settled, kMaxMinima + 1> settled_;
};

}  // namespace asperity
