#include "core/surface/nurbs/NurbsShapes.h"

#include "core/Error.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

void requireLength(double length, const std::string& name) {
    if (!std::isfinite(length) || length <= 0.0) {
        throw Error("the " + name + " must be a positive length");
    }
}

/// A rational curve in the plane of an axis and the way out from it.
struct Profile {
    struct Point {
        double out = 0.0;  ///< distance from the axis [m]
        double up = 0.0;   ///< along the axis [m]
        double weight = 1.0;
    };

    int degree = 1;
    std::vector<double> knots;
    std::vector<Point> points;
};

/// Knots of a chain of quarter circles.
std::vector<double> quarterKnots(int quarters) {
    std::vector<double> knots{0.0};
    for (int i = 0; i <= quarters; ++i) {
        knots.insert(knots.end(), 2, i);
    }
    knots.push_back(quarters);
    return knots;
}

/// Corner k of the square around the unit circle (odd k), or its point between them (even k),
/// counted in eighths of a turn from (1, 0).
Vector2 squarePoint(int eighth) {
    constexpr std::array<std::array<double, 2>, 8> kPoints{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const auto& point = kPoints[static_cast<std::size_t>(eighth) % kPoints.size()];
    return {point[0], point[1]};
}

double arcWeight(int eighth) { return eighth % 2 == 0 ? 1.0 : std::sqrt(0.5); }

/// Quarters of a circle about (out, 0), from `start` eighths of a turn on.
Profile arcProfile(double out, double radius, int start, int quarters) {
    Profile profile{.degree = 2, .knots = quarterKnots(quarters), .points = {}};
    for (int i = start; i <= start + 2 * quarters; ++i) {
        const Vector2 point = radius * squarePoint(i);
        profile.points.push_back({out + point.x(), point.y(), arcWeight(i)});
    }
    return profile;
}

/// Turns a profile about the frame's axis. A profile that runs upwards outside has its outside
/// away from the axis.
NurbsSurface revolved(const RevolutionFrame& frame, const Profile& profile) {
    NurbsSurface::Net net{.degreeU = 2,
                          .degreeV = profile.degree,
                          .knotsU = quarterKnots(4),
                          .knotsV = profile.knots,
                          .points = {},
                          .weights = {}};
    for (const Profile::Point& point : profile.points) {
        for (int i = 0; i <= 8; ++i) {
            const Vector2 around = squarePoint(i);
            net.points.emplace_back(frame.center + point.up * frame.axis() +
                                    point.out *
                                        (around.x() * frame.first + around.y() * frame.second));
            net.weights.push_back(point.weight * arcWeight(i));
        }
    }
    return NurbsSurface(net);
}

}  // namespace

NurbsSurface sphereSurface(const RevolutionFrame& frame, double radius) {
    requireLength(radius, "radius of a sphere");
    return revolved(frame, arcProfile(0.0, radius, 6, 2));
}

NurbsSurface cylinderSurface(const RevolutionFrame& frame, double radius, double length) {
    requireLength(radius, "radius of a cylinder");
    requireLength(length, "length of a cylinder");
    return revolved(frame, {.degree = 1,
                            .knots = {0.0, 0.0, 1.0, 1.0},
                            .points = {{radius, -0.5 * length, 1.0}, {radius, 0.5 * length, 1.0}}});
}

NurbsSurface torusSurface(const RevolutionFrame& frame, double radius, double tubeRadius) {
    requireLength(tubeRadius, "radius of a torus's tube");
    if (!(std::isfinite(radius) && radius > tubeRadius)) {
        throw Error("the radius of a torus must be a length above that of its tube");
    }
    return revolved(frame, arcProfile(radius, tubeRadius, 0, 4));
}

NurbsSurface planeSurface(const Vector3& corner, const Vector3& sideU, const Vector3& sideV) {
    const double area = sideU.cross(sideV).norm();
    if (!(std::isfinite(area) && area > 0.0)) {
        throw Error("the sides of a plane must span an area");
    }
    return NurbsSurface({.degreeU = 1,
                         .degreeV = 1,
                         .knotsU = {0.0, 0.0, 1.0, 1.0},
                         .knotsV = {0.0, 0.0, 1.0, 1.0},
                         .points = {corner, corner + sideU, corner + sideV, corner + sideU + sideV},
                         .weights = {}});
}

}  // namespace asperity
