#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace asperity {

/// The point of a triangle nearest to `query`. Outside it that lies on an edge that the query is
/// beyond: at most two come into question.
template <class Point>
[[nodiscard]] Point nearestOnTriangle(const Point& query, const Point& a, const Point& b,
                                      const Point& c) {
    using Number = typename Point::Scalar;
    const Point first = b - a;
    const Point second = c - a;
    const Point arm = query - a;
    const Number alongFirst = first.dot(arm);
    const Number alongSecond = second.dot(arm);
    const Number firstSquared = first.squaredNorm();
    const Number secondSquared = second.squaredNorm();
    const Number mixed = first.dot(second);
    const Number s = secondSquared * alongFirst - mixed * alongSecond;
    const Number t = firstSquared * alongSecond - mixed * alongFirst;
    const Number whole = firstSquared * secondSquared - mixed * mixed;
    const auto share = [](Number part, Number of) {
        return std::clamp(part / of, Number(0), Number(1));
    };
    if (s >= Number(0) && t >= Number(0) && s + t <= whole) {
        return a + (s * first + t * second) / whole;
    }
    Point best = a;
    Number least = arm.squaredNorm();
    const auto keep = [&](const Point& candidate) {
        const Number squared = (candidate - query).squaredNorm();
        if (squared < least) {
            best = candidate;
            least = squared;
        }
    };
    if (t < Number(0)) {
        keep(a + share(alongFirst, firstSquared) * first);
    }
    if (s < Number(0)) {
        keep(a + share(alongSecond, secondSquared) * second);
    }
    if (s + t > whole) {
        keep(b + share(alongSecond - alongFirst + firstSquared - mixed,
                       firstSquared + secondSquared - Number(2) * mixed) *
                     (second - first));
    }
    return best;
}

}  // namespace asperity
