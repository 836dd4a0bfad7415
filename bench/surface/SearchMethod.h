#pragma once

#include "core/Vector.h"

#include <string>

namespace asperity {

/// Closest point of a query by a method; its height is read off the spline surface itself.
struct SearchAnswer {
    Vector2 position = Vector2::Zero();  ///< world x, y [m]
    bool certified = false;              ///< said to be proven the nearest
};

/// One way to find the closest point on a surface, query after query along a path.
class SearchMethod {
public:
    SearchMethod() = default;
    SearchMethod(const SearchMethod&) = delete;
    SearchMethod& operator=(const SearchMethod&) = delete;
    virtual ~SearchMethod() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    /// Begins a path whose first query has its closest point at this position, world [m].
    virtual void start(const Vector2& closest) = 0;
    /// The closest point of the next query, world [m].
    [[nodiscard]] virtual SearchAnswer next(const Vector3& query) = 0;
    /// At most this many queries a run: the slow ones are asked less often. 0: all
    [[nodiscard]] virtual std::size_t mostQueries() const { return 0; }
};

}  // namespace asperity
