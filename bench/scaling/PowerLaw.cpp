#include "bench/scaling/PowerLaw.h"

#include "core/Error.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace asperity {

namespace {

std::vector<double> logarithms(std::span<const double> values) {
    std::vector<double> logs;
    logs.reserve(values.size());
    for (const double value : values) {
        if (!(value > 0.0) || !std::isfinite(value)) {
            throw Error("a power law has positive values only");
        }
        logs.push_back(std::log(value));
    }
    return logs;
}

double meanOf(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

}  // namespace

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

PowerLaw fitPowerLaw(std::span<const double> x, std::span<const double> y) {
    const std::vector<double> logX = logarithms(x);
    const std::vector<double> logY = logarithms(y);
    if (logX.size() != logY.size()) {
        throw Error("a power law needs a y for each x");
    }
    const double meanX = meanOf(logX);
    const double meanY = meanOf(logY);
    double squares = 0.0;
    double products = 0.0;
    for (std::size_t i = 0; i < logX.size(); ++i) {
        squares += (logX[i] - meanX) * (logX[i] - meanX);
        products += (logX[i] - meanX) * (logY[i] - meanY);
    }
    if (!(squares > 0.0)) {
        throw Error("a power law needs two different x");
    }
    const double exponent = products / squares;
    return {.factor = std::exp(meanY - exponent * meanX), .exponent = exponent};
}

}  // namespace asperity
