#include "core/surface/closest/Part.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

/// Nearer than this to the scan's edge is at it [pixel].
constexpr double kEdge = 1e-9;

/// How the distance goes along one axis, anywhere in a part.
enum class Course : std::uint8_t {
    Unclear,
    Falls,        ///< towards a side, and goes on falling behind it: no minimum in the part
    FallsToEdge,  ///< towards a side that is the scan's edge: a minimum can only lie on it
};
using Courses = std::array<Course, 2>;

Courses coursesIn(const Part& part, const Box& box, const Box& scan) {
    Courses courses{};
    for (int axis = 0; axis < 2; ++axis) {
        const double slope = part.gradient[axis];
        if (std::abs(slope) > part.spread[axis]) {
            const bool atEdge =
                slope > 0.0 ? box.low[axis] <= scan.low[axis] : box.high[axis] >= scan.high[axis];
            courses[static_cast<std::size_t>(axis)] = atEdge ? Course::FallsToEdge : Course::Falls;
        }
    }
    return courses;
}

/// Whether the scan's edge leaves a minimum one place in the part at most.
bool isConvexAtEdge(const Part& part, const Courses& courses) {
    const bool heldX = courses[0] == Course::FallsToEdge;
    const bool heldY = courses[1] == Course::FallsToEdge;
    return (heldX && (heldY || part.bend.y() > 0.0)) || (heldY && part.bend.x() > 0.0);
}

/// Whether a part lies off the scan's edge, so that a minimum in it needs a level gradient and a
/// distance that bends up.
bool isInside(const Box& box, const Box& scan) {
    return box.low.x() > scan.low.x() && box.low.y() > scan.low.y() &&
           box.high.x() < scan.high.x() && box.high.y() < scan.high.y();
}

}  // namespace

Box boxOf(const Part& part, const BSplineSurface& surface) noexcept {
    const Box scan = scanBox(surface);
    const Vector2 near(kEdge * surface.grid().pitchX, kEdge * surface.grid().pitchY);
    Box box{.low = part.center - part.half, .high = part.center + part.half};
    for (int axis = 0; axis < 2; ++axis) {
        box.low[axis] =
            box.low[axis] <= scan.low[axis] + near[axis] ? scan.low[axis] : box.low[axis];
        box.high[axis] =
            box.high[axis] >= scan.high[axis] - near[axis] ? scan.high[axis] : box.high[axis];
    }
    return box;
}

MinimaIn minimaIn(const Part& part, const Box& box, const BSplineSurface& surface) noexcept {
    const Box scan = scanBox(surface);
    if (isInside(box, scan)) {
        if (part.withoutMinimum) {
            return MinimaIn::None;
        }
        return part.convex ? MinimaIn::OneAtMost : MinimaIn::Unknown;
    }
    const Courses courses = coursesIn(part, box, scan);
    if (std::ranges::count(courses, Course::Falls) > 0) {
        return MinimaIn::None;
    }
    return part.convex || isConvexAtEdge(part, courses) ? MinimaIn::OneAtMost : MinimaIn::Unknown;
}

}  // namespace asperity
