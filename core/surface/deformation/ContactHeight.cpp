#include "core/surface/deformation/ContactHeight.h"

#include "core/Error.h"
#include "core/surface/closest/BoxNewton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity {

namespace {

double finestPitch(const BSplineSurface& surface) {
    return std::min(surface.grid().pitchX, surface.grid().pitchY);
}

double bendOf(const HeightSample& s) { return std::abs(s.dxx) + std::abs(s.dxy) + std::abs(s.dyy); }

/// Minus the height of the sphere's center when it touches the surface at a given place [m].
class CenterDepth {
public:
    CenterDepth(const BSplineSurface& surface, const Vector2& axis, double radius)
        : surface_(surface)
        , axis_(axis)
        , radius_(radius)
        , rounding_(roundingOf(surface, Vector3(axis.x(), axis.y(), radius))) {}

    [[nodiscard]] bool isUnderSphere(const Vector2& place) const {
        return (place - axis_).squaredNorm() < radius_ * radius_;
    }

    LocalModel operator()(const Vector2& place) const noexcept {
        LocalModel model;
        if (!isUnderSphere(place)) {
            model.value = kNever;
            return model;
        }
        const HeightSample s = surface_.at(place.x(), place.y());
        const Vector2 arm = place - axis_;
        const double rise = std::sqrt(radius_ * radius_ - arm.squaredNorm());
        const Matrix2 cap = (Matrix2::Identity() + arm * arm.transpose() / (rise * rise)) / rise;
        Matrix2 surfaceBend;
        surfaceBend << s.dxx, s.dxy, s.dxy, s.dyy;
        model.surface = s;
        model.value = -(s.height + rise);
        model.valueNoise = rounding_.height;
        model.gradient = arm / rise - Vector2(s.dx, s.dy);
        model.gradientNoise = Vector2::Constant(
            rounding_.slope + rounding_.place * (bendOf(s) + cap(0, 0) + cap(1, 1)));
        model.convex = cap;
        model.hessian = cap - surfaceBend;
        return model;
    }

private:
    static constexpr double kNever = std::numeric_limits<double>::max() / 4.0;

    const BSplineSurface& surface_;
    Vector2 axis_;
    double radius_;  ///< [m]
    SurfaceRounding rounding_;
};

/// Minus the surface's height [m].
class SurfaceDepth {
public:
    SurfaceDepth(const BSplineSurface& surface, const Box& box)
        : surface_(surface)
        , boxSize_(std::max((box.high - box.low).maxCoeff(), surface.grid().pitchX))
        , rounding_(roundingOf(surface, Vector3::Zero())) {}

    LocalModel operator()(const Vector2& place) const noexcept {
        LocalModel model;
        const HeightSample s = surface_.at(place.x(), place.y());
        model.surface = s;
        model.value = -s.height;
        model.valueNoise = rounding_.height;
        model.gradient = -Vector2(s.dx, s.dy);
        model.gradientNoise = Vector2::Constant(rounding_.slope + rounding_.place * bendOf(s));
        model.hessian << -s.dxx, -s.dxy, -s.dxy, -s.dyy;
        // Not so flat that a step would leave the box by far.
        const double bend = std::max(bendOf(s), model.gradient.norm() / boxSize_);
        model.convex = Matrix2::Identity() * std::max(bend, std::numeric_limits<double>::min());
        return model;
    }

private:
    const BSplineSurface& surface_;
    double boxSize_;  ///< [m]
    SurfaceRounding rounding_;
};

/// A run of spline cells along one axis; cell k lies between the centers of pixels k and k + 1.
struct CellRange {
    int first = 0;
    int last = 0;
};

CellRange cellsBetween(double low, double high, double pitch, int pixels) {
    const auto cellOf = [&](double place) {
        return std::clamp(static_cast<int>(std::floor(place / pitch - 0.5)), -1, pixels - 1);
    };
    return {cellOf(low), cellOf(high)};
}

/// The search for the highest contact among all cells under the sphere.
class ContactSearch {
public:
    ContactSearch(const BSplineSurface& surface, const Vector2& axis, double radius)
        : surface_(surface)
        , axis_(axis)
        , radius_(radius)
        , depth_(surface, axis, radius)
        , box_{.low = scanBox(surface).nearest(axis - Vector2::Constant(radius)),
               .high = scanBox(surface).nearest(axis + Vector2::Constant(radius))} {}

    double run() {
        tryPlace(scanBox(surface_).nearest(axis_));
        forEachCell([this](int column, int row) { tryPlace(placeIn(column, row, 0.0, 0.0)); });
        polish(bestPlace_);
        forEachCell([this](int column, int row) {
            if (highestPossible(column, row) > best_) {
                searchCell(column, row);
            }
        });
        return best_;
    }

private:
    template <class Visit>
    void forEachCell(const Visit& visit) const {
        const BSplineSurface::Grid& grid = surface_.grid();
        const CellRange across =
            cellsBetween(box_.low.x(), box_.high.x(), grid.pitchX, grid.columns);
        const CellRange up = cellsBetween(box_.low.y(), box_.high.y(), grid.pitchY, grid.rows);
        for (int row = up.first; row <= up.last; ++row) {
            for (int column = across.first; column <= across.last; ++column) {
                visit(column, row);
            }
        }
    }

