#include "app/recording/ForceTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

double normalForce(const TickOutput& output) noexcept {
    return output.estimate.force.dot(output.model.normal);
}

double normalForceSigma(const TickOutput& output) noexcept {
    const Vector3& normal = output.model.normal;
    return std::sqrt(std::max(normal.dot(output.estimate.covariance * normal), 0.0));
}

void ForceTrace::take(const TickSample& sample) {
    const TickOutput& output = sample.output;
    const bool isKnown =
        output.fault == Fault::None && output.estimate.kind != DecouplingCase::InvalidInput;
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    add(sample.time, isKnown ? normalForce(output) : kUnknown, output.model.contact.indentation);
}

void ForceTrace::add(double time, double force, double indentation) {
    const bool isKnown = std::isfinite(force) && std::isfinite(indentation);
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    time_.push_back(time);
    force_.push_back(isKnown ? force : kUnknown);
    indentation_.push_back(isKnown ? indentation : kUnknown);
}

}  // namespace asperity
