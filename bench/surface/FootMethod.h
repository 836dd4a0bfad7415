#pragma once

#include "core/Vector.h"

#include <string>

namespace asperity {

/// Where a method puts the foot of a query; its height is read off the spline surface itself.
struct FootAnswer {
    Vector2 place = Vector2::Zero();  ///< world x, y [m]
    bool certified = false;           ///< said to be proven the nearest
};

/// One way to find the closest point on a surface, query after query along a path.
class FootMethod {
public:
    FootMethod() = default;
    FootMethod(const FootMethod&) = delete;
    FootMethod& operator=(const FootMethod&) = delete;
    virtual ~FootMethod() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    /// Begins a path whose first query has its foot at this place, world [m].
    virtual void start(const Vector2& foot) = 0;
    /// The foot of the next query, world [m].
    [[nodiscard]] virtual FootAnswer next(const Vector3& query) = 0;
    /// At most this many queries a run: the slow ones are asked less often. 0: all
    [[nodiscard]] virtual std::size_t mostQueries() const { return 0; }
};

}  // namespace asperity
