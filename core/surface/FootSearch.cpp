#include "core/surface/FootSearch.h"

#include "core/surface/BezierCell.h"
#include "core/surface/BoundsWindow.h"
#include "core/surface/LocalFoot.h"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

namespace asperity {

namespace {

/// Parts of cells that are looked into before a search gives up.
constexpr int kMostParts = 2048;
/// A part of a cell smaller than this says no more than rounding does [pixel].
constexpr double kSmallestPart = 0x1p-14;
/// Two minima found from different starts are one when they are nearer than this [pixel].
constexpr double kSameMinimum = 1e-4;

/// Rectangle within a cell, in spans from the cell's first pixel centre.
struct CellPart {
    SpanPart x;
    SpanPart y;
};

/// Least value of slope * t + bend * t^2 / 2 for |t| <= half.
double leastOnAxis(double slope, double bend, double half) {
    const double steep = std::abs(slope);
    if (steep >= bend * half) {
        return half * (0.5 * bend * half - steep);
    }
    return -0.5 * steep * steep / bend;
}

Range product(const Range& a, const Range& b) {
    const auto [low, high] =
        std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high};
}

/// Range of a square or product of slopes within `spread` of their value at the centre.
Range squareNear(double centre, double spread) {
    const double high = std::abs(centre) + spread;
    const double low = std::max(0.0, std::abs(centre) - spread);
    return {low * low, high * high};
}

/// Half the squared distance from the query over a part of a cell: its value and gradient at the
/// part's centre, and what its second derivatives can be anywhere in the part.
struct PartModel {
    Vector2 centre = Vector2::Zero();    ///< world [m]
    Vector2 half = Vector2::Zero();      ///< half the part's size [m]
    double value = 0.0;                  ///< [m^2]
    Vector2 gradient = Vector2::Zero();  ///< [m]
    Range xx;
    Range yy;
    Range xy;

    [[nodiscard]] double least() const {
        return value + leastOnAxis(gradient.x(), xx.low, half.x()) +
               leastOnAxis(gradient.y(), yy.low, half.y()) - xy.magnitude() * half.x() * half.y();
    }
    /// How much the gradient's components can differ from those at the centre [m].
    [[nodiscard]] Vector2 gradientSpread() const {
        return {xx.magnitude() * half.x() + xy.magnitude() * half.y(),
                xy.magnitude() * half.x() + yy.magnitude() * half.y()};
    }
    [[nodiscard]] bool isConvex() const {
        const double mixed = xy.magnitude();
        return xx.low > 0.0 && yy.low > 0.0 && xx.low * yy.low > mixed * mixed;
    }
    [[nodiscard]] bool bendsDown() const {
        const double least =
            xy.low > 0.0 || xy.high < 0.0 ? std::min(std::abs(xy.low), std::abs(xy.high)) : 0.0;
        return xx.high < 0.0 || yy.high < 0.0 || product(xx, yy).high < least * least;
    }
    [[nodiscard]] bool contains(const Vector2& place, double margin) const {
        return std::abs(place.x() - centre.x()) <= half.x() + margin &&
               std::abs(place.y() - centre.y()) <= half.y() + margin;
    }
};

class GlobalSearch {
public:
    /// @param within none: as near as the nearest foot known
    GlobalSearch(const BSplineSurface& surface, const Vector3& query, std::optional<double> within,
                 FootList& feet)
        : surface_(surface)
        , query_(query)
        , within_(within)
        , feet_(feet)
        , pitch_(surface.grid().pitchX, surface.grid().pitchY)
        , objective_(surface, query) {}

