#include "bench/surface/NewtonSearch.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kMaxSteps = 60;
constexpr int kMaxHalvings = 30;

/// Half the squared distance, and the step that Newton's method takes from here.
struct Expansion {
    double value = 0.0;              ///< [m^2]
    Vector2 step = Vector2::Zero();  ///< [m]
};

/// The Hessian of half the squared distance.
struct Hessian {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    [[nodiscard]] bool isConvex() const { return xx > 0.0 && xx * yy - xy * xy > 1e-6 * xx * yy; }
};

/// The downward step where the Hessian has a direction without or with downward curvature: each of
/// its eigenvalues counts with its magnitude.
Vector2 stepOffSaddle(const Hessian& h, const Vector2& gradient) {
    constexpr double kMinCurvature = 1e-7;
    const double mean = 0.5 * (h.xx + h.yy);
    const double turn = 0.5 * std::atan2(2.0 * h.xy, h.xx - h.yy);
    const double spread = std::hypot(0.5 * (h.xx - h.yy), h.xy);
    const Vector2 steep(std::cos(turn), std::sin(turn));
    const Vector2 flat(-steep.y(), steep.x());
    return -steep * (gradient.dot(steep) / std::max(std::abs(mean + spread), kMinCurvature)) -
           flat * (gradient.dot(flat) / std::max(std::abs(mean - spread), kMinCurvature));
}

/// Returns whether the edge of the scan holds a position back that would go down across it.
bool isHeld(double position, double size, double gradient) {
    return (position <= 0.0 && gradient >= 0.0) || (position >= size && gradient <= 0.0);
}

Expansion expandedAt(const BSplineSurface& surface, const Vector3& query, const Vector2& position) {
    const HeightSample s = surface.at(position.x(), position.y());
    const double rx = position.x() - query.x();
    const double ry = position.y() - query.y();
    const double rz = s.height - query.z();
    Vector2 g(rx + rz * s.dx, ry + rz * s.dy);
    Hessian h{.xx = 1.0 + s.dx * s.dx + rz * s.dxx,
              .xy = s.dx * s.dy + rz * s.dxy,
              .yy = 1.0 + s.dy * s.dy + rz * s.dyy};
    if (isHeld(position.x(), surface.sizeX(), g.x())) {
        g.x() = 0.0;
        h = {.xx = 1.0, .xy = 0.0, .yy = h.yy};
    }
    if (isHeld(position.y(), surface.sizeY(), g.y())) {
        g.y() = 0.0;
        h = {.xx = h.xx, .xy = 0.0, .yy = 1.0};
    }
    const double value = 0.5 * (rx * rx + ry * ry + rz * rz);
    if (!h.isConvex()) {
        return {.value = value, .step = stepOffSaddle(h, g)};
    }
    const double scale = 1.0 / (h.xx * h.yy - h.xy * h.xy);
    return {.value = value,
            .step = Vector2(h.xy * g.y() - h.yy * g.x(), h.xy * g.x() - h.xx * g.y()) * scale};
}

Vector2 insideScan(const BSplineSurface& surface, const Vector2& position) {
    return {std::clamp(position.x(), 0.0, surface.sizeX()),
            std::clamp(position.y(), 0.0, surface.sizeY())};
}

}  // namespace

Vector2 newtonPoint(const BSplineSurface& surface, const Vector3& query, const Vector2& start,
                    NewtonEnd end) {
    Vector2 position = insideScan(surface, start);
    Expansion here = expandedAt(surface, query, position);
    for (int i = 0; i < kMaxSteps; ++i) {
        if (here.step.squaredNorm() < end.step * end.step) {
            return insideScan(surface, position + here.step);
        }
        double share = 1.0;
        Vector2 there = insideScan(surface, position + here.step);
        Expansion next = expandedAt(surface, query, there);
        for (int j = 0; next.value > here.value && j < kMaxHalvings; ++j) {
            share *= 0.5;
            there = insideScan(surface, position + share * here.step);
            next = expandedAt(surface, query, there);
        }
        if (next.value >= here.value) {
            return position;
        }
        position = there;
        here = next;
    }
    return position;
}

double distanceTo(const BSplineSurface& surface, const Vector3& query, const Vector2& position) {
    const double height = surface.at(position.x(), position.y()).height;
    return (query - Vector3(position.x(), position.y(), height)).norm();
}

}  // namespace asperity
