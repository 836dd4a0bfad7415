#include "core/surface/LeastSquares.h"

#include <Eigen/QR>

namespace asperity {

Eigen::VectorXd leastSquares(const Eigen::MatrixXd& design, const Eigen::VectorXd& right) {
    return design.completeOrthogonalDecomposition().solve(right);
}

}  // namespace asperity
