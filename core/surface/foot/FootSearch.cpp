#include "core/surface/foot/FootSearch.h"

#include "core/surface/foot/BoundsWindow.h"
#include "core/surface/foot/LocalFoot.h"
#include "core/surface/foot/PartBatch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstdint>

namespace asperity {

namespace {

/// Parts of cells that are looked into before a search gives up.
constexpr int kMostParts = 2048;
/// A part of a cell smaller than this says no more than rounding does [pixel].
constexpr double kSmallestPart = 0x1p-14;
/// Half the size below which a part that holds one minimum at most is searched for it; quartering
/// a larger one mostly shows sooner that it holds none [pixel].
constexpr double kWorthASearch = 0.2;
/// Two minima found from different starts are one when they are nearer than this [pixel].
constexpr double kSameMinimum = 1e-4;

/// One part of a batch, as the search around it sees it.
struct Part {
    Vector2 centre = Vector2::Zero();    ///< world [m]
    Vector2 half = Vector2::Zero();      ///< half its size [m]
    double value = 0.0;                  ///< half the squared distance of its centre [m^2]
    Vector2 gradient = Vector2::Zero();  ///< of that [m]
    Vector2 spread = Vector2::Zero();    ///< by which it differs elsewhere in the part [m]
    Vector2 bend = Vector2::Zero();      ///< its least second derivatives along x and y

    Part(const PartBatch& batch, const PartFacts& facts, int lane)
        : centre(batch.centreX[lane], batch.centreY[lane])
        , half(batch.halfX[lane], batch.halfY[lane])
        , value(facts.value[lane])
        , gradient(facts.gradientX[lane], facts.gradientY[lane])
        , spread(facts.spreadX[lane], facts.spreadY[lane])
        , bend(facts.bendX[lane], facts.bendY[lane]) {}

    [[nodiscard]] bool contains(const Vector2& place, double margin) const {
        return std::abs(place.x() - centre.x()) <= half.x() + margin &&
               std::abs(place.y() - centre.y()) <= half.y() + margin;
    }
};

class GlobalSearch {
public:
    GlobalSearch(const BSplineSurface& surface, const Vector3& query, const FootReach& reach,
                 FootList& feet)
        : surface_(surface)
        , query_(query)
        , reach_(reach)
        , feet_(feet)
        , pitch_(surface.grid().pitchX, surface.grid().pitchY)
        , objective_(surface, query)
        , rounding_(roundingOf(surface, query)) {}

    FootProof run() {
        const BoundsWindow window(surface_, query_, limit());
        settle(window);
        for (int row = 0; row < window.rows().count; ++row) {
            for (std::uint32_t blocks = window.reaching(row); blocks != 0; blocks &= blocks - 1) {
                const int column = std::countr_zero(blocks);
                if (!isSettled(row, column) && window.reaches(row, column, limit())) {
                    lookIntoBlock(window.level(), window.rows().first + row,
                                  window.columns().first + column);
                }
            }
        }
        if (!cells_.empty()) {
            lookIntoCells();
        }
        return complete_ ? FootProof::Nearest : FootProof::ManyFeet;
    }

private:
    /// Blocks around a foot that need no look, see BoundsWindow::settledAround().
    struct Settled {
        int row = 0;
        int column = 0;
        int around = -1;
    };

    [[nodiscard]] double nearest() const { return std::abs(feet_.all().front().distance); }

    /// How far a foot may lie to matter [m].
    [[nodiscard]] double limit() const {
        return std::min(reach_.farthest, nearest() + reach_.behindNearest);
    }

    void settle(const BoundsWindow& window) {
        for (const SurfaceFoot& foot : feet_.all()) {
            if (!foot.converged) {
                continue;
            }
            const int around = window.settledAround(foot.point.x(), foot.point.y());
            settled_.push_back(
                {window.rowAt(foot.point.y()), window.columnAt(foot.point.x()), around});
            if (around == BoundsWindow::kMostBlocks) {
                return;
            }
        }
    }

    [[nodiscard]] bool isSettled(int row, int column) const {
        return std::ranges::any_of(settled_, [&](const Settled& around) {
            return std::max(std::abs(row - around.row), std::abs(column - around.column)) <=
                   around.around;
        });
    }

    /// Counts one more look; whether there is still time for it.
    bool mayLook() {
        ++looks_;
        complete_ = complete_ && looks_ <= kMostParts;
        return looks_ <= kMostParts;
    }

