#pragma once

#include "core/scene/Scene.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/Curvature.h"
#include "core/surface/fit/GaussianFilter.h"

#include <Eigen/Core>

namespace asperity {

/// Slopes and second derivatives of a surface at one position: dx, dy, dxx, dxy, dyy.
using Relief = Eigen::Matrix<double, 5, 1>;

[[nodiscard]] inline Relief reliefOf(const HeightSample& sample) noexcept {
    return {sample.dx, sample.dy, sample.dxx, sample.dxy, sample.dyy};
}

/// A sample with these derivatives, at height 0.
[[nodiscard]] inline HeightSample sampleOf(const Relief& relief) noexcept {
    return {.dx = relief[0], .dy = relief[1], .dxx = relief[2], .dxy = relief[3], .dyy = relief[4]};
}

/// A scan as its imaging tip recorded it, after the low-pass. What a tip records is the parallel
/// surface at its radius, seen from above. Source: docs/uncertainty.md 1.5.
class RecordedScan {
public:
    /// @param surface of the scan @param erodedBy radius of the tip that was taken out of it [m]
    explicit RecordedScan(const BSplineSurface& surface, double erodedBy = 0.0)
        : surface_(surface), erodedBy_(erodedBy) {}
    explicit RecordedScan(const Scene& scene);

    [[nodiscard]] const BSplineSurface::Grid& grid() const noexcept { return surface_.grid(); }
    /// Returns the relief; that of the surface under it where this folds. @param x, y world [m]
    [[nodiscard]] Relief reliefAt(double x, double y) const noexcept;

private:
    BSplineSurface surface_;
    double erodedBy_;
};

/// Positions of a contact on the recorded scan, world x, y [m].
struct RecordedPositions {
    Vector2 shown;    ///< that of the scene
    Vector2 touched;  ///< that of the same tip on the surface without its imaging tip
};

/// Returns the positions of a state. A tip on that surface touches where one whose radius is less
/// by the imaging tip's touches the recorded one: of an eroded scan both are the same.
[[nodiscard]] RecordedPositions recordedPositions(const Scene& scene,
                                                  const TipState& state) noexcept;

using ReliefCovariance = Eigen::Matrix<double, 5, 5>;

/// Variances of a blur along both axes [m^2].
struct BlurWidth {
    double x = 0.0;
    double y = 0.0;
};

/// Response of the fit of a scan to the heights around one position. Smoothing and spline are
/// linear in the heights, and each derivative has a weight for each height: the product of a weight
/// along x and one along y, those of lineFitWeights().
class FitResponse {
public:
    /// @param smoothing of the scan
    /// @param x, y world [m]
    FitResponse(const RecordedScan& scan, const Smoothing& smoothing, double x, double y);

    /// Covariance of the derivatives by white noise of the heights with a standard deviation of 1
    /// m.
    [[nodiscard]] ReliefCovariance noise() const noexcept;

    /// Returns the correction of the derivatives that takes out a blur, to first order: minus half
    /// its variance times the second derivative along each axis, by differences over the width of
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
