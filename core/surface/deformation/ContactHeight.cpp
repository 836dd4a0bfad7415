#include "core/surface/deformation/ContactHeight.h"

#include "core/Error.h"
#include "core/surface/closest/BoxNewton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

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
            rounding_.slope + rounding_.place * (s.bend() + cap(0, 0) + cap(1, 1)));
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
        const BoxNewton newton(depth_, box_, 0.25 * surface_.finestPitch());
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

}  // namespace asperity
