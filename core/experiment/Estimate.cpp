#include "core/experiment/Estimate.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace asperity {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kUpperTail = 0.025;  // of an interval of 95 %

double meanOf(std::span<const double> values) {
    return values.empty() ? kNone
                          : std::accumulate(values.begin(), values.end(), 0.0) /
                                static_cast<double>(values.size());
}

/// Sums of squares and products about the means.
struct Moments {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
};

Moments momentsOf(std::span<const double> x, std::span<const double> y) {
    const double meanX = meanOf(x);
    const double meanY = meanOf(y);
    Moments moments;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - meanX;
        const double dy = y[i] - meanY;
        moments.xx += dx * dx;
        moments.xy += dx * dy;
        moments.yy += dy * dy;
    }
    return moments;
}

}  // namespace

Estimate estimateOf(std::span<const double> values) {
    Estimate estimate{.count = values.size(),
                      .mean = meanOf(values),
                      .deviation = kNone,
                      .low = kNone,
                      .high = kNone};
    if (values.size() < 2) {
        return estimate;
    }
    const auto count = static_cast<double>(values.size());
    estimate.deviation = std::sqrt(momentsOf(values, values).xx / (count - 1.0));
    const boost::math::students_t spread(count - 1.0);
    const double half = boost::math::quantile(boost::math::complement(spread, kUpperTail)) *
                        estimate.deviation / std::sqrt(count);
    estimate.low = estimate.mean - half;
    estimate.high = estimate.mean + half;
    return estimate;
}

Estimate correlationOf(std::span<const double> x, std::span<const double> y) {
    const Moments moments = momentsOf(x, y);
    Estimate estimate{.count = x.size(),
                      .mean = moments.xy / std::sqrt(moments.xx * moments.yy),
                      .deviation = kNone,
                      .low = kNone,
                      .high = kNone};
    if (x.size() < 4 || !(moments.xx > 0.0 && moments.yy > 0.0)) {
        estimate.mean = moments.xx > 0.0 && moments.yy > 0.0 ? estimate.mean : kNone;
        return estimate;
    }
    const double half =
        boost::math::quantile(boost::math::complement(boost::math::normal(), kUpperTail)) /
        std::sqrt(static_cast<double>(x.size()) - 3.0);
    const double middle = std::atanh(estimate.mean);
    estimate.low = std::tanh(middle - half);
    estimate.high = std::tanh(middle + half);
    return estimate;
}

double slopeOf(std::span<const double> x, std::span<const double> y) {
    const Moments moments = momentsOf(x, y);
    return moments.xx > 0.0 ? moments.xy / moments.xx : kNone;
}

}  // namespace asperity
