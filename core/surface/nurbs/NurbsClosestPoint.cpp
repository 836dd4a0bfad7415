#include "core/surface/nurbs/NurbsClosestPoint.h"

#include "core/surface/nurbs/NurbsDescent.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kMaxPieces = 2048;          // looked at for the proof: a millisecond or so
constexpr int kMorePieces = 256;          // looked at for other closest points
constexpr std::size_t kMaxWaiting = 112;  // pieces: two for each time that a patch can be halved
constexpr std::size_t kMaxBoxes = 128;
/// Unnoticed difference of distances, in roundings of a position in space.
constexpr double kCertainNoise = 256.0;
/// A piece this small, in parameters, cannot be cut.
constexpr double kMinPiece = 1e-15;

double square(double x) { return x * x; }

/// A piece of a patch, seen from the query.
struct Piece {
    BezierNet net;
    Box box;  ///< of (u, v)
    int patch = 0;

    [[nodiscard]] Vector2 middle() const { return 0.5 * (box.low + box.high); }
    [[nodiscard]] Vector2 width() const { return box.high - box.low; }
};

/// A position of a piece and how far from the query it is.
struct NearPoint {
    Vector2 uv = Vector2::Zero();  ///< (u, v)
    double distance = 0.0;         ///< [m]
};

/// The nearest one of the middle and the four corners.
NearPoint nearestSample(const Piece& piece) {
    NearPoint nearest{.uv = piece.middle(), .distance = piece.net.sample(0.5, 0.5).point.norm()};
    for (const int i : {0, piece.net.degreeU}) {
        for (const int j : {0, piece.net.degreeV}) {
            const double distance = piece.net.position(i, j).norm();
            if (distance < nearest.distance) {
                nearest = {.uv = Vector2((i == 0 ? piece.box.low : piece.box.high)[0],
                                         (j == 0 ? piece.box.low : piece.box.high)[1]),
                           .distance = distance};
            }
        }
    }
    return nearest;
}

Box boxOf(const NurbsPatch& patch) {
    return {.low = Vector2(patch.lowU, patch.lowV), .high = Vector2(patch.highU, patch.highV)};
}

/// Length of the control net along u and along v [m].
Vector2 extentOf(const BezierNet& net) {
    Vector2 extent = Vector2::Zero();
    for (int j = 0; j <= net.degreeV; ++j) {
        double length = 0.0;
        for (int i = 0; i < net.degreeU; ++i) {
            length += (net.position(i + 1, j) - net.position(i, j)).norm();
        }
        extent[0] = std::max(extent[0], length);
    }
    for (int i = 0; i <= net.degreeU; ++i) {
        double length = 0.0;
        for (int j = 0; j < net.degreeV; ++j) {
            length += (net.position(i, j + 1) - net.position(i, j)).norm();
        }
        extent[1] = std::max(extent[1], length);
    }
    return extent;
}

}  // namespace

/// One query: keeps the closest points found so far and goes through what they do not rule out.
class NurbsClosestPointSearch {
public:
    NurbsClosestPointSearch(const NurbsSurface& surface, const Vector3& query,
                            const NurbsClosestPointWish& wish)
        : surface_(surface)
        , query_(query)
        , wish_(wish)
        , descent_(surface, query)
        , certain_(kCertainNoise * std::numeric_limits<double>::epsilon() *
                   (surface.scale() + query.lpNorm<Eigen::Infinity>())) {}

    NurbsClosestPoints run() {
        descend(middleOfNearestPatch());
        const bool complete = searchBoxes();
        if (complete && !minima_.front().converged) {
            settleOnCrease();
        }
        bool listed = true;
        if (complete && wish_.within > best()) {
            within_ = wish_.within;
            mostPieces_ = points_.pieces_ + kMorePieces;
            listed = searchBoxes();
        }
        for (std::size_t i = 0; i < count_; ++i) {
            if (i == 0 || minima_[i].distance <= wish_.within) {
                points_.points_[points_.count_++] = closestPointOf(minima_[i]);
            }
        }
        ClosestPoint& nearest = points_.points_.front().closest;
        nearest.iterations = iterations_;
        nearest.proof = proofOf(nearest, complete);
        points_.proof_ = listed && !hasLeftOut_ ? nearest.proof : SearchProof::TooManyPoints;
        return points_;
    }

