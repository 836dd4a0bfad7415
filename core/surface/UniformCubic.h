#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace asperity {

/// The four control points that shape one place of a uniform cubic B-spline, and how much each
/// counts.
struct CubicSpan {
    int first = 0;              ///< index of the first of the four control points
    Eigen::Vector4d value;      ///< weights of the value
    Eigen::Vector4d slope;      ///< of the first derivative, per span
    Eigen::Vector4d curvature;  ///< of the second derivative, per span squared
};

/// @param place in spans from the start of span 0; outside [0, spans] the outer span is continued
inline CubicSpan cubicSpan(double place, int spans) {
    CubicSpan span;
    // The conversion rounds up only below 0, where span 0 is continued anyway.
    span.first = std::clamp(static_cast<int>(place), 0, spans - 1);
    const double t = place - span.first;
    const double s = 1.0 - t;
    constexpr double kSixth = 1.0 / 6.0;
    span.value << s * s * s * kSixth, (4.0 + t * t * (3.0 * t - 6.0)) * kSixth,
        (4.0 + s * s * (3.0 * s - 6.0)) * kSixth, t * t * t * kSixth;
    span.slope << -0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t;
    span.curvature << s, 3.0 * t - 2.0, 3.0 * s - 2.0, t;
    return span;
}

}  // namespace asperity
