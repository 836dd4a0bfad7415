#include "core/surface/deformation/HighestPlace.h"

#include "core/Error.h"
#include "core/surface/closest/BoxNewton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace asperity {

namespace {

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
        model.gradientNoise = Vector2::Constant(rounding_.slope + rounding_.place * s.bend());
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

/// The pixels of one axis whose centers, brought into a box, are different places.
struct BoxPixels {
    int first = 0;
    int last = 0;
};

BoxPixels pixelsWithin(double low, double high, double pitch, int pixels) {
    const int above = static_cast<int>(std::ceil(low / pitch - 0.5));
    const int below = static_cast<int>(std::floor(high / pitch - 0.5));
    // One more on each side stands for all that the box cuts off there.
    return {std::clamp(above - 1, 0, pixels - 1), std::clamp(below + 1, 0, pixels - 1)};
}

/// Finds the highest of the pixel centers, and of the middle, that are allowed; brought into a box.
/// Of equally high ones the first row by row, from the bottom, the middle before all. Blocks that
/// their bounds show to lie lower are not looked into.
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
        return place_;
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

    void consider(const Vector2& place, const Order& order) {
        const double height = surface_.at(place.x(), place.y()).height;
        const bool isBetter = height > height_ || (height == height_ && order < order_);
        if (isBetter && isAllowed_(place)) {
            height_ = height;
            order_ = order;
            place_ = place;
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

    /// Whether it has cells with pixels that are looked at.
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
    std::optional<Vector2> place_;
    double height_ = -std::numeric_limits<double>::max();  ///< of the place [m]
    Order order_;
};

}  // namespace

SurfacePlace highestPlace(const BSplineSurface& surface, double marginFraction) {
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
    const Vector2 place = withData && !measured(top.place) ? highest : top.place;
    return {.x = place.x(), .y = place.y(), .height = surface.at(place.x(), place.y()).height};
}

}  // namespace asperity
