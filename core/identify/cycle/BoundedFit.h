#pragma once

#include "core/identify/IdentifiedValue.h"
#include "core/identify/LeastSquares.h"

#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// A parameter that a fit may change.
struct FreeParameter {
    std::string key;   ///< in fit.json
    std::string unit;  ///< empty: none
    double start = 0.0;
    double low = 0.0;
    double high = 0.0;
    /// A change of this size matters; 0: the parameter is > 0 and the fit changes its logarithm.
    double scale = 0.0;
};

/// Two parameters whose estimates are correlated by more than 0.95.
struct CorrelatedPair {
    std::string first;
    std::string second;
    double correlation = 0.0;
};

/// A fit whose parameters stay within bounds.
struct BoundedFit {
    FitResult fit;  ///< of the steps from the starts, of the logarithm where there is no scale
    std::vector<FreeParameter> parameters;
    std::vector<double> values;

    /// Standard deviation of a value, in its unit.
    [[nodiscard]] double std(std::size_t parameter) const;
    [[nodiscard]] std::vector<IdentifiedValue> identified() const;
    /// Returns whether a parameter is not at a bound and is larger than its deviation.
    [[nodiscard]] bool isIdentified(std::size_t parameter) const;
    /// Keys of the others.
    [[nodiscard]] std::vector<std::string> notIdentified() const;
    /// Pairs of identified parameters that the curve cannot tell apart.
    [[nodiscard]] std::vector<CorrelatedPair> correlated() const;
};

/// Computes residuals from the values of the parameters.
using BoundedResiduals = std::function<void(const std::vector<double>&, Eigen::VectorXd&)>;

/// Least squares within the bounds: beyond one the residuals are those at it.
[[nodiscard]] BoundedFit fitWithin(const std::vector<FreeParameter>& parameters,
                                   const BoundedResiduals& residuals, std::size_t count);

}  // namespace asperity
