#include "core/haptics/cycle/ForceDistancePoint.h"

#include <algorithm>
#include <cmath>

namespace asperity {

bool hasPoint(const TickOutput& out) noexcept {
    const TipState& model = out.model;
    return !isInvalid(out.flags) && model.contact.solved() &&
           std::isfinite(model.contact.indentation) && model.tip.allFinite() &&
           model.normal.allFinite() && out.base.position.allFinite() && out.tip.allFinite() &&
           out.estimate.force.allFinite() && out.estimate.covariance.allFinite();
}

ForceDistancePoint forceDistancePoint(const TickOutput& out) noexcept {
    const Vector3& normal = out.model.normal;
    const double variance = normal.dot(out.estimate.covariance * normal);
    const double separationOfModel = -out.model.contact.indentation;
    return {.force = out.estimate.force.dot(normal),
            .sigma = std::sqrt(std::max(0.0, variance)),
            .separation = separationOfModel + normal.dot(out.tip - out.model.tip),
            .baseDistance = separationOfModel + normal.dot(out.base.position - out.model.tip)};
}

}  // namespace asperity