    /// The answer to a query that is no point: a surface point, and the word that it means nothing.
    static NurbsClosestPoints meaningless(const NurbsSurface& surface) {
        NurbsClosestPoints points;
        NurbsClosestPoint& closest = points.points_.front();
        closest.u = closest.v = 0.5;
        closest.closest.point = surface.at(closest.u, closest.v).point;
        closest.closest.normal = surface.normal(closest.u, closest.v);
        closest.closest.curvatures = surface.curvatures(closest.u, closest.v);
        closest.closest.insideScan = false;
        closest.closest.proof = points.proof_ = SearchProof::NotConverged;
        points.count_ = 1;
        return points;
    }

private:
    [[nodiscard]] double best() const { return minima_.front().distance; }
    /// Squared distance from which on nothing is nearer than the best closest point, to rounding
    /// [m^2].
    [[nodiscard]] double proven() const { return square(std::max(0.0, best() - certain_)); }
    /// Squared distance from which on nothing is of interest [m^2].
    [[nodiscard]] double beyond() const { return within_ > best() ? square(within_) : proven(); }

    [[nodiscard]] Vector2 middleOfNearestPatch() const {
        const auto boxes = surface_.boxes();
        const PatchBox* box = &surface_.bounds();
        while (box->patch < 0) {
            const PatchBox& first = boxes[static_cast<std::size_t>(box->first)];
            const PatchBox& second = boxes[static_cast<std::size_t>(box->second)];
            box = second.squaredDistance(query_) < first.squaredDistance(query_) ? &second : &first;
        }
        const NurbsPatch& patch = surface_.patches()[static_cast<std::size_t>(box->patch)];
        return {0.5 * (patch.lowU + patch.highU), 0.5 * (patch.lowV + patch.highV)};
    }

    void descend(const Vector2& start) {
        const NurbsMinimum found = descent_.from(start);
        iterations_ += found.iterations;
        take(found);
    }

    /// Keeps the minima in order of their distance, the nearest one first.
    void take(const NurbsMinimum& found) {
        const Vector3 point = surface_.at(found.position.x(), found.position.y()).point;
        for (std::size_t i = 0; i < count_; ++i) {
            const Vector2& position = minima_[i].position;
            const Vector3 known = surface_.at(position.x(), position.y()).point;
            if ((known - point).norm() <= wish_.sameWithin) {
                if (isBetter(found, minima_[i])) {
                    minima_[i] = found;
                    sort();
                }
                return;
            }
        }
        if (count_ < wanted()) {
            minima_[count_++] = found;
        } else {
            NurbsMinimum& last = minima_[count_ - 1];
            hasLeftOut_ |= std::max(found.distance, last.distance) <= wish_.within;
            if (found.distance < last.distance) {
                last = found;
            }
        }
        sort();
    }

    /// Returns whether `a` is nearer or, at the same position, the search that converged.
    [[nodiscard]] bool isBetter(const NurbsMinimum& a, const NurbsMinimum& b) const {
        const bool asNear = std::abs(a.distance - b.distance) <= certain_;
        return asNear && a.converged != b.converged ? a.converged : a.distance < b.distance;
    }

    [[nodiscard]] std::size_t wanted() const { return wish_.within > 0.0 ? kMaxContactPoints : 1; }

    void sort() {
        std::sort(
            minima_.begin(), minima_.begin() + static_cast<std::ptrdiff_t>(count_),
            [](const NurbsMinimum& a, const NurbsMinimum& b) { return a.distance < b.distance; });
    }

