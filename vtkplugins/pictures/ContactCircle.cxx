#include "vtkplugins/pictures/ContactCircle.h"

#include "vtkplugins/pictures/RestingPatch.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kPoints = 180;
constexpr int kBlurred = 4;       ///< points on either side: about two samples of the patch
constexpr double kMaxStep = 3.0;  ///< between points, in steps of a flat circle

/// The surface at rest around the circle, and how far it has moved outwards there.
struct MovedPoint {
    Vector3 rest;
    double moved = 0.0;  ///< [m]
};

std::vector<MovedPoint> aroundContact(const SurfacePatch& patch, const ContactEdge& edge) {
    const RestingPatch resting(patch);
    const Vector3 across = edge.outward.unitOrthogonal();
    const Vector3 third = edge.outward.cross(across);
    std::vector<MovedPoint> around;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        const Vector3 arm = std::cos(angle) * across + std::sin(angle) * third;
        const Vector3 rest = resting.closest(edge.center + edge.radius * arm, edge.outward);
        const Vector3 point = resting.at(patch.points, rest.x(), rest.y());
        around.push_back({rest, (point - rest).dot(edge.outward)});
    }
    return around;
}

/// A mean along the circle: between the samples of a sharp rim the patch alone is ragged.
double smoothMove(const std::vector<MovedPoint>& around, int place) {
    double sum = 0.0;
    for (int i = place - kBlurred; i <= place + kBlurred; ++i) {
        sum += around[static_cast<std::size_t>((i + kPoints) % kPoints)].moved;
    }
    return sum / (2 * kBlurred + 1);
}

}  // namespace

std::vector<std::vector<Vector3>> contactCircle(const SurfacePatch& patch,
                                                const ContactEdge& edge) {
    const std::vector<MovedPoint> around = aroundContact(patch, edge);
    const double longest = kMaxStep * 2.0 * std::numbers::pi * edge.radius / kPoints;
    std::vector<std::vector<Vector3>> pieces(1);
    for (int i = 0; i <= kPoints; ++i) {
        const Vector3 point = around[static_cast<std::size_t>(i % kPoints)].rest +
                              smoothMove(around, i % kPoints) * edge.outward;
        if (!pieces.back().empty() && (point - pieces.back().back()).norm() > longest) {
            pieces.emplace_back();
        }
        pieces.back().push_back(point);
    }
    return pieces;
}

}  // namespace asperity
