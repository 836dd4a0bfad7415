#pragma once

#include "core/Vector.h"

namespace asperity {

/// The least-squares solution x of A x = b, three unknowns, and what tells its covariance.
struct LeastSquares3 {
    Vector3 solution = Vector3::Zero();
    /// Upper triangular; (A^T A)^-1 = inverseRoot inverseRoot^T.
    Matrix3 inverseRoot = Matrix3::Zero();
};

/// By modified Gram-Schmidt on A and b together, which is as stable as Householder's
/// transformations and, at this size, three times as fast as a general one. Columns keep their
/// lengths, so that no root is waited for. A has full rank.
/// Source: Bjorck (1967), Solving linear least squares problems by Gram-Schmidt orthogonalization.
template <int Rows>
[[nodiscard]] LeastSquares3 leastSquares(Eigen::Matrix<double, Rows, 3> a,
                                         Eigen::Matrix<double, Rows, 1> b) noexcept {
    Matrix3 unit = Matrix3::Identity();  // A = Q unit, Q the columns that become orthogonal
    Vector3 inverseSquare;
    Vector3 rest;
    for (int k = 0; k < 3; ++k) {
        inverseSquare[k] = 1.0 / a.col(k).squaredNorm();
        for (int j = k + 1; j < 3; ++j) {
            unit(k, j) = a.col(k).dot(a.col(j)) * inverseSquare[k];
            a.col(j) -= unit(k, j) * a.col(k);
        }
        rest[k] = a.col(k).dot(b) * inverseSquare[k];
        b -= rest[k] * a.col(k);
    }
    Matrix3 inverse = Matrix3::Identity();  // of unit
    inverse(0, 1) = -unit(0, 1);
    inverse(1, 2) = -unit(1, 2);
    inverse(0, 2) = (unit(0, 1) * unit(1, 2)) - unit(0, 2);
    LeastSquares3 result;
    Vector3& x = result.solution;
    x[2] = rest[2];
    x[1] = rest[1] - (unit(1, 2) * x[2]);
    x[0] = rest[0] - (unit(0, 1) * x[1]) - (unit(0, 2) * x[2]);
    result.inverseRoot = inverse * inverseSquare.cwiseSqrt().asDiagonal();
    return result;
}

}  // namespace asperity
