#pragma once

#include "core/surface/fit/GaussianFilter.h"
#include "core/uncertainty/RecordedScan.h"

#include <Eigen/Core>

namespace asperity {

using ReliefCovariance = Eigen::Matrix<double, 5, 5>;

/// Variances of a blur along both axes [m^2].
struct BlurWidth {
    double x = 0.0;
    double y = 0.0;
};

/// How the fit of a scan answers to the heights around one place. Smoothing and spline are linear
/// in the heights, and each derivative has a weight for each height: the product of a weight along
/// x and one along y, those of lineFitWeights().
class FitResponse {
public:
    /// @param smoothing of the scan
    /// @param x, y world [m]
    FitResponse(const RecordedScan& scan, const Smoothing& smoothing, double x, double y);

    /// Covariance of the derivatives by white noise of the heights with a standard deviation of 1
    /// m.
    [[nodiscard]] ReliefCovariance noise() const noexcept;

    /// What is to be added to the derivatives to take out a blur, to first order: minus half its
    /// variance times the second derivative along each axis, by differences over the width of
    /// smoothing and pixel. Source: docs/uncertainty.md; heat equation.
    [[nodiscard]] Relief sharpening(const BlurWidth& blur) const noexcept;
    /// Covariance of that by white noise of the heights, as noise().
    [[nodiscard]] ReliefCovariance sharpeningNoise(const BlurWidth& blur) const noexcept;

private:
    /// Scalar products of the weights of value, slope and second derivative along an axis, and of
    /// the differences of each.
    using Products = Eigen::Matrix<double, 6, 6>;

    Products alongX_;
    Products alongY_;
    Relief differenceX_;  ///< second difference along x, per square of the step [1/m^2]
    Relief differenceY_;
};

}  // namespace asperity
