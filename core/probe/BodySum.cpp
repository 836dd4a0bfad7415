#include "core/probe/BodySum.h"

#include "core/Simd.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMoments.h"
#include "core/surface/SplineSampling.h"
#include "core/surface/TangentFrame.h"
#include "core/surface/closest/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// A square may be off by so much of the pull-off force; some hundred of them are summed, with
/// errors of either sign.
constexpr double kSquareError = 3e-5;
constexpr int kFinest = -2;  // level of the smallest squares: a quarter of a pixel
constexpr int kCoarsest = 24;
constexpr int kMaxSquares = 8192;
/// Squared distance from the tip's axis up to which is summed, of the radius squared. What lies
/// beyond attracts with 32 pi w R (D0/R)^2 at most.
constexpr double kReach = 0.5;
/// Fourth moment over the variance squared: 1.8 of a slope along one side of a square, 2.4 along
/// its diagonal, 3 of random heights.
constexpr double kKurtosis = 2.4;

/// g^3 / (g^3 + D_s^3)^2 across four separations; 0 below 0.
ASPERITY_INLINE Double4 valueAt(Double4 gap, double cohesive) {
    const Double4 g = most(gap, Double4{});
    const Double4 cube = g * g * g;
    const Double4 per = 1.0 / (cube + cohesive);
    return cube * per * per;
}

/// With its derivatives.
struct Traction4 {
    Double4 value;  ///< [1/m^3]
    Double4 slope;  ///< [1/m^4]
    Double4 bend;   ///< [1/m^5]
};

ASPERITY_INLINE Traction4 tractionAt(Double4 gap, double cohesive) {
    const Double4 g = most(gap, Double4{});
    const Double4 cube = g * g * g;
    const Double4 per = 1.0 / (cube + cohesive);
    const Double4 square = per * per;
    const Double4 far = cube * per;  // 0 in contact, 1 far away
    return {cube * square, 3.0 * g * g * square * (1.0 - 2.0 * far),
            g * square * (6.0 - far * (48.0 - 54.0 * far))};
}

ASPERITY_INLINE Double4 rootOf(Double4 square) {
    return Double4{std::sqrt(square[0]), std::sqrt(square[1]), std::sqrt(square[2]),
                   std::sqrt(square[3])};
}

/// The sample as the law of a contact has it, over the plane that touches the contact point.
struct LawSample {
    double x = 0.0;
    double y = 0.0;
    HeightSample shape;  ///< in the contact point
    double touch = 0.0;  ///< separation of tip and sample along z at the point [m]
    double reach = 0.0;  ///< squared distance beyond which it counts nothing [m^2]
};

/// Tip, contacts and law of the sum.
struct Summand {
    double radius = 0.0;  ///< of the tip [m]
    Vector3 tip;
    Vector3 normal;         ///< of the main contact
    double error = 0.0;     ///< of a square, over H / (6 pi) [1/m]
    double joint = 0.0;     ///< D_s [m]
    double cohesive = 0.0;  ///< its cube [m^3]
    std::array<LawSample, kMaxContactPoints> contacts;
    std::size_t contactCount = 0;
};

/// Four squares of one size: the quarters of a square of the scan.
struct Quarters {
    double width = 0.0;
    double height = 0.0;
    Double4 atX;
    Double4 atY;
    Double4 mean{};  ///< of the sample's heights [m]
    Double4 slopeX{};
    Double4 slopeY{};
    Double4 variance{};  ///< around that plane [m^2]
    bool mayCut = true;
};

/// Change of the mean height over a square by the surface's second derivatives.
struct Curving {
    double mean = 0.0;      ///< over the height in the middle [m]
    double variance = 0.0;  ///< around the plane [m^2]
};

ASPERITY_INLINE Curving curvingOf(const HeightSample& shape, double width, double height) {
    const double x = width * width;
    const double y = height * height;
    const double bendX = x * shape.dxx;
    const double bendY = y * shape.dyy;
    return {(bendX + bendY) / 24.0,
            (bendX * bendX + bendY * bendY) / 720.0 + x * y * shape.dxy * shape.dxy / 144.0};
}

