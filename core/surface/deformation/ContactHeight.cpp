#include "core/surface/deformation/ContactHeight.h"

#include "core/Error.h"
#include "core/surface/closest/BoundsWindow.h"
#include "core/surface/closest/BoxNewton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace asperity {

namespace {

/// Minus the height of the sphere's center when it touches the surface at a given position [m].
class CenterDepth {
public:
    CenterDepth(const BSplineSurface& surface, const Vector2& axis, double radius)
        : surface_(surface)
        , axis_(axis)
        , radius_(radius)
        , rounding_(roundingOf(surface, Vector3(axis.x(), axis.y(), radius))) {}

    [[nodiscard]] bool isUnderSphere(const Vector2& position) const {
        return (position - axis_).squaredNorm() < radius_ * radius_;
    }

    LocalModel operator()(const Vector2& position) const noexcept {
        LocalModel model;
        if (!isUnderSphere(position)) {
            model.value = kNever;
            return model;
        }
        const HeightSample s = surface_.at(position.x(), position.y());
        const Vector2 arm = position - axis_;
        const double rise = std::sqrt(radius_ * radius_ - arm.squaredNorm());
        const Matrix2 cap = (Matrix2::Identity() + arm * arm.transpose() / (rise * rise)) / rise;
        Matrix2 surfaceBend;
        surfaceBend << s.dxx, s.dxy, s.dxy, s.dyy;
        model.surface = s;
        model.value = -(s.height + rise);
        model.valueNoise = rounding_.height;
        model.gradient = arm / rise - Vector2(s.dx, s.dy);
        model.gradientNoise = Vector2::Constant(
            rounding_.slope + rounding_.position * (s.bend() + cap(0, 0) + cap(1, 1)));
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
                const Vector2 position = cell.low + share.cwiseProduct(cell.high - cell.low);
                const double height = -depth_(position).value;
                if (height > highest) {
                    highest = height;
                    start = position;
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

/// Minus the surface's height [m].
class SurfaceDepth {
public:
    SurfaceDepth(const BSplineSurface& surface, const Box& box)
        : surface_(surface)
        , boxSize_(std::max((box.high - box.low).maxCoeff(), surface.grid().pitchX))
        , rounding_(roundingOf(surface, Vector3::Zero())) {}

    LocalModel operator()(const Vector2& position) const noexcept {
        LocalModel model;
        const HeightSample s = surface_.at(position.x(), position.y());
        model.surface = s;
        model.value = -s.height;
        model.valueNoise = rounding_.height;
        model.gradient = -Vector2(s.dx, s.dy);
        model.gradientNoise = Vector2::Constant(rounding_.slope + rounding_.position * s.bend());
        model.hessian << -s.dxx, -s.dxy, -s.dxy, -s.dyy;
        // Not so flat that a step would leave the box by far.
        const double bend = std::max(s.bend(), model.gradient.norm() / boxSize_);
        model.convex = Matrix2::Identity() * std::max(bend, std::numeric_limits<double>::min());
        return model;
    }

private:
    const BSplineSurface& surface_;
    double boxSize_;  ///< [m]
    SurfaceRounding rounding_;
};

/// The pixels of one axis whose centers, brought into a box, are different positions.
struct BoxPixels {
    int first = 0;
    int last = 0;
};

BoxPixels pixelsWithin(double low, double high, double pitch, int pixels) {
    const int above = static_cast<int>(std::ceil(low / pitch - 0.5));
    const int below = static_cast<int>(std::floor(high / pitch - 0.5));
    // One more on each side represents all that the box cuts off there.
    return {std::clamp(above - 1, 0, pixels - 1), std::clamp(below + 1, 0, pixels - 1)};
}

/// Finds the highest of the pixel centers, and of the middle, that are allowed; brought into a box.
/// Ties go to the middle, else to the first row from the bottom, then to the first column. Blocks
/// that their bounds show to lie lower are skipped.
template <class IsAllowed>
class HighestPixel {
public:
    HighestPixel(const BSplineSurface& surface, const Box& box, const IsAllowed& isAllowed)
        : surface_(surface)
        , box_(box)
        , isAllowed_(isAllowed)
        , across_(pixelsWithin(box.low.x(), box.high.x(), surface.grid().pitchX,
                               surface.grid().columns))
        , up_(pixelsWithin(box.low.y(), box.high.y(), surface.grid().pitchY, surface.grid().rows)) {
    }

    [[nodiscard]] std::optional<Vector2> find() {
        consider(0.5 * Vector2(surface_.sizeX(), surface_.sizeY()), {-1, -1});
        const int top = surface_.bounds().levels() - 1;
        lookInto({.level = top, .row = 0, .column = 0});
        return position_;
    }

private:
    struct Order {
        int row = 0;
        int column = 0;
        [[nodiscard]] bool operator<(const Order& other) const {
            return std::tie(row, column) < std::tie(other.row, other.column);
        }
    };
    struct Block {
        int level = 0;
        int row = 0;
        int column = 0;
        double highest = 0.0;  ///< [m]
    };

    void consider(const Vector2& position, const Order& order) {
        const double height = surface_.at(position.x(), position.y()).height;
        const bool isBetter = height > height_ || (height == height_ && order < order_);
        if (isBetter && isAllowed_(position)) {
            height_ = height;
            order_ = order;
            position_ = position;
        }
    }

    void lookInto(const Block& block) {
        block.level == 0 ? lookIntoCell(block) : lookIntoParts(block);
    }

    /// The highest part first: then most others cannot be higher.
    void lookIntoParts(const Block& block) {
        constexpr int kFactor = CellBounds::kFactor;
        const CellBounds& bounds = surface_.bounds();
        const int level = block.level - 1;
        const CellBounds::Level& parts = bounds.level(level);
        std::array<Block, static_cast<std::size_t>(kFactor) * kFactor> order;
        std::size_t count = 0;
        const int rows = std::min(parts.rows, kFactor * (block.row + 1));
        const int columns = std::min(parts.columns, kFactor * (block.column + 1));
        for (int row = kFactor * block.row; row < rows; ++row) {
            for (int column = kFactor * block.column; column < columns; ++column) {
                if (isInBox(level, row, column)) {
                    const double highest = bounds.at(level, row, column).highest;
                    order[count++] = {level, row, column, highest};
                }
            }
        }
        std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                  [](const Block& a, const Block& b) { return a.highest > b.highest; });
        for (std::size_t i = 0; i < count && order[i].highest >= height_; ++i) {
            lookInto(order[i]);
        }
    }

    /// Returns whether it has cells with pixels that are looked at.
    [[nodiscard]] bool isInBox(int level, int row, int column) const {
        const auto meets = [level](int block, const BoxPixels& run) {
            int cells = 1;
            for (int i = 0; i < level; ++i) {
                cells *= CellBounds::kFactor;
            }
            return block * cells <= run.last && (block + 1) * cells > run.first;
        };
        return meets(row, up_) && meets(column, across_);
    }

    /// The pixel at its corner, and the last ones of the box, which lie at the corners of no other.
    void lookIntoCell(const Block& cell) {
        const int lastRow = cell.row + 1 == up_.last ? up_.last : cell.row;
        const int lastColumn = cell.column + 1 == across_.last ? across_.last : cell.column;
        for (int row = cell.row; row <= lastRow; ++row) {
            for (int column = cell.column; column <= lastColumn; ++column) {
                const Vector2 center((column + 0.5) * surface_.grid().pitchX,
                                     (row + 0.5) * surface_.grid().pitchY);
                consider(box_.nearest(center), {row, column});
            }
        }
    }

    const BSplineSurface& surface_;
    Box box_;
    const IsAllowed& isAllowed_;
    BoxPixels across_;
    BoxPixels up_;
    std::optional<Vector2> position_;
    double height_ = -std::numeric_limits<double>::max();  ///< of the position [m]
    Order order_;
};

}  // namespace

double tipContactHeight(const BSplineSurface& surface, double x, double y, double tipRadius) {
    if (!std::isfinite(tipRadius) || tipRadius <= 0.0) {
        throw Error("the tip radius must be a positive length");
    }
    if (!std::isfinite(x) || !std::isfinite(y)) {
        throw Error("the tip position must be finite");
    }
    const Vector2 axis(x, y);
    const Vector2 nearest = scanBox(surface).nearest(axis);
    const bool reachesScan = (nearest - axis).norm() < tipRadius;
    return ContactSearch(surface, reachesScan ? axis : nearest, tipRadius).run();
}

SurfacePoint highestPoint(const BSplineSurface& surface, double marginFraction) {
    if (!std::isgreaterequal(marginFraction, 0.0) || marginFraction > 0.5) {
        throw Error("the margin must be between 0 and 0.5 of the scan");
    }
    const Vector2 size(surface.sizeX(), surface.sizeY());
    const Box box{.low = marginFraction * size, .high = (1.0 - marginFraction) * size};
    const auto everywhere = [](const Vector2&) { return true; };
    const auto measured = [&](const Vector2& p) { return surface.isMeasured(p.x(), p.y()); };
    const std::optional<Vector2> withData = HighestPixel(surface, box, measured).find();
    const Vector2 highest =
        withData ? *withData : HighestPixel(surface, box, everywhere).find().value();
    const SurfaceDepth depth(surface, box);
    const BoxMinimum top = BoxNewton(depth, box, 0.25 * surface.finestPitch()).minimize(highest);
    const Vector2 best = withData && !measured(top.position) ? highest : top.position;
    return {.x = best.x(), .y = best.y(), .height = surface.at(best.x(), best.y()).height};
}

}  // namespace asperity
