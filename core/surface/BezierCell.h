#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace asperity {

/// The four control points that shape one position of a uniform cubic B-spline, and how much each
/// counts.
struct CubicSpan {
    int first = 0;              ///< index of the first of the four control points
    Eigen::Vector4d value;      ///< weights of the value
    Eigen::Vector4d slope;      ///< of the first derivative, per span
    Eigen::Vector4d curvature;  ///< of the second derivative, per span squared
};

/// @param position in spans from the start of span 0; outside [0, spans] the outer continues
inline CubicSpan cubicSpan(double position, int spans) {
    CubicSpan span;
    // The conversion rounds up only below 0, where span 0 is continued anyway.
    span.first = std::clamp(static_cast<int>(position), 0, spans - 1);
    const double t = position - span.first;
    const double s = 1.0 - t;
    constexpr double kSixth = 1.0 / 6.0;
    span.value << s * s * s * kSixth, (4.0 + t * t * (3.0 * t - 6.0)) * kSixth,
        (4.0 + s * s * (3.0 * s - 6.0)) * kSixth, t * t * t * kSixth;
    span.slope << -0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t;
    span.curvature << s, 3.0 * t - 2.0, 3.0 * s - 2.0, t;
    return span;
}

/// Part of a span, in spans from its start; may reach beyond it where the span is continued.
struct SpanPart {
    double low = 0.0;
    double high = 1.0;

    [[nodiscard]] double length() const { return high - low; }
    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

/// The part of its span that cell `cell` of an axis covers: the outermost reach to the scan's edge.
inline SpanPart cellExtent(int cell, int pixels) {
    if (pixels == 1) {
        return {.low = -0.5, .high = 0.5};
    }
    return {.low = cell == 0 ? -0.5 : 0.0, .high = cell == pixels - 2 ? 1.5 : 1.0};
}

/// Takes four B-spline control values to the four Bezier points of the same cubic on a part of its
/// span: one row a point.
inline Eigen::Matrix4d bezierOfSpan(const SpanPart& part) {
    const CubicSpan low = cubicSpan(part.low, 1);
    const CubicSpan high = cubicSpan(part.high, 1);
    const double third = part.length() / 3.0;
    Eigen::Matrix4d rows;
    rows.row(0) = low.value.transpose();
    rows.row(1) = (low.value + third * low.slope).transpose();
    rows.row(2) = (high.value - third * high.slope).transpose();
    rows.row(3) = high.value.transpose();
    return rows;
}

struct Range {
    double low = 0.0;
    double high = 0.0;

    [[nodiscard]] double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

/// Bounds of the second derivatives of a height in a part of a cell [1/m].
struct BendRange {
    Range xx;
    Range xy;
    Range yy;
};

/// Size of a box along x and y [m].
struct BoxSize {
    double x = 0.0;
    double y = 0.0;
};

/// Bounds from the Bezier points of a height over a box of that size: a polynomial lies within the
/// hull of its Bezier points, and so do its derivatives within that of theirs.
/// @param net heights [m], rows along y, columns along x
inline BendRange bendsOf(const Eigen::Matrix4d& net, const BoxSize& size) {
    const auto rangeOf = [](const auto& differences, double scale) {
        return Range{scale * differences.minCoeff(), scale * differences.maxCoeff()};
    };
    const Eigen::Matrix<double, 4, 3> alongX = net.rightCols<3>() - net.leftCols<3>();
    const Eigen::Matrix<double, 3, 4> alongY = net.bottomRows<3>() - net.topRows<3>();
    return {.xx = rangeOf((alongX.rightCols<2>() - alongX.leftCols<2>()).eval(),
                          6.0 / (size.x * size.x)),
            .xy = rangeOf((alongX.bottomRows<3>() - alongX.topRows<3>()).eval(),
                          9.0 / (size.x * size.y)),
            .yy = rangeOf((alongY.bottomRows<2>() - alongY.topRows<2>()).eval(),
                          6.0 / (size.y * size.y))};
}

/// No second derivative in any direction is larger [1/m].
inline double largestBend(const BendRange& bends) {
    const double mixed = bends.xy.magnitude();
    return 0.5 * (bends.xx.high + bends.yy.high) +
           std::hypot(0.5 * (bends.xx.high - bends.yy.high), mixed);
}

}  // namespace asperity
