#include "core/surface/TangentFrame.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <limits>

namespace asperity {

namespace {

constexpr double kBelowAll = -std::numeric_limits<double>::infinity();

/// Height above `base` along the normal at which the surface is met [m], by Newton's method.
double heightAlong(const BSplineSurface& surface, const Vector3& base, const Vector3& normal) {
    constexpr int kMaxSteps = 12;
    constexpr double kExact = 1e-14;   // [m]
    constexpr double kGrazing = 0.05;  // sine of the angle between normal and surface
    double height = 0.0;
    for (int i = 0; i < kMaxSteps; ++i) {
        const Vector3 point = base + height * normal;
        const HeightSample sample = surface.at(point.x(), point.y());
        const double slope = normal.z() - sample.dx * normal.x() - sample.dy * normal.y();
        if (slope < kGrazing) {
            return kBelowAll;
        }
        const double step = (sample.height - point.z()) / slope;
        height += step;
        if (std::abs(step) < kExact) {
            return height;
        }
    }
    return kBelowAll;
}

}  // namespace

Vector3 TangentFrame::local(const Vector3& world) const {
    const Vector3 arm = world - origin;
    return {arm.dot(along), arm.dot(across), arm.dot(normal)};
}

TangentFrame tangentFrame(const Vector3& origin, const Vector3& normal) {
    constexpr double kNearlyX = 0.9;
    const Vector3 axis = std::abs(normal.x()) < kNearlyX ? Vector3::UnitX() : Vector3::UnitZ();
    const Vector3 along = (axis - axis.dot(normal) * normal).normalized();
    return {.origin = origin, .along = along, .across = normal.cross(along), .normal = normal};
}

std::vector<double> heightsOver(const BSplineSurface& surface, const TangentFrame& frame,
                                int samples, double pitch) {
    const auto position = [&](int index) { return (index - 0.5 * (samples - 1)) * pitch; };
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples));
    for (int row = 0; row < samples; ++row) {
        const Vector3 start = frame.origin + position(row) * frame.across;
        for (int column = 0; column < samples; ++column) {
            heights.push_back(
                heightAlong(surface, start + position(column) * frame.along, frame.normal));
        }
    }
    return heights;
}

}  // namespace asperity
