#include "core/surface/deformation/ContactHeight.h"

#include "core/Error.h"
#include "core/surface/closest/BlockAxis.h"
#include "core/surface/closest/BoxNewton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

/// The search for the highest contact among all cells under the sphere, those first that may have
/// the highest.
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
        polish(scanBox(surface_).nearest(axis_));
        add({.level = surface_.bounds().levels() - 1, .row = 0, .column = 0});
        while (!waiting_.empty() && waiting_.front().highest > best_) {
            std::ranges::pop_heap(waiting_, {}, &Block::highest);
            const Block block = waiting_.back();
            waiting_.pop_back();
            if (block.level == 0) {
                searchCell(boxOf(block));
            } else {
                addPartsOf(block);
            }
        }
        return best_;
    }

private:
    /// Of cells, see CellBounds.
    struct Block {
        int level = 0;
        int row = 0;
        int column = 0;
        double highest = 0.0;  ///< possible height of the center for a contact in it [m]
    };

    [[nodiscard]] Box boxOf(const Block& block) const {
        const BlockAxis across = blocksAlongX(surface_, block.level);
        const BlockAxis up = blocksAlongY(surface_, block.level);
        return {.low = box_.nearest(Vector2(across.low(block.column), up.low(block.row))),
                .high = box_.nearest(Vector2(across.high(block.column), up.high(block.row)))};
    }

    void add(Block block) {
        const double height = surface_.bounds().at(block.level, block.row, block.column).highest;
        const double nearest = (boxOf(block).nearest(axis_) - axis_).squaredNorm();
        block.highest = height + std::sqrt(std::max(radius_ * radius_ - nearest, 0.0));
        if (block.highest > best_) {
            waiting_.push_back(block);
            std::ranges::push_heap(waiting_, {}, &Block::highest);
        }
    }

    void addPartsOf(const Block& block) {
        constexpr int kFactor = CellBounds::kFactor;
        const int level = block.level - 1;
        const BlockAxis across = blocksAlongX(surface_, level);
        const BlockAxis up = blocksAlongY(surface_, level);
        const int firstRow = std::max(kFactor * block.row, up.at(box_.low.y()));
        const int lastRow = std::min(kFactor * (block.row + 1) - 1, up.at(box_.high.y()));
        const int firstColumn = std::max(kFactor * block.column, across.at(box_.low.x()));
        const int lastColumn = std::min(kFactor * (block.column + 1) - 1, across.at(box_.high.x()));
        for (int row = firstRow; row <= lastRow; ++row) {
            for (int column = firstColumn; column <= lastColumn; ++column) {
                add({.level = level, .row = row, .column = column});
            }
        }
    }

    void searchCell(const Box& cell) {
        constexpr int kSamples = 6;
        double highest = -std::numeric_limits<double>::max();
        Vector2 start = Vector2::Zero();
        for (int j = 0; j <= kSamples; ++j) {
            for (int i = 0; i <= kSamples; ++i) {
                const Vector2 share(static_cast<double>(i) / kSamples,
                                    static_cast<double>(j) / kSamples);
                const Vector2 place = cell.low + share.cwiseProduct(cell.high - cell.low);
                const double height = -depth_(place).value;
                if (height > highest) {
                    highest = height;
                    start = place;
                }
            }
        }
        polish(start);
    }

    void polish(const Vector2& start) {
        if (depth_.isUnderSphere(start)) {
            const BoxNewton newton(depth_, box_, 0.25 * surface_.finestPitch());
            best_ = std::max({best_, -depth_(start).value, -newton.minimize(start).model.value});
        }
    }

    const BSplineSurface& surface_;
    Vector2 axis_;
    double radius_;  ///< [m]
    CenterDepth depth_;
    Box box_;
    double best_ = -std::numeric_limits<double>::max();
    std::vector<Block> waiting_;  ///< a heap
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
