#include "core/surface/foot/FootTracker.h"

#include <algorithm>

namespace asperity {

namespace {

/// Radius of the balls that are tried: in larger ones a foot stands alone less often [pixel].
constexpr double kBall = 0.125;
/// Queries after which another ball is tried where none was proven. A try costs about as much as it
/// spares each of the queries after it.
constexpr int kLongestRest = 31;

}  // namespace

FootProof FootTracker::completeFeet(const BSplineSurface& surface, const Vector3& query,
                                    const FootReach& reach, FootList& feet) noexcept {
    if (ball_.settles(query, reach, feet.all().front())) {
        return FootProof::Nearest;
    }
    if (untilNextTry_ > 0) {
        --untilNextTry_;
        return asperity::completeFeet(surface, query, reach, feet);
    }
    const double radius = kBall * std::min(surface.grid().pitchX, surface.grid().pitchY);
    const FootProof proof = asperity::completeFeet(surface, {query, radius}, reach, feet, ball_);
    rest_ = ball_.queries.radius > 0.0 ? 0 : std::min(2 * rest_ + 1, kLongestRest);
    untilNextTry_ = rest_;
    return proof;
}

}  // namespace asperity