    /// A place of the cell, s and t from 0 to 1 across it, brought into the box.
    [[nodiscard]] Vector2 placeIn(int column, int row, double s, double t) const {
        return box_.nearest(Vector2((column + 0.5 + s) * surface_.grid().pitchX,
                                    (row + 0.5 + t) * surface_.grid().pitchY));
    }

    /// Upper bound of the center's height for a contact in the cell: a spline lies below the
    /// highest of its control points.
    [[nodiscard]] double highestPossible(int column, int row) const {
        double height = surface_.control(row - 1, column - 1);
        for (int j = row - 1; j <= row + 2; ++j) {
            for (int i = column - 1; i <= column + 2; ++i) {
                height = std::max(height, surface_.control(j, i));
            }
        }
        const Box cell{.low = placeIn(column, row, 0.0, 0.0),
                       .high = placeIn(column, row, 1.0, 1.0)};
        const double nearest = (cell.nearest(axis_) - axis_).squaredNorm();
        return height + std::sqrt(std::max(radius_ * radius_ - nearest, 0.0));
    }

    void searchCell(int column, int row) {
        constexpr int kSamples = 4;
        double highest = -std::numeric_limits<double>::max();
        Vector2 start = Vector2::Zero();
        for (int j = 0; j <= kSamples; ++j) {
            for (int i = 0; i <= kSamples; ++i) {
                const Vector2 place = placeIn(column, row, static_cast<double>(i) / kSamples,
                                              static_cast<double>(j) / kSamples);
                const double height = -depth_(place).value;
                if (height > highest) {
                    highest = height;
                    start = place;
                }
            }
        }
        polish(start);
    }

    void tryPlace(const Vector2& place) {
        const double height = -depth_(place).value;
        if (height > best_) {
            best_ = height;
            bestPlace_ = place;
        }
    }

    void polish(const Vector2& start) {
        if (!depth_.isUnderSphere(start)) {
            return;
        }
        const BoxNewton newton(depth_, box_, 0.25 * finestPitch(surface_));
        tryPlace(newton.minimize(start).place);
    }

    const BSplineSurface& surface_;
    Vector2 axis_;
    double radius_;  ///< [m]
    CenterDepth depth_;
    Box box_;
    double best_ = -std::numeric_limits<double>::max();
    Vector2 bestPlace_ = Vector2::Zero();
};

/// The highest of the pixel centers, and of the middle, that are allowed; brought into the box.
template <class IsAllowed>
std::optional<Vector2> highestPixel(const BSplineSurface& surface, const Box& box,
                                    const IsAllowed& isAllowed) {
    std::optional<Vector2> highest;
    double height = -std::numeric_limits<double>::max();
    const auto consider = [&](const Vector2& place) {
        const double here = surface.at(place.x(), place.y()).height;
        if (here > height && isAllowed(place)) {
            height = here;
            highest = place;
        }
    };
    consider(0.5 * Vector2(surface.sizeX(), surface.sizeY()));
    const BSplineSurface::Grid& grid = surface.grid();
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            consider(box.nearest(Vector2((column + 0.5) * grid.pitchX, (row + 0.5) * grid.pitchY)));
        }
    }
    return highest;
}

}  // namespace

double tipContactHeight(const BSplineSurface& surface, double x, double y, double tipRadius) {
    if (!std::isfinite(tipRadius) || tipRadius <= 0.0) {
        throw Error("the tip radius must be a positive length");
    }
    if (!std::isfinite(x) || !std::isfinite(y)) {
        throw Error("the place of the tip must be finite");
    }
    const Vector2 axis(x, y);
    const Vector2 nearest = scanBox(surface).nearest(axis);
    const bool reachesScan = (nearest - axis).norm() < tipRadius;
    return ContactSearch(surface, reachesScan ? axis : nearest, tipRadius).run();
}

SurfacePlace highestPlace(const BSplineSurface& surface, double marginFraction) {
    if (!std::isgreaterequal(marginFraction, 0.0) || marginFraction > 0.5) {
        throw Error("the margin must be between 0 and 0.5 of the scan");
    }
    const Vector2 size(surface.sizeX(), surface.sizeY());
    const Box box{.low = marginFraction * size, .high = (1.0 - marginFraction) * size};
    const auto everywhere = [](const Vector2&) { return true; };
    const auto measured = [&](const Vector2& p) { return surface.isMeasured(p.x(), p.y()); };
    const std::optional<Vector2> withData = highestPixel(surface, box, measured);
    const Vector2 highest =
        withData ? *withData : highestPixel(surface, box, everywhere).value_or(0.5 * size);
    const SurfaceDepth depth(surface, box);
    const BoxMinimum top = BoxNewton(depth, box, 0.25 * finestPitch(surface)).minimize(highest);
    const Vector2 place = withData && !measured(top.place) ? highest : top.place;
    return {.x = place.x(), .y = place.y(), .height = surface.at(place.x(), place.y()).height};
}

}  // namespace asperity
