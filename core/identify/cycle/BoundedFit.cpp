#include "core/identify/cycle/BoundedFit.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

using Eigen::Index;

/// Value of a parameter that the solver moved by `step` from its start.
double valueAt(const FreeParameter& parameter, double step) {
    const double value =
        parameter.scale > 0.0 ? parameter.start + step : parameter.start * std::exp(step);
    return std::clamp(value, parameter.low, parameter.high);
}

bool isAtBound(const FreeParameter& parameter, double value) {
    constexpr double kNear = 1e-3;  // of a logarithm, or of the scale
    if (parameter.scale > 0.0) {
        const double near = kNear * parameter.scale;
        return value <= parameter.low + near || value >= parameter.high - near;
    }
    return value <= parameter.low * (1.0 + kNear) || value >= parameter.high * (1.0 - kNear);
}

std::vector<double> valuesAt(const std::vector<FreeParameter>& parameters,
                             const Eigen::VectorXd& steps) {
    std::vector<double> values(parameters.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = valueAt(parameters[i], steps[static_cast<Index>(i)]);
    }
    return values;
}

}  // namespace

double BoundedFit::std(std::size_t parameter) const {
    const double std = fit.std(static_cast<Index>(parameter));
    return parameters[parameter].scale > 0.0 ? std : values[parameter] * std;
}

std::vector<IdentifiedValue> BoundedFit::identified() const {
    std::vector<IdentifiedValue> all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        all.push_back({.key = parameters[i].key,
                       .value = values[i],
                       .std = std(i),
                       .unit = parameters[i].unit});
    }
    return all;
}

/// A place has no size that its deviation could exceed: only a singular fit leaves it unknown.
bool BoundedFit::isIdentified(std::size_t parameter) const {
    const FreeParameter& free = parameters[parameter];
    const double largest = free.scale > 0.0 ? free.high - free.low : values[parameter];
    return !isAtBound(free, values[parameter]) && std(parameter) < largest;
}

std::vector<std::string> BoundedFit::notIdentified() const {
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!isIdentified(i)) {
            missing.push_back(parameters[i].key);
        }
    }
    return missing;
}

std::vector<CorrelatedPair> BoundedFit::correlated() const {
    constexpr double kTooAlike = 0.95;
    std::vector<CorrelatedPair> pairs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t j = i + 1; j < values.size(); ++j) {
            const double both = fit.correlation(static_cast<Index>(i), static_cast<Index>(j));
            if (isIdentified(i) && isIdentified(j) && std::abs(both) > kTooAlike) {
                pairs.push_back({parameters[i].key, parameters[j].key, both});
            }
        }
    }
    return pairs;
}

BoundedFit fitWithin(const std::vector<FreeParameter>& parameters,
                     const BoundedResiduals& residuals, std::size_t count) {
    const auto size = static_cast<Index>(parameters.size());
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(size);
    for (Index i = 0; i < size; ++i) {
        const double given = parameters[static_cast<std::size_t>(i)].scale;
        scale[i] = given > 0.0 ? given : scale[i];
    }
    BoundedFit bounded;
    bounded.parameters = parameters;
    bounded.fit =
        leastSquares([&](const Eigen::VectorXd& steps,
                         Eigen::VectorXd& out) { residuals(valuesAt(parameters, steps), out); },
                     Eigen::VectorXd::Zero(size), scale, count);
    bounded.values = valuesAt(parameters, bounded.fit.parameters);
    return bounded;
}

}  // namespace asperity
