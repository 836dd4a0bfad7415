#include "core/surface/SurfaceRay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kStep = 0.5;      // of a pixel, along the ground
constexpr int kMaxSteps = 100000;  // beyond, steps become longer
constexpr int kMaxHalvings = 200;
constexpr double kTolerance = 1e-14;  // of the part of the ray that is searched

/// A part of a ray, by multiples of its direction.
struct Stretch {
    double from = 0.0;
    double to = std::numeric_limits<double>::infinity();

    /// Keeps what lies between two planes across one axis.
    void clip(double origin, double direction, double low, double high) {
        if (direction == 0.0) {
            if (origin < low || origin > high) {
                to = -1.0;
            }
            return;
        }
        const double first = (low - origin) / direction;
        const double second = (high - origin) / direction;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    }
    [[nodiscard]] bool empty() const { return !(from <= to); }
};

}  // namespace

std::optional<Vector3> firstHit(const BSplineSurface& surface, const SurfaceRay& ray,
                                const Vector2& low, const Vector2& high) {
    const Vector3 direction = ray.direction.normalized();
    if (!direction.allFinite() || !ray.origin.allFinite()) {
        return std::nullopt;
    }
    Stretch stretch;
    stretch.clip(ray.origin.x(), direction.x(), low.x(), high.x());
    stretch.clip(ray.origin.y(), direction.y(), low.y(), high.y());
    const double pixel = std::min(surface.grid().pitchX, surface.grid().pitchY);
    const double top = surface.heightScale() + pixel;  // no height is larger in magnitude
    stretch.clip(ray.origin.z(), direction.z(), -top, top);
    if (stretch.empty() || !std::isfinite(stretch.to)) {
        return std::nullopt;
    }
    const auto pointAt = [&](double way) -> Vector3 { return ray.origin + way * direction; };
    const auto above = [&](double way) {
        const Vector3 point = pointAt(way);
        return point.z() - surface.at(point.x(), point.y()).height;
    };
    const auto place = [&](double way) -> Vector3 {
        const Vector3 point = pointAt(way);
        return {point.x(), point.y(), surface.at(point.x(), point.y()).height};
    };
    const double length = stretch.to - stretch.from;
    const double ground = direction.head<2>().norm() * length;
    const int steps =
        static_cast<int>(std::clamp(std::ceil(ground / (kStep * pixel)), 1.0, double(kMaxSteps)));
    double before = stretch.from;
    if (above(before) < 0.0) {
        return std::nullopt;
    }
    for (int step = 1; step <= steps; ++step) {
        double after = std::lerp(stretch.from, stretch.to, step / double(steps));
        if (above(after) > 0.0) {
            before = after;
            continue;
        }
        for (int i = 0; i < kMaxHalvings && after - before > kTolerance * length; ++i) {
            const double middle = 0.5 * (before + after);
            if (middle <= before || middle >= after) {
                break;
            }
            (above(middle) > 0.0 ? before : after) = middle;
        }
        return place(after);
    }
    return std::nullopt;
}

}  // namespace asperity