    void lookIntoBlock(int level, int row, int column) {
        if (level == 0) {
            lookIntoCell(row, column);
            return;
        }
        constexpr int kFactor = CellBounds::kFactor;
        const CellBounds::Level& parts = surface_.bounds().level(level - 1);
        for (int i = row * kFactor; i < std::min((row + 1) * kFactor, parts.rows); ++i) {
            for (int j = column * kFactor; j < std::min((column + 1) * kFactor, parts.columns);
                 ++j) {
                if (reaches(level - 1, i, j) && mayLook()) {
                    lookIntoBlock(level - 1, i, j);
                }
            }
        }
    }

    [[nodiscard]] bool reaches(int level, int row, int column) const {
        const BoxBounds bounds = surface_.bounds().at(level, row, column);
        const double away =
            std::max({query_.z() - bounds.highest, bounds.lowest - query_.z(), 0.0});
        return blocksAlongX(surface_, level).squaredDistance(query_.x(), column) +
                   blocksAlongY(surface_, level).squaredDistance(query_.y(), row) + away * away <=
               limit() * limit();
    }

    void lookIntoCell(int row, int column) {
        cells_.push_back({row, column});
        if (cells_.size() == cells_.capacity()) {
            lookIntoCells();
        }
    }

    /// Parts of a batch that are still to be quartered, a bit a lane.
    struct Waiting {
        PartBatch parts;
        unsigned lanes = 0;
    };

    /// Looks into the cells that have gathered: depth first, a batch a level.
    void lookIntoCells() {
        constexpr std::size_t kLevels = 17;
        static_assert(kSmallestPart * (1U << (kLevels - 1U)) >= 2.0);
        boost::container::static_vector<Waiting, kLevels> waiting(1,
                                                                  boost::container::default_init);
        loadCells(surface_.grid(), {cells_.data(), cells_.size()}, waiting.back().parts);
        waiting.back().lanes = unclearIn(waiting.back().parts, (1U << cells_.size()) - 1U);
        cells_.clear();
        while (!waiting.empty()) {
            Waiting& last = waiting.back();
            if (last.lanes == 0 || !mayLook()) {
                waiting.pop_back();
                continue;
            }
            const int lane = std::countr_zero(last.lanes);
            last.lanes &= last.lanes - 1;
            waiting.emplace_back(boost::container::default_init);
            Waiting& next = waiting.back();
            quarter(waiting[waiting.size() - 2].parts, lane, next.parts);
            next.lanes = unclearIn(next.parts, (1U << PartBatch::kLanes) - 1U);
        }
    }

    /// Looks at the parts of a batch; @return those that need a closer look.
    unsigned unclearIn(const PartBatch& batch, unsigned lanes) {
        constexpr double kNearEnough = 1.0 - 2.0 * kSameDistance;
        PartFacts facts;
        examine(batch,
                {.point = query_ - Vector3(0.0, 0.0, surface_.grid().datum),
                 .rounding = rounding_,
                 .limit = 0.5 * limit() * limit() * kNearEnough},
                facts);
        unsigned unclear = 0;
        for (unsigned left = lanes & ~facts.far; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            const unsigned bit = left & -left;
            const Part part(batch, facts, lane);
            lowerLimit(part);
            const Box box = boxOf(part);
            const bool inside = isInside(box);
            if (inside && (facts.withoutMinimum & bit) != 0) {
                continue;
            }
            const Courses courses = inside ? Courses{} : coursesIn(part, box);
            if (std::ranges::count(courses, Course::Falls) > 0) {
                continue;
            }
            const bool oneAtMost = (facts.convex & bit) != 0 || isConvexAtEdge(part, courses);
            if (oneAtMost && holdsKnownFoot(part)) {
                continue;
            }
            const double size = part.half.cwiseQuotient(pitch_).maxCoeff();
            if (oneAtMost && size < kWorthASearch) {
                findIn(part, box);
            } else if (size < 0.5 * kSmallestPart) {
                complete_ = false;
            } else {
                unclear |= bit;
            }
        }
        return unclear;
    }

    /// A place nearer than the nearest foot known leads to a foot that rules out more.
    void lowerLimit(const Part& part) {
        constexpr double kWorthwhile = 0.999;
        if (part.value >= kWorthwhile * 0.5 * nearest() * nearest()) {
            return;
        }
        const BoxNewton<HalfSquaredDistance> newton(objective_, scanBox(surface_),
                                                    0.25 * pitch_.minCoeff());
        const BoxMinimum minimum = newton.minimise(part.centre);
        if (minimum.converged) {
            feet_.add(footOf(minimum, query_), sameMinimum());
        }
    }

    /// How the distance goes along one axis, anywhere in a part.
    enum class Course : std::uint8_t {
        Unclear,
        Falls,        ///< towards a side, and goes on falling behind it: no minimum in the part
        FallsToEdge,  ///< towards a side that is the scan's edge: a minimum can only lie on it
    };
    using Courses = std::array<Course, 2>;