/// Heights of squares that are finer than HeightMoments has them, from the surface's derivatives.
ASPERITY_WITH_AVX2 void sampleQuarters(const SplineSampling& surface, Quarters& squares) {
    for (int part = 0; part < 4; ++part) {
        const HeightSample middle = sampledAt(surface, squares.atX[part], squares.atY[part]);
        const Curving curving = curvingOf(middle, squares.width, squares.height);
        squares.mean[part] = middle.height + curving.mean;
        squares.variance[part] = curving.variance;
        squares.slopeX[part] = middle.dx;
        squares.slopeY[part] = middle.dy;
    }
}

/// Sums so far, lane by lane.
struct Sums {
    Double4 force{};
    Double4 alongX{};
    Double4 alongY{};
    Double4 alongZ{};
    Double4 alongNormal{};
    Double4 bend{};
};

/// Mean traction over squares of a gap with this variance.
struct Mean4 {
    Double4 value;
    Double4 left;  ///< order of what it is off by
};

ASPERITY_INLINE Mean4 meanAt(const Summand& of, const Traction4& middle, Double4 gap,
                             Double4 variance) {
    constexpr double kMax = 0.5;  // of the separation: a square that varies more is too large
    const Double4 deviation =
        least(rootOf(kKurtosis * variance), kMax * (most(gap, Double4{}) + of.joint));
    const Double4 nearer = valueAt(gap - deviation, of.cohesive);
    const Double4 farther = valueAt(gap + deviation, of.cohesive);
    const Double4 second = (0.5 * (nearer + farther) - middle.value) * (1.0 / kKurtosis);
    // The next moments: some ten times the square of that ratio.
    constexpr double kNext = 10.0;
    const Double4 largest = most(most(nearer, farther), middle.value);
    const Double4 apart = most(gap, Double4{}) + of.joint;
    const Double4 ratio = variance / (apart * apart);
    return {middle.value + second, largest * least(kNext * ratio * ratio, Double4{} + 1.0)};
}

/// Variance of heights by a slope across squares, in both directions [m^2].
ASPERITY_INLINE Double4 varianceOf(const Quarters& squares, Double4 slopeX, Double4 slopeY) {
    constexpr double kOfSide = 1.0 / 12.0;
    const Double4 x = slopeX * squares.width;
    const Double4 y = slopeY * squares.height;
    return kOfSide * (x * x + y * y);
}

/// The cap of the tip over four squares.
struct Cap4 {
    Double4 height;  ///< world [m]
    Double4 slopeX;
    Double4 slopeY;
};

/// Returns what the laws of the contacts count over four squares; the value as a mean.
/// @param left becomes what the means are off by
ASPERITY_INLINE Traction4 countedAt(const Summand& of, const Quarters& squares, const Cap4& cap,
                                    Double4& left) {
    constexpr double kFlattest = 0.1;  // of the cap's gap: as effectiveRadius() in a valley
    Traction4 sum{};
    for (std::size_t i = 0; i < of.contactCount; ++i) {
        const LawSample& contact = of.contacts[i];
        const HeightSample& shape = contact.shape;
        const Double4 x = squares.atX - contact.x;
        const Double4 y = squares.atY - contact.y;
        if (bitsOf(x * x + y * y < Double4{} + contact.reach) == 0) {
            continue;
        }
        const Double4 bendX = shape.dxx * x + shape.dxy * y;
        const Double4 bendY = shape.dxy * x + shape.dyy * y;
        const Curving curving = curvingOf(shape, squares.width, squares.height);
        const Double4 plane = shape.height + shape.dx * x + shape.dy * y;
        const Double4 over = cap.height + kContactSeparation - contact.touch - plane;
        const Double4 gap =
            contact.touch +
            most(over - 0.5 * (bendX * x + bendY * y) - curving.mean, kFlattest * over);
        const Double4 variance =
            curving.variance +
            varianceOf(squares, shape.dx + bendX - cap.slopeX, shape.dy + bendY - cap.slopeY);
        const Traction4 one = tractionAt(gap, of.cohesive);
        const Mean4 mean = meanAt(of, one, gap, variance);
        sum.value += mean.value;
        left += mean.left;
        sum.slope += one.slope;
        sum.bend += one.bend;
    }
    return sum;
}