    /// Returns whether all that could hold a point of interest was looked through.
    bool searchBoxes() {
        const auto boxes = surface_.boxes();
        boost::container::static_vector<int, kMaxBoxes> waiting;
        waiting.push_back(static_cast<int>(boxes.size()) - 1);
        while (!waiting.empty()) {
            const PatchBox& box = boxes[static_cast<std::size_t>(waiting.back())];
            waiting.pop_back();
            if (box.squaredDistance(query_) >= beyond()) {
                continue;
            }
            if (box.patch >= 0) {
                if (!searchPatch(box.patch)) {
                    return false;
                }
                continue;
            }
            const bool firstIsNearer =
                boxes[static_cast<std::size_t>(box.first)].squaredDistance(query_) <=
                boxes[static_cast<std::size_t>(box.second)].squaredDistance(query_);
            waiting.push_back(firstIsNearer ? box.second : box.first);
            waiting.push_back(firstIsNearer ? box.first : box.second);
        }
        return true;
    }

    bool searchPatch(int index) {
        const NurbsPatch& patch = surface_.patches()[static_cast<std::size_t>(index)];
        boost::container::static_vector<Piece, kMaxWaiting> waiting;
        waiting.push_back({.net = patch.net.seenFrom(query_), .box = boxOf(patch), .patch = index});
        while (!waiting.empty()) {
            const Piece piece = waiting.back();
            waiting.pop_back();
            if (isSettled(piece)) {
                continue;
            }
            const bool canBeCut = piece.width().maxCoeff() > kMinPiece;
            if (!canBeCut || points_.pieces_ >= mostPieces_ || waiting.size() + 2 > kMaxWaiting) {
                return false;
            }
            cut(piece, waiting);
        }
        return true;
    }

    template <class Waiting>
    static void cut(const Piece& piece, Waiting& waiting) {
        const Vector2 extent = extentOf(piece.net);
        const Vector2 width = piece.width();
        // An extent of 0 has nothing to be cut, however wide it is in parameters.
        const int axis = extent[0] > extent[1] && width[0] > kMinPiece ? 0 : 1;
        const BezierHalves halves = axis == 0 ? halvedAlongU(piece.net) : halvedAlongV(piece.net);
        Box low = piece.box;
        Box high = piece.box;
        low.high[axis] = high.low[axis] = piece.middle()[axis];
        waiting.push_back({.net = halves.low, .box = low, .patch = piece.patch});
        waiting.push_back({.net = halves.high, .box = high, .patch = piece.patch});
    }

    /// Returns whether nothing in the piece can change the answer any more.
    bool isSettled(const Piece& piece) {
        ++points_.pieces_;
        const SquaredDistanceNet bound(piece.net, certain_ / kCertainNoise);
        if (beyond() == 0.0 || bound.isAtLeast(beyond())) {
            return true;
        }
        if (bound.isConvex(square(best()), slackAt(best())) && minimumSettles(piece, bound)) {
            return true;
        }
        const bool isSmall = within_ > best() && extentOf(piece.net).maxCoeff() <= wish_.sameWithin;
        lookAt(piece, isSmall);
        return isSmall;
    }

    /// By how much the excess over a squared distance may fall short of being convex [m^2].
    [[nodiscard]] double slackAt(double distance) const {
        const double spare = 0.5 * (square(distance) - proven());
        return within_ > best() ? std::min(spare, distance * certain_) : spare;
    }

    /// A piece whose squared distance is convex (in the sense of SquaredDistanceNet) has one
    /// minimum. Once that is known, nothing in it is nearer.
    bool minimumSettles(const Piece& piece, const SquaredDistanceNet& bound) {
        const Vector2 start = piece.box.nearest(minima_.front().position);
        const NurbsMinimum minimum = descent_.within(piece.patch, piece.box, start);
        iterations_ += minimum.iterations;
        if (minimum.distance < best() - certain_ || minimum.distance <= within_) {
            descend(minimum.position);
        }
        return minimum.converged && minimum.distance >= best() - certain_ &&
               bound.isConvex(square(minimum.distance), slackAt(minimum.distance));
    }

