#include "core/uncertainty/FitResponse.h"

#include "core/surface/fit/LineFit.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace asperity {

namespace {

Vector2 across(const HeightSample& sample) noexcept { return sample.normal().head<2>(); }

/// Derivative of the position over which the point lies that is `length` along the normal.
Eigen::Matrix2d spreadOf(const HeightSample& sample, double length) noexcept {
    const Vector2 slope(sample.dx, sample.dy);
    Eigen::Matrix2d bend;
    bend << sample.dxx, sample.dxy, sample.dxy, sample.dyy;
    const double square = 1.0 + slope.squaredNorm();
    const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
    return identity -
           (length / std::sqrt(square)) * (identity - (slope * slope.transpose() / square)) * bend;
}

/// The position whose point that far along the normal lies over a target, by Newton's method from
/// the target on; none: the surface folds on the way.
std::optional<Vector2> positionUnder(const BSplineSurface& surface, const Vector2& target,
                                     double length) noexcept {
    constexpr int kIterations = 30;
    constexpr double kClose = 1e-6;  // of a pixel
    Vector2 position = target;
    for (int i = 0; i < kIterations; ++i) {
        const HeightSample sample = surface.at(position.x(), position.y());
        const Vector2 missing = target - position - (length * across(sample));
        if (missing.norm() < kClose * surface.finestPitch()) {
            return position;
        }
        const Eigen::Matrix2d spread = spreadOf(sample, length);
        if (!(spread.determinant() > 0.0)) {
            return std::nullopt;
        }
        position += spread.inverse() * missing;
    }
    return std::nullopt;
}

/// Order of the derivative along x and along y of each entry of a Relief.
struct Orders {
    int x;
    int y;
};
constexpr std::array<Orders, 5> kOrders{{{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// A derivative as a sum of products of weights: factor, and which weights along x and y.
struct Term {
    double factor;
    int x;
    int y;
};

/// Weights of a line's samples for value, slope and second derivative.
using LineWeights = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// One axis of a scan.
struct ScanAxis {
    int samples = 0;
    double pitch = 0.0;      ///< [m]
    double smoothing = 0.0;  ///< [pixel]
    double position = 0.0;   ///< [m]

    [[nodiscard]] double size() const { return samples * pitch; }
    /// Over which a blur is seen: its own width and a pixel's [m].
    [[nodiscard]] double step() const { return pitch * std::hypot(smoothing, 1.0); }
    /// The position, or the nearest one that has a step on either side.
    [[nodiscard]] double middle() const {
        return step() < size() / 2.0 ? std::clamp(position, step(), size() - step()) : size() / 2.0;
    }
};

/// Basis of the cubic spline and its derivatives in a span, by pixel. @param t 0 .. 1
Eigen::Matrix<double, 4, 3> splineBasis(double t) {
    const double s = 1.0 - t;
    Eigen::Matrix<double, 4, 3> basis;
    basis.col(0) << s * s * s / 6.0, (4.0 - (6.0 * t * t) + (3.0 * t * t * t)) / 6.0,
        (4.0 - (6.0 * s * s) + (3.0 * s * s * s)) / 6.0, t * t * t / 6.0;
    basis.col(1) << -s * s / 2.0, ((3.0 * t) - 4.0) * t / 2.0, (4.0 - (3.0 * s)) * s / 2.0,
        t * t / 2.0;
    basis.col(2) << s, (3.0 * t) - 2.0, (3.0 * s) - 2.0, t;
    return basis;
}

/// The samples around a position that shape it: a line as long as the whole one, or so long that
/// its far end does not matter.
class LineWindow {
public:
    explicit LineWindow(const ScanAxis& axis)
        : axis_(axis), samples_(std::min(axis.samples, enoughFor(axis.smoothing))) {
        const double center = (axis.position / axis.pitch) - 0.5 - (samples_ / 2.0);
        first_ = std::clamp(static_cast<int>(std::lround(center)), 0, axis.samples - samples_);
        weights_ = lineFitWeights(samples_, axis.smoothing);
    }

    [[nodiscard]] LineWeights at(double position) const {
        LineWeights line = LineWeights::Zero(samples_, 3);
        if (axis_.samples == 1) {  // level along this axis
            line(0, 0) = 1.0;
            return line;
        }
        const double u = (std::clamp(position, 0.0, axis_.size()) / axis_.pitch) - 0.5 - first_;
        const int span = std::clamp(static_cast<int>(std::floor(u)), 0, samples_ - 2);
        const Eigen::Matrix<double, 4, 3> basis = splineBasis(u - span);
        const Eigen::Vector3d units(1.0, 1.0 / axis_.pitch, 1.0 / (axis_.pitch * axis_.pitch));
        for (int i = 0; i < 4; ++i) {
            const std::size_t row = static_cast<std::size_t>(span + i);
            const Eigen::Map<const Eigen::VectorXd> control(
                weights_.data() + (row * static_cast<std::size_t>(samples_)), samples_);
            line += control * basis.row(i).cwiseProduct(units.transpose());
        }
        return line;
    }

private:
    /// Four times what an end, the kernel and the spline's decay take, see BasicLineFit.
    static int enoughFor(double smoothing) {
        constexpr int kSplineDecay = 30;
        return (4 * (static_cast<int>(halfGaussian(smoothing).size()) + kSplineDecay)) + 1;
    }

    ScanAxis axis_;
    int samples_;
    int first_ = 0;
    std::vector<double> weights_;
};

Eigen::Matrix<double, 6, 6> productsOf(const ScanAxis& axis) {
    const LineWindow window(axis);
    const double step = axis.step();
    const double middle = axis.middle();
    Eigen::Matrix<double, Eigen::Dynamic, 6> all(window.at(axis.position).rows(), 6);
    all.leftCols<3>() = window.at(axis.position);
    all.rightCols<3>() =
        (window.at(middle + step) + window.at(middle - step) - (2.0 * window.at(middle))) /
        (step * step);
    return all.transpose() * all;
}

ReliefCovariance covariance(const Eigen::Matrix<double, 6, 6>& alongX,
                            const Eigen::Matrix<double, 6, 6>& alongY, const auto& termsOf) {
    ReliefCovariance sum = ReliefCovariance::Zero();
    for (std::size_t i = 0; i < kOrders.size(); ++i) {
        for (std::size_t j = 0; j < kOrders.size(); ++j) {
            for (const Term& a : termsOf(kOrders[i])) {
                for (const Term& b : termsOf(kOrders[j])) {
                    sum(static_cast<int>(i), static_cast<int>(j)) +=
                        a.factor * b.factor * alongX(a.x, b.x) * alongY(a.y, b.y);
                }
            }
        }
    }
    return sum;
}

constexpr int kDifference = 3;  // first column of the differences in the products

}  // namespace

RecordedScan::RecordedScan(const Scene& scene)
    : RecordedScan(scene.surface, scene.description.sample.erode
                                      ? scene.description.sample.imagingTipRadius
                                      : 0.0) {}

Relief RecordedScan::reliefAt(double x, double y) const noexcept {
    const std::optional<Vector2> under = positionUnder(surface_, Vector2(x, y), erodedBy_);
    if (!under) {
        return reliefOf(surface_.at(x, y));
    }
    HeightSample sample = surface_.at(under->x(), under->y());
    Eigen::Matrix2d bend;
    bend << sample.dxx, sample.dxy, sample.dxy, sample.dyy;
    bend *= spreadOf(sample, erodedBy_).inverse();
    return {sample.dx, sample.dy, bend(0, 0), 0.5 * (bend(0, 1) + bend(1, 0)), bend(1, 1)};
}

RecordedPositions recordedPositions(const Scene& scene, const TipState& state) noexcept {
    const SampleDescription& sample = scene.description.sample;
    const Vector2 point = state.closest.point.head<2>();
    const Vector2 normal = state.closest.normal.head<2>();
    if (sample.erode) {
        const Vector2 recorded = point + (sample.imagingTipRadius * normal);
        return {recorded, recorded};
    }
    if (sample.imagingTipRadius == 0.0) {
        return {point, point};
    }
    const double tip = scene.belief.tipRadius();
    const std::optional<Vector2> touched =
        positionUnder(scene.surface, point + (tip * normal), tip - sample.imagingTipRadius);
    return {point, touched.value_or(point)};
}

FitResponse::FitResponse(const RecordedScan& scan, const Smoothing& smoothing, double x, double y) {
    const BSplineSurface::Grid& grid = scan.grid();
    const ScanAxis axisX{grid.columns, grid.pitchX, smoothing.x, x};
    const ScanAxis axisY{grid.rows, grid.pitchY, smoothing.y, y};
    alongX_ = productsOf(axisX);
    alongY_ = productsOf(axisY);
    const auto at = [&scan](double u, double v) { return scan.reliefAt(u, v); };
    const double stepX = axisX.step();
    const double stepY = axisY.step();
    const double middleX = axisX.middle();
    const double middleY = axisY.middle();
    differenceX_ = (at(middleX + stepX, y) + at(middleX - stepX, y) - (2.0 * at(middleX, y))) /
                   (stepX * stepX);
    differenceY_ = (at(x, middleY + stepY) + at(x, middleY - stepY) - (2.0 * at(x, middleY))) /
                   (stepY * stepY);
}

ReliefCovariance FitResponse::noise() const noexcept {
    return covariance(alongX_, alongY_, [](const Orders& orders) {
        return std::array<Term, 1>{{{1.0, orders.x, orders.y}}};
    });
}

Relief FitResponse::sharpening(const BlurWidth& blur) const noexcept {
    return -0.5 * ((blur.x * differenceX_) + (blur.y * differenceY_));
}

ReliefCovariance FitResponse::sharpeningNoise(const BlurWidth& blur) const noexcept {
    return covariance(alongX_, alongY_, [&blur](const Orders& orders) {
        return std::array<Term, 2>{{{-0.5 * blur.x, orders.x + kDifference, orders.y},
                                    {-0.5 * blur.y, orders.x, orders.y + kDifference}}};
    });
}

}  // namespace asperity