/// Adds those of four squares that are small enough; the bits of the others.
ASPERITY_WITH_AVX2 unsigned addQuarters(const Summand& of, const Quarters& squares, Sums& sums) {
    const double whole = of.radius * of.radius;
    const Double4 x = squares.atX - of.tip.x();
    const Double4 y = squares.atY - of.tip.y();
    const Double4 squared = whole - x * x - y * y;
    const Long4 isSeen = squared > (1.0 - kReach) * whole;
    const Double4 root = rootOf(most(squared, Double4{} + (1.0 - kReach) * whole));
    const Double4 perRoot = 1.0 / root;
    const Cap4 cap{of.tip.z() + of.radius - root, x * perRoot, y * perRoot};
    const Double4 variance = squares.variance + varianceOf(squares, squares.slopeX - cap.slopeX,
                                                           squares.slopeY - cap.slopeY);
    const Double4 gap = kContactSeparation + cap.height - squares.mean;
    const Traction4 own = tractionAt(gap, of.cohesive);
    const Mean4 mean = meanAt(of, own, gap, variance);
    Double4 left{};
    const Traction4 counted = countedAt(of, squares, cap, left);
    const double area = squares.width * squares.height;
    const Double4 difference = mean.value - counted.value;
    // Where tip and law see the same sample, both are off by the same.
    constexpr double kMin = 0.2;
    const Double4 alike = most(kMin * own.value, magnitude(difference));
    const Long4 isCoarse = area * most(mean.left, left) * alike > of.error * own.value;
    const Long4 isCut = isSeen & isCoarse & (squares.mayCut ? Long4{-1, -1, -1, -1} : Long4{});
    const Long4 isAdded = isSeen & ~isCut;
    // Along the normal of the cap's element: u = (cap_x, cap_y, -1).
    const Double4 along = cap.slopeX * of.normal.x() + cap.slopeY * of.normal.y() - of.normal.z();
    const Double4 weight = isAdded ? area * along : Double4{};
    sums.force += weight * difference;
    const Double4 steep = weight * own.slope;
    sums.alongX -= steep * cap.slopeX;
    sums.alongY -= steep * cap.slopeY;
    sums.alongZ += steep;
    sums.alongNormal -= weight * counted.slope;
    sums.bend += weight * (own.bend - counted.bend);
    return bitsOf(isCut);
}

/// A square of the scan.
struct Square {
    int level = 0;  ///< of 2^level pixels a side
    int row = 0;
    int column = 0;
};

class Sum {
public:
    Sum(const HeightMoments& sample, const BodyTraction& traction, const Vector3& tip,
        std::span<const Vector3> points, const Vector3& normal) noexcept
        : sample_(sample)
        , surface_(sample.surface())
        , radius_(traction.effectiveRadius)
        , factor_(hamakerConstant(traction.workOfAdhesion) / (6.0 * std::numbers::pi)) {
        of_.radius = traction.tipRadius;
        of_.tip = tip;
        of_.normal = normal;
        of_.error = kSquareError * traction.pullOff / factor_;
        of_.joint = kContactSeparation + traction.cohesiveRange;
        of_.cohesive = of_.joint * of_.joint * of_.joint;
        for (const Vector3& point : points) {
            addContact(point);
        }
    }

