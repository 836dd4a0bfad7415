#pragma once

#include <Eigen/Core>

namespace asperity {

/// Returns the x for which |design x - right| is smallest; of several, the shortest.
/// In a source of its own: Eigen's decomposition takes the compiler six seconds per source.
[[nodiscard]] Eigen::VectorXd leastSquares(const Eigen::MatrixXd& design,
                                           const Eigen::VectorXd& right);

}  // namespace asperity