    /// On a crease the gradient vanishes nowhere, but there is a minimum of the patch beside it,
    /// which is that of the surface since no other position is nearer.
    void settleOnCrease() {
        const Vector2 position = minima_.front().position;
        const int index = surface_.patchAt(position.x(), position.y());
        const NurbsPatch& patch = surface_.patches()[static_cast<std::size_t>(index)];
        NurbsMinimum minimum = descent_.within(index, boxOf(patch), position);
        bool atEdge = false;
        for (int axis = 0; axis < 2; ++axis) {
            const bool isEdge = minimum.position[axis] == 0.0 || minimum.position[axis] == 1.0;
            atEdge |= isEdge && !surface_.closed()[static_cast<std::size_t>(axis)];
        }
        minimum.pushedOut &= atEdge;
        if (minimum.distance <= best() + certain_) {
            take(minimum);
        }
    }

    /// Starts a search from the piece where that is nearer than the best closest point, or
    /// where another closest point may be and the piece is too small to be cut for it.
    void lookAt(const Piece& piece, bool isSmall) {
        const auto [uv, distance] = nearestSample(piece);
        if (distance < best() - certain_ || (isSmall && distance <= within_)) {
            descend(uv);
        }
    }

    [[nodiscard]] NurbsClosestPoint closestPointOf(const NurbsMinimum& minimum) const {
        NurbsClosestPoint closest{
            .closest = {}, .u = minimum.position.x(), .v = minimum.position.y()};
        closest.closest.point = surface_.at(closest.u, closest.v).point;
        closest.closest.normal = surface_.normal(closest.u, closest.v);
        closest.closest.curvatures = surface_.curvatures(closest.u, closest.v);
        const Vector3 towardsQuery = query_ - closest.closest.point;
        closest.closest.distance =
            std::copysign(towardsQuery.norm(), towardsQuery.dot(closest.closest.normal));
        closest.closest.iterations = minimum.iterations;
        closest.closest.converged = minimum.converged;
        closest.closest.insideScan = !minimum.pushedOut;
        return closest;
    }

    [[nodiscard]] static SearchProof proofOf(const ClosestPoint& closest, bool complete) {
        if (!closest.converged) {
            return SearchProof::NotConverged;
        }
        return complete && !isFocal(closest) ? SearchProof::Nearest : SearchProof::TooManyPoints;
    }

    /// Returns whether the distance grows less than to the second order around the closest point.
    [[nodiscard]] static bool isFocal(const ClosestPoint& closest) {
        const auto isCenter = [&](double curvature) {
            return std::abs(1.0 + curvature * closest.distance) <= kSameDistance;
        };
        return closest.insideScan &&
               (isCenter(closest.curvatures.largest) || isCenter(closest.curvatures.smallest));
    }

    const NurbsSurface& surface_;
    Vector3 query_;
    NurbsClosestPointWish wish_;
    NurbsDescent descent_;
    double certain_;       ///< [m]
    double within_ = 0.0;  ///< what is farther than this and than the best closest point is out [m]
    int mostPieces_ = kMaxPieces;
    std::array<NurbsMinimum, kMaxContactPoints> minima_{};
    std::size_t count_ = 0;
    bool hasLeftOut_ = false;  ///< a closest point within the wish had no room
    int iterations_ = 0;
    NurbsClosestPoints points_;
};

NurbsClosestPoints nearestPoints(const NurbsSurface& surface, const Vector3& query,
                                 const NurbsClosestPointWish& wish) noexcept {
    const auto isUsable = [](double coordinate) {
        return std::isless(std::abs(coordinate), kMaxQueryDistance);
    };
    if (!isUsable(query.x()) || !isUsable(query.y()) || !isUsable(query.z())) {
        return NurbsClosestPointSearch::meaningless(surface);
    }
    return NurbsClosestPointSearch(surface, query, wish).run();
}

ClosestPoint closestPoint(const NurbsSurface& surface, const Vector3& query,
                          const SearchGuess& /*guess*/) noexcept {
    return nearestPoints(surface, query, {}).nearest().closest;
}

}  // namespace asperity