    BodyForce run() noexcept {
        const BSplineSurface::Grid& grid = surface_.grid();
        // A square is a quarter of the radius at most: beyond, its cap is no smooth function.
        const double widest = std::max(grid.pitchX, grid.pitchY);
        const int level = std::clamp(
            static_cast<int>(std::floor(std::log2(0.5 * of_.radius / widest))), 1, kCoarsest);
        const double width = side(grid.pitchX, level);
        const double height = side(grid.pitchY, level);
        const auto at = [](double position, double length) {  // far off the scan there is no square
            constexpr double kMax = 1 << 24;
            return static_cast<int>(std::clamp(std::floor(position / length), -kMax, kMax));
        };
        const Vector3& tip = of_.tip;
        const double reach = std::sqrt(kReach) * of_.radius;
        const int lastRow = at(tip.y() + reach, height);
        const int lastColumn = at(tip.x() + reach, width);
        for (int row = at(tip.y() - reach, height); row <= lastRow; ++row) {
            for (int column = at(tip.x() - reach, width); column <= lastColumn; ++column) {
                addQuartered({level, row, column});
            }
        }
        return result();
    }

private:
    [[nodiscard]] BodyForce result() const noexcept {
        const auto total = [this](Double4 lanes) {
            return factor_ * ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3]));
        };
        const Vector3 ofSample(total(sums_.alongX), total(sums_.alongY), total(sums_.alongZ));
        return {.tip = of_.tip,
                .force = total(sums_.force),
                .gradient = ofSample + total(sums_.alongNormal) / of_.normal.z() * of_.normal,
                .bend = total(sums_.bend),
                .radius = radius_,
                .squares = squares_};
    }

    void addContact(const Vector3& point) noexcept {
        if (of_.contactCount == of_.contacts.size()) {
            return;
        }
        LawSample& contact = of_.contacts[of_.contactCount++];
        contact = {.x = point.x(), .y = point.y(), .shape = surface_.at(point.x(), point.y())};
        const Vector2 arm = (point - of_.tip).head<2>();
        const double root = std::sqrt(std::max(of_.radius * of_.radius - arm.squaredNorm(), 0.0));
        // Beyond r a paraboloid has a share (16/3) (R_eff D0)^2 / r^4 of pull-off.
        constexpr double kBeyond = 1e-4;
        contact.reach = std::sqrt(16.0 / (3.0 * kBeyond)) * kContactSeparation * radius_;
        contact.touch = kContactSeparation + of_.tip.z() + of_.radius - root - contact.shape.height;
    }

    /// Side of a square [m].
    [[nodiscard]] static double side(double pitch, int level) noexcept {
        return 0.25 * static_cast<double>(1U << static_cast<unsigned>(level - kFinest)) * pitch;
    }

    /// Adds the quarters of a square, cut into smaller ones where that matters.
    void addQuartered(const Square& whole) noexcept {
        std::array<Square, 3 * (kCoarsest - kFinest) + 4> stack;  // three of each level wait
        std::size_t count = 0;
        stack[count++] = whole;
        while (count > 0) {
            const Square square = stack[--count];
            const Quarters quarters = quartersOf(square);
            unsigned cut = addQuarters(of_, quarters, sums_);
            squares_ += 4 - std::popcount(cut);
            for (; cut != 0; cut &= cut - 1) {
                const int part = std::countr_zero(cut);
                stack[count++] = {square.level - 1, 2 * square.row + part / 2,
                                  2 * square.column + part % 2};
            }
        }
    }

    [[nodiscard]] Quarters quartersOf(const Square& square) const noexcept {
        const int level = square.level - 1;
        const double width = side(surface_.grid().pitchX, level);
        const double height = side(surface_.grid().pitchY, level);
        Quarters quarters{.width = width,
                          .height = height,
                          .atX = (2.0 * square.column + Double4{0.5, 1.5, 0.5, 1.5}) * width,
                          .atY = (2.0 * square.row + Double4{0.5, 0.5, 1.5, 1.5}) * height,
                          .mayCut = level > kFinest && squares_ < kMaxSquares};
        if (level < 1) {
            sampleQuarters(surface_.sampling(), quarters);
            return quarters;
        }
        for (int part = 0; part < 4; ++part) {
            const HeightSpread spread =
                sample_.at(level, 2 * square.row + part / 2, 2 * square.column + part % 2);
            quarters.mean[part] = spread.mean;
            quarters.slopeX[part] = spread.slopeX;
            quarters.slopeY[part] = spread.slopeY;
            quarters.variance[part] = spread.variance;
        }
        return quarters;
    }

    const HeightMoments& sample_;
    const BSplineSurface& surface_;
    double radius_;  ///< effective, of the main contact [m]
    double factor_;  ///< H / (6 pi) [J]
    Summand of_;
    Sums sums_;
    int squares_ = 0;
};

/// The sample around a contact point, as it is and as the contact's law has it.
class SampleBeside {
public:
    /// @param curved whether the law takes the curvature at the contact point
    SampleBeside(const BSplineSurface& surface, const ClosestPoint& foot, bool curved) noexcept
        : surface_(surface)
        , frame_(tangentFrame(foot.point, foot.normal))
        , middle_(surface.at(foot.point.x(), foot.point.y()))
        , curved_(curved) {}

    [[nodiscard]] Vector3 stepAt(double radius, double angle) const noexcept {
        return radius * (std::cos(angle) * frame_.along + std::sin(angle) * frame_.across);
    }
    /// Height over the tangent plane along the normal [m]; beyond the scan that of its edge.
    [[nodiscard]] double height(const Vector3& step) const noexcept {
        const double x = std::clamp(frame_.origin.x() + step.x(), 0.0, surface_.sizeX());
        const double y = std::clamp(frame_.origin.y() + step.y(), 0.0, surface_.sizeY());
        return (Vector3(x, y, surface_.at(x, y).height) - frame_.origin).dot(frame_.normal);
    }
    /// The same of the law's paraboloid.
    [[nodiscard]] double heightOfLaw(const Vector3& step) const noexcept {
        const double bend = (middle_.dxx * step.x() * step.x()) +
                            (2.0 * middle_.dxy * step.x() * step.y()) +
                            (middle_.dyy * step.y() * step.y());
        return curved_ ? 0.5 * bend * frame_.normal.z() : 0.0;
    }

private:
    const BSplineSurface& surface_;
    TangentFrame frame_;
    HeightSample middle_;
    bool curved_;
};

}  // namespace

