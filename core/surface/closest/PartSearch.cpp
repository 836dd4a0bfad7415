#include "core/surface/closest/PartSearch.h"

#include <array>
#include <bit>
#include <limits>

namespace asperity {

namespace {

/// Nearer than this to the scan's edge is at it [pixel].
constexpr double kEdge = 1e-9;

/// Behavior of the distance along one axis, anywhere in a part.
enum class Course : std::uint8_t {
    Unclear,
    Falls,        ///< towards a side, and goes on falling behind it: no minimum in the part
    FallsToEdge,  ///< towards a side that is the scan's edge: a minimum can only lie on it
};
using Courses = std::array<Course, 2>;

Courses coursesIn(const Part& part, const Box& box, const Box& scan) {
    Courses courses{};
    for (int axis = 0; axis < 2; ++axis) {
        const double slope = part.gradient[axis];
        if (std::abs(slope) > part.spread[axis]) {
            const bool atEdge =
                slope > 0.0 ? box.low[axis] <= scan.low[axis] : box.high[axis] >= scan.high[axis];
            courses[static_cast<std::size_t>(axis)] = atEdge ? Course::FallsToEdge : Course::Falls;
        }
    }
    return courses;
}

/// Returns whether the scan's edge leaves a minimum one position in the part at most.
bool isConvexAtEdge(const Part& part, const Courses& courses) {
    const bool heldX = courses[0] == Course::FallsToEdge;
    const bool heldY = courses[1] == Course::FallsToEdge;
    return (heldX && (heldY || part.bend.y() > 0.0)) || (heldY && part.bend.x() > 0.0);
}

/// Returns whether a part lies off the scan's edge, so that a minimum in it needs a level gradient
/// and a distance that bends up.
bool isInside(const Box& box, const Box& scan) {
    return box.low.x() > scan.low.x() && box.low.y() > scan.low.y() &&
           box.high.x() < scan.high.x() && box.high.y() < scan.high.y();
}

/// Parts of cells that are looked into before a search gives up.
constexpr int kMaxLooks = 2048;
/// A part of a cell smaller than this says no more than rounding does [pixel].
constexpr double kMinPart = 0x1p-14;
/// Half the size below which a part that holds one minimum at most is searched for it; quartering
/// a larger one mostly shows sooner that it holds none [pixel].
constexpr double kWorthASearch = 0.2;
/// As BoxNewton allows.
constexpr double kEdgeNoise = 32.0;

}  // namespace

Box boxOf(const Part& part, const BSplineSurface& surface) noexcept {
    const Box scan = scanBox(surface);
    const Vector2 near(kEdge * surface.grid().pitchX, kEdge * surface.grid().pitchY);
    Box box{.low = part.center - part.half, .high = part.center + part.half};
    for (int axis = 0; axis < 2; ++axis) {
        box.low[axis] =
            box.low[axis] <= scan.low[axis] + near[axis] ? scan.low[axis] : box.low[axis];
        box.high[axis] =
            box.high[axis] >= scan.high[axis] - near[axis] ? scan.high[axis] : box.high[axis];
    }
    return box;
}

MinimaIn minimaIn(const Part& part, const Box& box, const BSplineSurface& surface) noexcept {
    const Box scan = scanBox(surface);
    if (isInside(box, scan)) {
        if (part.withoutMinimum) {
            return MinimaIn::None;
        }
        return part.convex ? MinimaIn::OneAtMost : MinimaIn::Unknown;
    }
    const Courses courses = coursesIn(part, box, scan);
    if (std::ranges::count(courses, Course::Falls) > 0) {
        return MinimaIn::None;
    }
    return part.convex || isConvexAtEdge(part, courses) ? MinimaIn::OneAtMost : MinimaIn::Unknown;
}

PartSearch::PartSearch(const BSplineSurface& surface, const Vector3& query,
                       const SearchReach& reach, ClosestPointList& points) noexcept
    : surface_(surface)
    , query_(query)
    , reach_(reach)
    , points_(points)
    , pitch_(surface.grid().pitchX, surface.grid().pitchY)
    , objective_(surface, query)
    , rounding_(roundingOf(surface, query)) {}

double PartSearch::nearest() const {
    return std::min(std::abs(points_.all().front().distance), nearestDescent());
}

/// No closest point that is nearest lies farther [m]. It may be as near as the best descent's
/// end, to any rounding.
double PartSearch::nearestDescent() const {
    constexpr double kRoom = 1.0 + 1e-6;
    return nearestDescent_ ? kRoom * std::sqrt(2.0 * nearestDescent_->model.value)
                           : std::numeric_limits<double>::infinity();
}

double PartSearch::limit() const noexcept { return reach_.limit(nearest()); }

bool PartSearch::isComplete() const noexcept {
    return complete_ && (std::abs(points_.all().front().distance) <= nearestDescent() ||
                         nearestDescent() > reach_.farthest);
}

bool PartSearch::mayLook() noexcept {
    ++looks_;
    return !hasGivenUp();
}

bool PartSearch::hasGivenUp() noexcept {
    const bool givenUp = looks_ > kMaxLooks || evaluations_ >= kMaxEvaluations;
    complete_ = complete_ && !givenUp;
    return givenUp;
}

BoxMinimum PartSearch::descend(const Box& box, const Vector2& start, double escapeStep) {
    BoxMinimum minimum =
        BoxNewton<HalfSquaredDistance>(objective_, box, escapeStep).minimize(start);
    evaluations_ += minimum.evaluations;
    return minimum;
}

void PartSearch::lookInto(const PartBatch& batch, unsigned lanes) noexcept {
    PartFacts facts;
    for (unsigned left = unclearIn(batch, lanes, facts); left != 0 && mayLook(); left &= left - 1) {
        PartBatch quarters;
        quarter(batch, std::countr_zero(left), quarters);
        lookInto(quarters, PartBatch::kAllLanes);
    }
}

void PartSearch::lookInto(KnownParts& parts) noexcept {
    boost::container::static_vector<std::size_t, PartBatch::kLanes> indices;
    const auto flush = [&] {
        if (!indices.empty()) {
            lookInto({indices.data(), indices.size()}, parts);
            indices.clear();
        }
    };
    // Those that are split off on the way are looked into with the part that they belong to.
    for (const std::size_t part : parts.due(query_, (1.0 - kSameDistance) * limit())) {
        if (hasGivenUp()) {
            return;
        }
        if (!holdsKnownPointAlone(parts, part)) {
            indices.push_back(part);
        }
        if (indices.size() == PartBatch::kLanes) {
            flush();
        }
    }
    flush();
}

/// Returns whether a part has a known closest point, and has room for no other.
bool PartSearch::holdsKnownPointAlone(const KnownParts& parts, std::size_t part) const {
    return parts.isConvex(part, query_) &&
           std::ranges::any_of(points_.all(), [&](const ClosestPoint& closest) {
               return closest.converged &&
                      parts.at(part).contains(surface_.grid(), closest.point.head<2>());
           });
}

void PartSearch::lookInto(std::span<const std::size_t> indices, KnownParts& parts) {
    boost::container::static_vector<CellPart, PartBatch::kLanes> cellParts;
    for (const std::size_t index : indices) {
        cellParts.push_back(parts.at(index));
    }
    PartBatch batch;
    loadParts(surface_.grid(), {cellParts.data(), cellParts.size()}, batch);
    lookInto(batch, indices, parts);
}

/// @param indices of the batch's parts among those known
void PartSearch::lookInto(const PartBatch& batch, std::span<const std::size_t> indices,
                          KnownParts& parts) {
    PartFacts facts;
    const unsigned unclear = unclearIn(batch, (1U << indices.size()) - 1U, facts);
    for (std::size_t lane = 0; lane < indices.size(); ++lane) {
        parts.note(indices[lane], query_, facts, static_cast<int>(lane));
    }
    for (unsigned left = unclear; left != 0 && mayLook(); left &= left - 1) {
        const int lane = std::countr_zero(left);
        PartBatch quarters;
        quarter(batch, lane, quarters);
        if (const auto split = parts.split(indices[static_cast<std::size_t>(lane)])) {
            lookInto(quarters, *split, parts);
        } else {
            lookInto(quarters, PartBatch::kAllLanes);
        }
    }
}

/// Looks at the parts of a batch; @return those that need a closer look.
unsigned PartSearch::unclearIn(const PartBatch& batch, unsigned lanes, PartFacts& facts) {
    constexpr double kNearEnough = 1.0 - 2.0 * kSameDistance;
    examine(batch,
            {.point = query_ - Vector3(0.0, 0.0, surface_.grid().datum),
             .rounding = rounding_,
             .limit = 0.5 * limit() * limit() * kNearEnough,
             .scan = scanBox(surface_)},
            facts);
    unsigned unclear = 0;
    for (unsigned left = lanes & ~facts.far; left != 0 && !hasGivenUp(); left &= left - 1) {
        const Part part(batch, facts, std::countr_zero(left));
        lowerLimit(part);
        const Box box = boxOf(part, surface_);
        const MinimaIn minima = minimaIn(part, box, surface_);
        const bool oneAtMost = minima == MinimaIn::OneAtMost;
        if (minima == MinimaIn::None || (oneAtMost && holdsKnownPoint(part))) {
            continue;
        }
        const double size = part.half.cwiseQuotient(pitch_).maxCoeff();
        if (oneAtMost && size < kWorthASearch) {
            findIn(part, box);
        } else if (size < 0.5 * kMinPart) {
            complete_ = false;
        } else {
            unclear |= left & -left;
        }
    }
    return unclear;
}

/// A position nearer than the closest point known leads to one that rules out more. It is not taken
/// up here, so that what comes out does not depend on the order in which parts are looked at.
void PartSearch::lowerLimit(const Part& part) {
    constexpr double kWorthwhile = 0.999;
    if (part.value >= kWorthwhile * 0.5 * nearest() * nearest()) {
        return;
    }
    take(descend(scanBox(surface_), part.center, 0.25 * pitch_.minCoeff()));
}

/// Between walls a descent creeps until its steps run out; where it got to still rules out what is
/// farther, and spares the descents from all other parts that would end no nearer.
void PartSearch::take(const BoxMinimum& minimum) {
    if (!nearestDescent_ || minimum.model.value < nearestDescent_->model.value) {
        nearestDescent_ = minimum;
    }
}

void PartSearch::settleForNearest(const Vector2& start) noexcept {
    take(descend(scanBox(surface_), start, 0.25 * pitch_.minCoeff()));
    if (nearestDescent() < std::abs(points_.all().front().distance)) {
        points_.add(closestPointOf(*nearestDescent_, query_), 0.0);
    }
}

bool PartSearch::holdsKnownPoint(const Part& part) const {
    return std::ranges::any_of(points_.all(), [&](const ClosestPoint& closest) {
        return closest.converged && part.contains(closest.point.head<2>(), sameMinimum(surface_));
    });
}

/// Takes up the only minimum that a part can hold, if it does hold one.
void PartSearch::findIn(const Part& part, const Box& box) {
    const BoxMinimum minimum = descend(box, part.center, 0.0);
    if (!minimum.converged) {
        complete_ = false;
        return;
    }
    if (minimum.pushedOut && !isPushedOutOfScan(minimum, box)) {
        return;
    }
    if (minimum.model.value <= 0.5 * limit() * limit() && !isKnown(minimum)) {
        points_.add(closestPointOf(fromItsSurroundings(minimum), query_), sameMinimum(surface_));
    }
}

bool PartSearch::isKnown(const BoxMinimum& minimum) const {
    return std::ranges::any_of(points_.all(), [&](const ClosestPoint& closest) {
        return (closest.point.head<2>() - minimum.position).norm() <= sameMinimum(surface_);
    });
}

/// The same minimum, descended to from a position that depends on the minimum alone: which part it
/// was found in, and from where, changes no bit of it.
BoxMinimum PartSearch::fromItsSurroundings(const BoxMinimum& minimum) {
    // Between a minimum and a saddle close by, only a start as close leads back.
    for (const double stepsInPixel : {0x1p6, 0x1p10, 0x1p14, 0x1p20}) {
        BoxMinimum again;
        for (int axis = 0; axis < 2; ++axis) {
            const double grid = pitch_[axis] / stepsInPixel;
            again.position[axis] = std::round(minimum.position[axis] / grid) * grid;
        }
        const Vector2 start = again.position;
        const bool isBeside = findMinimumBeside(surface_, query_, again);
        evaluations_ += again.iterations;
        if (!isBeside) {
            again = descend(scanBox(surface_), start, 0.0);
        }
        if (again.converged &&
            (again.position - minimum.position).norm() <= sameMinimum(surface_)) {
            return again;
        }
    }
    return minimum;
}

/// Returns whether every side of `box` that holds the minimum back is a side of the scan.
bool PartSearch::isPushedOutOfScan(const BoxMinimum& minimum, const Box& box) const {
    const Box scan = scanBox(surface_);
    for (int axis = 0; axis < 2; ++axis) {
        const double slope = minimum.model.gradient[axis];
        const bool pushes = std::abs(slope) > kEdgeNoise * minimum.model.gradientNoise[axis];
        const bool low = slope > 0.0 && minimum.position[axis] <= box.low[axis];
        const bool high = slope < 0.0 && minimum.position[axis] >= box.high[axis];
        if (pushes && ((low && box.low[axis] > scan.low[axis]) ||
                       (high && box.high[axis] < scan.high[axis]))) {
            return false;
        }
    }
    return true;
}

}  // namespace asperity
