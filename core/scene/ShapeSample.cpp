#include "core/scene/ShapeSample.h"

#include "core/surface/nurbs/NurbsShapes.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <cmath>

namespace asperity {

namespace {

constexpr int kMapPixels = 256;
/// A soft lever that holds on to a plane is bent by many windows, and its tip moves along.
constexpr double kWindowsBeyond = 100.0;

/// About an axis along y, so that poles, which cost the search time, are where no tip gets.
RevolutionFrame frameOf(const ShapeDescription& shape) {
    const double middle = 0.5 * shape.size;
    return {.center = Vector3(middle, middle, shape.radius),
            .first = -Vector3::UnitZ(),
            .second = -Vector3::UnitX()};
}

/// The upper side of a shape, world frame [m].
class UpperSide {
public:
    explicit UpperSide(const ShapeDescription& shape) : shape_(shape) {}

    [[nodiscard]] double height(double x, double y) const {
        const double along = x - 0.5 * shape_.size;
        const double across = shape_.kind == ShapeKind::Sphere ? y - 0.5 * shape_.size : 0.0;
        if (shape_.kind == ShapeKind::Plane) {
            return std::tan(shape_.slope) * along;
        }
        const double square = shape_.radius * shape_.radius - along * along - across * across;
        return shape_.radius + std::sqrt(square);
    }

private:
    ShapeDescription shape_;
};

}  // namespace

NurbsSurface shapeSurface(const ShapeDescription& shape) {
    checkShape(shape);
    switch (shape.kind) {
    case ShapeKind::Sphere:
        return sphereSurface(frameOf(shape), shape.radius);
    case ShapeKind::Cylinder:
        return cylinderSurface(frameOf(shape), shape.radius, shape.size);
    case ShapeKind::Plane:
        break;
    }
    const double side = (1.0 + 2.0 * kWindowsBeyond) * shape.size;
    const double corner = -kWindowsBeyond * shape.size;
    const double rise = std::tan(shape.slope) * side;
    return planeSurface(Vector3(corner, corner, -0.5 * rise), Vector3(side, 0.0, rise),
                        Vector3(0.0, side, 0.0));
}

HeightMap shapeMap(const ShapeDescription& shape) {
    checkShape(shape);
    return sampledMap(
        {.columns = kMapPixels, .rows = kMapPixels, .sizeX = shape.size, .sizeY = shape.size},
        UpperSide(shape));
}

}  // namespace asperity
