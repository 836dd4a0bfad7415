#include "core/experiment/OperatedBench.h"

namespace asperity {

DeviceState OperatedBench::advance(double timeStep) noexcept {
    timeStep_ = timeStep;
    operator_.feel(force_, timeStep);
    bench_.reachFor(operator_.advance(timeStep));
    return bench_.advance(timeStep);
}

void OperatedBench::setForce(const Vector3& force) noexcept {
    force_ = force;
    bench_.setForce(force);
}

void OperatedBench::observe(const TickOutput& output) noexcept {
    const bool isInside = output.model.contact.indentation > 0.0;
    operator_.see({.tip = output.model.tip, .hidden = isInside && !deformationShown_}, timeStep_);
}

}  // namespace asperity
