#include "core/haptics/cycle/CurveBranch.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Height that was commanded: under tip control the base also moves to compensate the deflection,
/// up while the tip goes down where the sample attracts it [m].
double commandedHeight(const TickInput& input, const TickOutput& out) noexcept {
    return input.settings.positionControl == PositionControl::Tip ? out.model.tip.z()
                                                                  : out.base.position.z();
}

}  // namespace

CurveBranch BranchTracker::take(const TickInput& input, const TickOutput& out) noexcept {
    const double height = commandedHeight(input, out);
    if (!std::isfinite(height)) {
        return branch_;
    }
    if (!started_) {
        started_ = true;
        farthest_ = height;
    }
    const bool down = branch_ == CurveBranch::Approach;
    farthest_ = down ? std::min(farthest_, height) : std::max(farthest_, height);
    if (std::abs(height - farthest_) > kTurn) {
        branch_ = down ? CurveBranch::Retract : CurveBranch::Approach;
        farthest_ = height;
    }
    return branch_;
}

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
