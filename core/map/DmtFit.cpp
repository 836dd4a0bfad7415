#include "core/map/DmtFit.h"

#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Slope of a least-squares line, of differences from the first point.
class LineFit {
public:
    void add(double x, double y) noexcept {
        if (count_ == 0) {
            x0_ = x;
            y0_ = y;
        }
        ++count_;
        x -= x0_;
        y -= y0_;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] double slope() const noexcept {
        return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_);
    }

private:
    int count_ = 0;
    double x0_ = 0.0;
    double y0_ = 0.0;
    double x_ = 0.0;
    double y_ = 0.0;
    double xx_ = 0.0;
    double xy_ = 0.0;
};

}  // namespace

double dmtModulus(std::span<const RetractPoint> unloading, double adhesion,
                  double tipRadius) noexcept {
    constexpr double kLow = 0.3;
    constexpr double kHigh = 0.9;
    constexpr int kMinPoints = 3;
    const double range = unloading.empty() ? 0.0 : unloading.front().force + adhesion;
    LineFit line;
    for (const RetractPoint& point : unloading) {
        const double load = point.force + adhesion;
        if (load >= kLow * range && load <= kHigh * range) {
            line.add(point.height, std::cbrt(load * load));
        }
    }
    const double slope = line.count() < kMinPoints ? 0.0 : -line.slope();
    return slope > 0.0 ? 0.75 * slope * std::sqrt(slope / tipRadius)
                       : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace asperity