    [[nodiscard]] Courses coursesIn(const Part& part, const Box& box) const {
        const Box scan = scanBox(surface_);
        Courses courses{};
        for (int axis = 0; axis < 2; ++axis) {
            const double slope = part.gradient[axis];
            if (std::abs(slope) > part.spread[axis]) {
                const bool atEdge = slope > 0.0 ? box.low[axis] <= scan.low[axis]
                                                : box.high[axis] >= scan.high[axis];
                courses[static_cast<std::size_t>(axis)] =
                    atEdge ? Course::FallsToEdge : Course::Falls;
            }
        }
        return courses;
    }

    /// Whether the part holds one minimum at most because the scan's edge leaves it no other place.
    static bool isConvexAtEdge(const Part& part, const Courses& courses) {
        const bool heldX = courses[0] == Course::FallsToEdge;
        const bool heldY = courses[1] == Course::FallsToEdge;
        return (heldX && (heldY || part.bend.y() > 0.0)) || (heldY && part.bend.x() > 0.0);
    }

    /// The part as the place of a search, its sides on the scan's edge where they reach it.
    [[nodiscard]] Box boxOf(const Part& part) const {
        const Box scan = scanBox(surface_);
        Box box{.low = part.centre - part.half, .high = part.centre + part.half};
        for (int axis = 0; axis < 2; ++axis) {
            const double near = kEdge * pitch_[axis];
            box.low[axis] = box.low[axis] <= scan.low[axis] + near ? scan.low[axis] : box.low[axis];
            box.high[axis] =
                box.high[axis] >= scan.high[axis] - near ? scan.high[axis] : box.high[axis];
        }
        return box;
    }

    /// Whether a part lies off the scan's edge, so that a minimum in it needs a level gradient and
    /// a distance that bends up.
    [[nodiscard]] bool isInside(const Box& box) const {
        const Box scan = scanBox(surface_);
        return box.low.x() > scan.low.x() && box.low.y() > scan.low.y() &&
               box.high.x() < scan.high.x() && box.high.y() < scan.high.y();
    }

    [[nodiscard]] bool holdsKnownFoot(const Part& part) const {
        return std::ranges::any_of(feet_.all(), [&](const SurfaceFoot& foot) {
            return foot.converged && part.contains(foot.point.head<2>(), sameMinimum());
        });
    }
    [[nodiscard]] double sameMinimum() const { return kSameMinimum * pitch_.minCoeff(); }

    /// Takes up the only minimum that a part can hold, if it does hold one.
    void findIn(const Part& part, const Box& box) {
        const BoxNewton<HalfSquaredDistance> newton(objective_, box, 0.0);
        const BoxMinimum minimum = newton.minimise(part.centre);
        if (!minimum.converged) {
            complete_ = false;
            return;
        }
        if (minimum.pushedOut && !isPushedOutOfScan(minimum, box)) {
            return;
        }
        if (minimum.model.value <= 0.5 * limit() * limit()) {
            feet_.add(footOf(minimum, query_), sameMinimum());
        }
    }

    /// Whether every side of `box` that holds the minimum back is a side of the scan.
    [[nodiscard]] bool isPushedOutOfScan(const BoxMinimum& minimum, const Box& box) const {
        const Box scan = scanBox(surface_);
        for (int axis = 0; axis < 2; ++axis) {
            const double slope = minimum.model.gradient[axis];
            const bool pushes = std::abs(slope) > kEdgeNoise * minimum.model.gradientNoise[axis];
            const bool low = slope > 0.0 && minimum.place[axis] <= box.low[axis];
            const bool high = slope < 0.0 && minimum.place[axis] >= box.high[axis];
            if (pushes && ((low && box.low[axis] > scan.low[axis]) ||
                           (high && box.high[axis] < scan.high[axis]))) {
                return false;
            }
        }
        return true;
    }

    static constexpr double kEdge = 1e-9;       ///< nearer than this is at the edge [pixel]
    static constexpr double kEdgeNoise = 32.0;  ///< as BoxNewton allows

    const BSplineSurface& surface_;
    Vector3 query_;
    FootReach reach_;
    FootList& feet_;
    Vector2 pitch_;  ///< [m]
    HalfSquaredDistance objective_;
    SurfaceRounding rounding_;
    boost::container::static_vector<Settled, kMostMinima> settled_;
    boost::container::static_vector<CellIndex, PartBatch::kLanes> cells_;
    int looks_ = 0;
    bool complete_ = true;
};

}  // namespace

FootProof completeFeet(const BSplineSurface& surface, const Vector3& query, const FootReach& reach,
                       FootList& feet) noexcept {
    return GlobalSearch(surface, query, reach, feet).run();
}

}  // namespace asperity
