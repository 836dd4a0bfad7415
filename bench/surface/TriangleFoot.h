#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace asperity {

/// The point of a triangle nearest to `query`, by the region of its plane that the query is over.
template <class Point>
[[nodiscard]] Point nearestOnTriangle(const Point& query, const Point& a, const Point& b,
                                      const Point& c) {
    using Number = typename Point::Scalar;
    const auto onEdge = [&query](const Point& from, const Point& to) -> Point {
        const Point along = to - from;
        const Number share = along.dot(query - from) / along.squaredNorm();
        return from + std::clamp(share, Number(0), Number(1)) * along;
    };
    const Point normal = (b - a).cross(c - a);
    const bool besideAb = normal.cross(b - a).dot(query - a) < Number(0);
    const bool besideBc = normal.cross(c - b).dot(query - b) < Number(0);
    const bool besideCa = normal.cross(a - c).dot(query - c) < Number(0);
    if (!besideAb && !besideBc && !besideCa) {
        return query - normal * (normal.dot(query - a) / normal.squaredNorm());
    }
    Point best = a;
    const auto keep = [&](bool beside, const Point& candidate) {
        if (beside && (candidate - query).squaredNorm() < (best - query).squaredNorm()) {
            best = candidate;
        }
    };
    keep(besideAb, onEdge(a, b));
    keep(besideBc, onEdge(b, c));
    keep(besideCa, onEdge(c, a));
    return best;
}

}  // namespace asperity