    FootProof run() {
        const BoundsWindow window(surface_, query_, limit());
        settle(window);
        for (int row = 0; row < window.rows().count; ++row) {
            for (int column = 0; column < window.columns().count; ++column) {
                if (window.reaches(row, column, limit()) && !isSettled(row, column)) {
                    lookIntoBlock(window.level(), window.rows().first + row,
                                  window.columns().first + column);
                }
            }
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

    /// How far a foot may lie to matter [m].
    [[nodiscard]] double limit() const {
        return within_.value_or(std::abs(feet_.all().front().distance));
    }

    void settle(const BoundsWindow& window) {
        for (const SurfaceFoot& foot : feet_.all()) {
            if (!foot.converged) {
                continue;
            }
            const int around = window.settledAround(foot.point.x(), foot.point.y(), limit());
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
        const Eigen::Matrix4d controls = cellControls(surface_.grid(), row, column);
        const Vector2 corner((column + 0.5) * pitch_.x(), (row + 0.5) * pitch_.y());
        // Depth first: three brothers wait at each halving, and the last one's four children.
        constexpr int kHalvings = 16;
        boost::container::static_vector<CellPart, 3 * kHalvings + 4> waiting;
        waiting.push_back(
            {cellExtent(column, surface_.grid().columns), cellExtent(row, surface_.grid().rows)});
        while (!waiting.empty() && mayLook()) {
            const CellPart part = waiting.back();
            waiting.pop_back();
            const PartModel model = modelOf(controls, corner, part);
            lowerLimit(model);
            const Box box = boxOf(model);
            const Courses courses = coursesIn(model, box);
            if (isFar(model) || std::ranges::count(courses, Course::Falls) > 0 ||
                isSaddle(model, box)) {
                continue;
            }
            if (isConvex(model, courses)) {
                findIn(model, box);
            } else if (std::max(part.x.length(), part.y.length()) < kSmallestPart) {
                complete_ = false;
            } else {
                halve(part, waiting);
            }
        }
    }

    /// A place nearer than the nearest foot known leads to a foot that rules out more.
    void lowerLimit(const PartModel& model) {
        constexpr double kWorthwhile = 0.999;
        if (within_ || model.value >= kWorthwhile * 0.5 * limit() * limit()) {
            return;
        }
        const BoxNewton<HalfSquaredDistance> newton(objective_, scanBox(surface_),
                                                    0.25 * pitch_.minCoeff());
        const BoxMinimum minimum = newton.minimise(model.centre);
        if (minimum.converged) {
            feet_.add(footOf(minimum, query_), kSameMinimum * pitch_.minCoeff());
        }
    }

    template <class Waiting>
    static void halve(const CellPart& part, Waiting& waiting) {
        for (const SpanPart& x : {part.x.lowerHalf(), part.x.upperHalf()}) {
            for (const SpanPart& y : {part.y.lowerHalf(), part.y.upperHalf()}) {
                waiting.push_back({x, y});
            }
        }
    }

    [[nodiscard]] PartModel modelOf(const Eigen::Matrix4d& controls, const Vector2& corner,
                                    const CellPart& part) const {
        const Eigen::Matrix4d net =
            bezierOfSpan(part.y) * controls * bezierOfSpan(part.x).transpose();
        PartModel model;
        model.half = 0.5 * Vector2(part.x.length() * pitch_.x(), part.y.length() * pitch_.y());
        model.centre = corner + Vector2(0.5 * (part.x.low + part.x.high) * pitch_.x(),
                                        0.5 * (part.y.low + part.y.high) * pitch_.y());
        const BendRange bends = bendsOf(net, {2.0 * model.half.x(), 2.0 * model.half.y()});
        const BezierMiddle middle = middleOf(net);
        const Vector2 slope(middle.riseX / (2.0 * model.half.x()),
                            middle.riseY / (2.0 * model.half.y()));
        const Vector3 r(model.centre.x() - query_.x(), model.centre.y() - query_.y(),
                        surface_.grid().datum + middle.height - query_.z());
        model.value = 0.5 * r.squaredNorm();
        model.gradient = r.head<2>() + r.z() * slope;
        addBends(bends, slope, r.z(), model);
        return model;
    }

    /// Second derivatives of (h - z)^2 / 2 are those of h times h - z, plus products of slopes.
    static void addBends(const BendRange& bends, const Vector2& slope, double above,
                         PartModel& model) {
        const double xx = bends.xx.magnitude();
        const double xy = bends.xy.magnitude();
        const double yy = bends.yy.magnitude();
        const Vector2 spread(xx * model.half.x() + xy * model.half.y(),
                             xy * model.half.x() + yy * model.half.y());
        const Vector2 steepest = slope.cwiseAbs() + spread;
        const double rise = steepest.dot(model.half);
        const Range e{above - rise, above + rise};
        const Range squareX = squareNear(slope.x(), spread.x());
        const Range squareY = squareNear(slope.y(), spread.y());
        const Range bentX = product(e, bends.xx);
        const Range bentY = product(e, bends.yy);
        model.xx = {1.0 + squareX.low + bentX.low, 1.0 + squareX.high + bentX.high};
        model.yy = {1.0 + squareY.low + bentY.low, 1.0 + squareY.high + bentY.high};
        const Range bentXy = product(e, bends.xy);
        const Range slopes = product({slope.x() - spread.x(), slope.x() + spread.x()},
                                     {slope.y() - spread.y(), slope.y() + spread.y()});
        model.xy = {slopes.low + bentXy.low, slopes.high + bentXy.high};
    }

    [[nodiscard]] bool isFar(const PartModel& model) const {
        return model.least() >= 0.5 * limit() * limit() * (1.0 - 2.0 * kSameDistance);
    }

    /// The part as the place of a search, its sides on the scan's edge where they reach it.
    [[nodiscard]] Box boxOf(const PartModel& part) const {
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

    /// How the distance goes along one axis, anywhere in a part.
    enum class Course : std::uint8_t {
        Unclear,
        Falls,        ///< towards a side, and goes on falling behind it: no minimum in the part
        FallsToEdge,  ///< towards a side that is the scan's edge: a minimum can only lie on it
    };
    using Courses = std::array<Course, 2>;

    [[nodiscard]] Courses coursesIn(const PartModel& model, const Box& box) const {
        const Vector2 spread = model.gradientSpread();
        const Box scan = scanBox(surface_);
        Courses courses{};
        for (int axis = 0; axis < 2; ++axis) {
            const double slope = model.gradient[axis];
            if (std::abs(slope) > spread[axis]) {
                const bool atEdge = slope > 0.0 ? box.low[axis] <= scan.low[axis]
                                                : box.high[axis] >= scan.high[axis];
                courses[static_cast<std::size_t>(axis)] =
                    atEdge ? Course::FallsToEdge : Course::Falls;
            }
        }
        return courses;
    }

    /// Whether the part holds one minimum at most.
    static bool isConvex(const PartModel& model, const Courses& courses) {
        const bool heldX = courses[0] == Course::FallsToEdge;
        const bool heldY = courses[1] == Course::FallsToEdge;
        if (heldX || heldY) {
            return (heldX || model.xx.low > 0.0) && (heldY || model.yy.low > 0.0);
        }
        return model.isConvex();
    }

    /// Whether the distance bends down in some direction throughout the part, which leaves room for
    /// a minimum only at the scan's edge.
    [[nodiscard]] bool isSaddle(const PartModel& model, const Box& box) const {
        const Box scan = scanBox(surface_);
        return model.bendsDown() && box.low.x() > scan.low.x() && box.low.y() > scan.low.y() &&
               box.high.x() < scan.high.x() && box.high.y() < scan.high.y();
    }

    /// Takes up the only minimum that a part can hold, if it does hold one.
    void findIn(const PartModel& part, const Box& box) {
        const double margin = kSameMinimum * pitch_.minCoeff();
        const bool isKnown = std::ranges::any_of(feet_.all(), [&](const SurfaceFoot& foot) {
            return foot.converged && part.contains(foot.point.head<2>(), margin);
        });
        if (isKnown) {
            return;
        }
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
            feet_.add(footOf(minimum, query_), margin);
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
    std::optional<double> within_;  ///< [m]
    FootList& feet_;
    Vector2 pitch_;  ///< [m]
    HalfSquaredDistance objective_;
    boost::container::static_vector<Settled, kMostFeet> settled_;
    int looks_ = 0;
    bool complete_ = true;
};

}  // namespace

FootProof completeFeet(const BSplineSurface& surface, const Vector3& query, double within,
                       FootList& feet) noexcept {
    return GlobalSearch(surface, query, within, feet).run();
}

FootProof findNearestFoot(const BSplineSurface& surface, const Vector3& query,
                          FootList& feet) noexcept {
    return GlobalSearch(surface, query, std::nullopt, feet).run();
}

}  // namespace asperity