BodyTraction bodyTraction(const ProbeSystem& system, const ContactPair& pair) noexcept {
    return {.tipRadius = system.tipRadius(),
            .workOfAdhesion = pair.workOfAdhesion,
            .cohesiveRange = system.contact.cohesiveRange(),
            .effectiveRadius = pair.tipRadius,
            .pullOff = 1.5 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius};
}

bool BodyForce::holdsAt(const Vector3& position, double error) const noexcept {
    const double steepest = gradient.norm();
    const Vector3 moved = position - tip;
    if (!(steepest > 0.0) || moved.squaredNorm() == 0.0) {
        return true;
    }
    const double along = gradient.dot(moved) / steepest;
    const double across = std::max(0.0, moved.squaredNorm() - along * along);
    return 0.5 * (std::abs(bend) * along * along + steepest * across / radius) < error;
}

BodyPull BodyForce::along(const Vector3& normal, const Vector3& position,
                          double indentation) const noexcept {
    const double slope = -gradient.dot(normal);
    const double here = force + gradient.dot(position - tip);
    return {.force = here - slope * indentation, .slope = slope};
}

BodyForce bodyForce(const HeightMoments& sample, const BodyTraction& traction, const Vector3& tip,
                    std::span<const Vector3> points, const Vector3& normal) noexcept {
    if (traction.workOfAdhesion < kMinAdhesion) {
        return {.tip = tip};
    }
    return Sum(sample, traction, tip, points, normal).run();
}

BodyAttraction bodyAttraction(const BSplineSurface& surface, const ProbeSystem& system,
                              const TipState& state) noexcept {
    constexpr double kFlattest = 0.1;  // of the cap's gap: as effectiveRadius() has it in a valley
    constexpr double kPixels = 0.25;   // between look-ups near the contact
    constexpr double kDistances = 0.02;  // and farther out
    const double tipRadius = system.tipRadius();
    const ContactPair pair = system.pairAt(state.closest.point, state.effectiveRadius);
    if (pair.workOfAdhesion < kMinAdhesion) {
        return {};
    }
    const double joint = kContactSeparation + system.contact.cohesiveRange();
    const double touch = kContactSeparation - state.contact.indentation;
    const auto traction = [cohesive = joint * joint * joint](double separation) {
        const double apart = std::max(separation, 0.0);
        const double cube = apart * apart * apart;
        return cube / ((cube + cohesive) * (cube + cohesive));
    };
    const SampleBeside sample(surface, state.closest,
                              system.curvature && !isSphere(system.contact.law()));
    double sum = 0.0;
    double inner = 0.0;
    while (inner < tipRadius) {
        const double width = std::max(kPixels * surface.finestPitch(), kDistances * inner);
        const double outer = std::min(inner + width, tipRadius);
        const double radius = 0.5 * (inner + outer);
        const double square = radius * radius;
        const double cap = square / (tipRadius + std::sqrt((tipRadius * tipRadius) - square));
        const double around = 2.0 * std::numbers::pi * radius / width;
        const int directions = std::max(8, static_cast<int>(std::ceil(around)));
        double ring = 0.0;
        for (int i = 0; i < directions; ++i) {
            const Vector3 step = sample.stepAt(radius, 2.0 * std::numbers::pi * i / directions);
            ring += traction(touch + cap - sample.height(step)) -
                    traction(touch + std::max(cap - sample.heightOfLaw(step), kFlattest * cap));
        }
        sum += ring / directions * (outer * outer - inner * inner);
        inner = outer;
    }
    // pi times the sum is the integral over the area, H / (6 pi) the traction's factor.
    const double force = -hamakerConstant(pair.workOfAdhesion) / 6.0 * sum;
    return {.force = force,
            .share = force / (1.5 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius)};
}

}  // namespace asperity
