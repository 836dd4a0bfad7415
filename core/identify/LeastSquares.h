#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>

namespace asperity {

/// Computes the residuals at some parameters; the second argument has their count.
using ResidualFunction = std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&)>;
/// Computes their derivatives: a row a residual, a column a parameter.
using JacobianFunction = std::function<void(const Eigen::VectorXd&, Eigen::MatrixXd&)>;

/// The result of a nonlinear least-squares fit.
struct FitResult {
    Eigen::VectorXd parameters;
    /// Inverse of J^T J times the variance of the residuals times their autocorrelation factor: an
    /// undetermined parameter has a huge or infinite variance.
    Eigen::MatrixXd covariance;
    double rms = 0.0;     ///< root mean square of the residuals
    int evaluations = 0;  ///< of the residuals and of the Jacobian
    bool converged = false;

    /// Standard deviation of a parameter.
    [[nodiscard]] double std(Eigen::Index parameter) const;
    /// Correlation of two parameters, -1 .. 1.
    [[nodiscard]] double correlation(Eigen::Index first, Eigen::Index second) const;
};

/// Finds the parameters with the smallest sum of squared residuals, by Levenberg and Marquardt's
/// method. Residuals that are not finite refuse the step that led to them.
/// @param scale of each parameter, > 0: a change of this size matters
/// @param count of the residuals; they are in the order of time where their correlation matters
/// @param jacobian empty: by forward differences
[[nodiscard]] FitResult leastSquares(const ResidualFunction& residuals,
                                     const Eigen::VectorXd& start, const Eigen::VectorXd& scale,
                                     std::size_t count, const JacobianFunction& jacobian = {});

/// Returns 1 + 2 sum rho_j over the lags before the first autocorrelation rho_j <= 0, at least 1:
/// by this factor errors that are alike over several samples enlarge the variance of what is fitted
/// to them.
[[nodiscard]] double autocorrelationFactor(const Eigen::VectorXd& residuals);

}  // namespace asperity
