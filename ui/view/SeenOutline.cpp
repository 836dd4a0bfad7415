#include "ui/view/SeenOutline.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace asperity {

namespace {

/// A point of the body as it is seen.
struct SeenPoint {
    Vector2 seen;  ///< rightwards, upwards
    Vector3 world;
};

/// Returns whether the way from `a` over `b` to `c` turns right or goes straight on.
bool isNoLeftTurn(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c) {
    const Vector2 first = b.seen - a.seen;
    const Vector2 second = c.seen - a.seen;
    return first.x() * second.y() - first.y() * second.x() <= 0.0;
}

/// Half of the convex hull of points in their order, its ends included.
std::vector<SeenPoint> hullChain(const std::vector<SeenPoint>& points) {
    std::vector<SeenPoint> chain;
    for (const SeenPoint& point : points) {
        while (chain.size() > 1 && isNoLeftTurn(chain.end()[-2], chain.back(), point)) {
            chain.pop_back();
        }
        chain.push_back(point);
    }
    return chain;
}

}  // namespace

SeenOutline seenOutline(vtkPolyData* body, const SeenAxes& axes, const DrawnSpace& space) {
    std::vector<SeenPoint> points;
    points.reserve(static_cast<std::size_t>(body->GetNumberOfPoints()));
    for (vtkIdType id = 0; id < body->GetNumberOfPoints(); ++id) {
        const Vector3 position(body->GetPoint(id));
        const Vector3 drawn = space.point(position);
        points.push_back({{axes.right.dot(drawn), axes.up.dot(drawn)}, position});
    }
    std::ranges::sort(points, {}, [](const SeenPoint& point) {
        return std::pair(point.seen.x(), point.seen.y());
    });
    SeenOutline outline{.corners = {}, .rightEnd = points.back().world};
    for (int half = 0; half < 2; ++half) {
        std::ranges::transform(hullChain(points), std::back_inserter(outline.corners),
                               &SeenPoint::world);
        std::ranges::reverse(points);
    }
    return outline;
}

}  // namespace asperity
