#include "core/haptics/PlannedApproach.h"

#include "core/contact/laws/ForceCurve.h"
#include "core/scene/Scene.h"

#include <cmath>

namespace asperity {

namespace {

// Of the duration; a descent at its limit and the way back still fit.
constexpr double kBaselineShare = 0.02;
constexpr double kDescentShare = 0.36;  // to the setpoint, as expected
constexpr double kLimitShare = 0.45;    // at most
constexpr double kDwellShare = 0.05;

/// Of the base below first touch at a place, for a force without adhesion [m]: Hertz and the lever.
/// Source: docs/theory.md 2.2.
double expectedDepth(const Scene& scene, const Vector3& place, double force) {
    const ContactPair pair = scene.belief.pairAt(place, scene.belief.tipRadius());
    const double stiffness = 4.0 / 3.0 * pair.reducedModulus * std::sqrt(pair.tipRadius);
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    return std::pow(force / stiffness, 2.0 / 3.0) + compliance * force;
}

/// The same by the scene's law [m]; 0 where it does not reach the force.
double depthByLaw(const Scene& scene, const Vector3& place, double force) {
    const ProbeSystem& belief = scene.belief;
    const ContactModel model = belief.contact.withPair(belief.pairAt(place, belief.tipRadius()));
    return basePositionAt(model, belief.cantilever.compliance()(2, 2), force).value_or(0.0);
}

}  // namespace

PlannedApproach planApproach(const Scene& scene, const PathPlan& plan) {
    const Vector3 start = pathStart(scene, plan);
    const double clearance = start.z() - touchHeight(scene, start.x(), start.y());
    const double setpoint = plan.setpoint.value_or(scene.description.setpoint);
    const double expected = clearance + expectedDepth(scene, start, setpoint);
    // Adhesion holds a soft sample on a cone far above where Hertz has the setpoint.
    const double needed = clearance + depthByLaw(scene, start, setpoint);
    const double descent = needed > kLimitShare / kDescentShare * expected ? needed : expected;
    const double speed = descent / (kDescentShare * plan.duration);
    return {.start = start,
            .plan = {.setpoint = setpoint,
                     .speed = speed,
                     .stiffness = 1.0 / scene.belief.cantilever.compliance()(2, 2),
                     .baseline = kBaselineShare * plan.duration,
                     .dwell = kDwellShare * plan.duration,
                     .maxDescent = speed * kLimitShare * plan.duration}};
}

}  // namespace asperity
