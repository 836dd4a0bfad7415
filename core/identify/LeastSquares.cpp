#include "core/identify/LeastSquares.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace asperity {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The fit in the parameters (p - start) / scale, as Eigen's solver asks for it.
class ScaledProblem : public Eigen::DenseFunctor<double> {
public:
    ScaledProblem(const ResidualFunction& residuals, const JacobianFunction& jacobian,
                  const VectorXd& start, const VectorXd& scale, Index count)
        : DenseFunctor(static_cast<int>(start.size()), static_cast<int>(count))
        , residuals_(residuals)
        , jacobian_(jacobian)
        , start_(start)
        , scale_(scale)
        , base_(count) {}

    [[nodiscard]] VectorXd parameters(const VectorXd& scaled) const {
        return start_ + scaled.cwiseProduct(scale_);
    }

    int operator()(const VectorXd& scaled, VectorXd& result) const {
        residuals_(parameters(scaled), result);
        return 0;
    }

    int df(const VectorXd& scaled, MatrixXd& result) const {
        if (jacobian_) {
            jacobian_(parameters(scaled), result);
            result *= scale_.asDiagonal();
        } else {
            differences(scaled, result);
        }
        return 0;
    }

private:
    void differences(const VectorXd& scaled, MatrixXd& result) const {
        const double relative = std::sqrt(std::numeric_limits<double>::epsilon());
        (*this)(scaled, base_);
        VectorXd moved = scaled;
        VectorXd column(base_.size());
        for (Index i = 0; i < scaled.size(); ++i) {
            const double size = std::abs(start_[i]) / scale_[i] + std::abs(scaled[i]);
            const double step = relative * std::max(1.0, size);
            moved[i] = scaled[i] + step;
            (*this)(moved, column);
            result.col(i) = (column - base_) / (moved[i] - scaled[i]);
            moved[i] = scaled[i];
        }
    }

    const ResidualFunction& residuals_;
    const JacobianFunction& jacobian_;
    const VectorXd& start_;
    const VectorXd& scale_;
    mutable VectorXd base_;  ///< residuals from which the differences are taken
};

/// The inverse of J^T J. Directions that the residuals do not determine get the largest variance
/// that double precision can tell, columns of zeros an infinite one.
MatrixXd inverseNormal(const MatrixXd& jacobian) {
    const MatrixXd normal = jacobian.transpose() * jacobian;
    const VectorXd norms = normal.diagonal().cwiseSqrt();
    const VectorXd inverse = norms.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(inverse.asDiagonal() * normal *
                                                         inverse.asDiagonal());
    const double floor = static_cast<double>(norms.size()) * std::numeric_limits<double>::epsilon();
    const VectorXd values = solver.eigenvalues().cwiseMax(floor).cwiseInverse();
    MatrixXd result =
        solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
    result = inverse.asDiagonal() * result * inverse.asDiagonal();
    for (Index i = 0; i < norms.size(); ++i) {
        if (!(norms[i] > 0.0)) {
            result(i, i) = std::numeric_limits<double>::infinity();
        }
    }
    return result;
}

}  // namespace

double FitResult::std(Eigen::Index parameter) const {
    return std::sqrt(covariance(parameter, parameter));
}

double FitResult::correlation(Eigen::Index first, Eigen::Index second) const {
    return covariance(first, second) / (std(first) * std(second));
}

FitResult leastSquares(const ResidualFunction& residuals, const VectorXd& start,
                       const VectorXd& scale, std::size_t count, const JacobianFunction& jacobian) {
    ScaledProblem problem(residuals, jacobian, start, scale, static_cast<Index>(count));
    Eigen::LevenbergMarquardt<ScaledProblem> solver(problem);
    constexpr double kTolerance = 1e-10;  // of the sum of squares and of the parameters
    solver.setFtol(kTolerance);
    solver.setXtol(kTolerance);
    VectorXd scaled = VectorXd::Zero(start.size());
    const auto status = solver.minimize(scaled);

    FitResult result;
    result.parameters = problem.parameters(scaled);
    result.evaluations = static_cast<int>(solver.nfev() + solver.njev());
    VectorXd rest(static_cast<Index>(count));
    MatrixXd derivatives(rest.size(), start.size());
    problem(scaled, rest);
    problem.df(scaled, derivatives);
    const double squares = rest.squaredNorm();
    result.rms = std::sqrt(squares / static_cast<double>(count));
    result.converged = status > 0 &&
                       status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation &&
                       std::isfinite(squares);
    const double freedom = std::max(1.0, static_cast<double>(rest.size() - start.size()));
    const double variance = squares / freedom * autocorrelationFactor(rest);
    result.covariance =
        scale.asDiagonal() * inverseNormal(derivatives) * scale.asDiagonal() * variance;
    return result;
}

double autocorrelationFactor(const Eigen::VectorXd& residuals) {
    const Index count = residuals.size();
    const double square = residuals.squaredNorm();
    double factor = 1.0;
    for (Index lag = 1; lag < count; ++lag) {
        const double rho = residuals.head(count - lag).dot(residuals.tail(count - lag)) / square;
        if (!(rho > 0.0)) {
            break;
        }
        factor += 2.0 * rho;
    }
    return factor;
}

}  // namespace asperity
