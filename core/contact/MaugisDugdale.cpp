#include "core/contact/MaugisDugdale.h"

#include "core/contact/RootSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A coordinate where the contact radius is of the order of one, for any lambda.
double scaleOf(double lambda) noexcept { return std::sqrt(lambda) + lambda; }

/// A quantity that rises along the curve, and its derivative by the coordinate.
struct Rise {
    double value;
    double rate;
    double rounding;  ///< what rounding may leave in the value
};

/// d coordinate / d phi = -1 / sin^2, and the rates of a point are by -phi over cos(phi).
double ratePerCoordinate(const MaugisPoint& point) noexcept {
    const double sine = std::sin(point.angle);
    return point.contactRadius / point.cohesiveRadius * sine * sine;
}

/// Indentation and force are each a power of the contact radius less the pull of the cohesion.
Rise heldRise(const MaugisControl& control, const MaugisPoint& point) noexcept {
    const double square = point.contactRadius * point.contactRadius;
    const double cube = square * point.contactRadius;
    const double size = (control.perIndentation * (square + std::abs(square - point.indentation))) +
                        (control.perForce * (cube + std::abs(cube - point.force)));
    return {control.held(point), control.heldRate(point) * ratePerCoordinate(point),
            2.0 * kEpsilon * size};
}

/// Search for the coordinate where a rising quantity takes the value `target`. It grows from
/// `origin` (coordinate and value) roughly as a power of the distance, so Newton's method runs on
/// the logarithms of both; a bracket guards it.
class PowerLawSearch {
public:
    PowerLawSearch(double origin, double originValue, double target) noexcept
        : origin_(origin), originValue_(originValue), target_(target), low_(origin) {}

    /// The next coordinate to try after `here`, where the quantity is `rise`.
    [[nodiscard]] double next(double here, const Rise& rise) noexcept {
        const double miss = rise.value - target_;
        (miss < 0.0 ? low_ : high_) = here;
        const double trial = std::abs(miss) < 1e-3 * (target_ - originValue_)
                                 ? here - (miss / rise.rate)
                                 : powerStep(here, rise);
        return trial > low_ && trial < high_ ? trial : middle();
    }

private:
    [[nodiscard]] double powerStep(double here, const Rise& rise) const noexcept {
        const double climbed = rise.value - originValue_;
        if (!(climbed > 0.0)) {
            return low_;
        }
        constexpr double kLargestRatio = 1e12;
        const double offset = here - origin_;
        const double ratio = (target_ - originValue_) / climbed;
        const double exponent = std::clamp(offset * rise.rate / climbed, 1.0, 8.0);
        return origin_ + (offset * std::pow(std::min(ratio, kLargestRatio), 1.0 / exponent));
    }

    [[nodiscard]] double middle() const noexcept {
        return high_ == kInfinity ? origin_ + (2.0 * (low_ - origin_)) : 0.5 * (low_ + high_);
    }

    double origin_;
    double originValue_;
    double target_;
    double low_;
    double high_ = kInfinity;
};

}  // namespace

MaugisDugdale::MaugisDugdale(double lambda) noexcept
    : curve_(lambda), touch_(curve_.noncontact(curve_.touchRadius())) {
    const auto forceRate = [this](double x) { return curve_.contact(x).forceRate; };
    double beyond = scaleOf(lambda);
    while (forceRate(beyond) <= 0.0) {
        beyond *= 2.0;
    }
    loadFold_ = curve_.contact(rootBetween(forceRate, 0.0, beyond));
    if (touch_.indentationRate < 0.0) {
        const auto indentationRate = [this](double x) { return curve_.contact(x).indentationRate; };
        displacementFold_ = rootBetween(indentationRate, 0.0, loadFold_.coordinate);
    }
    start_ = beyond;
    start_ = climb(MaugisControl::load(), 0.0, loadFold_).coordinate;
}

MaugisPoint MaugisDugdale::fold(const MaugisControl& control) const noexcept {
    if (control.heldRate(touch_) > 0.0) {
        const double lift = 8.0 * curve_.lambda() / (3.0 * pi);
        return curve_.noncontact(
            control.perIndentation * lift /
            (control.perIndentation - (pi * curve_.lambda() * control.perForce)));
    }
    const auto rate = [&](double x) { return control.heldRate(curve_.contact(x)); };
    return curve_.contact(rootBetween(rate, displacementFold_, loadFold_.coordinate));
}

std::optional<MaugisPoint> MaugisDugdale::stable(const MaugisControl& control,
                                                 double value) const noexcept {
    // Every fold lies at or below the one in load control, so above it none needs to be found.
    if (value >= control.held(loadFold_)) {
        return climb(control, value, loadFold_);
    }
    const MaugisPoint end = fold(control);
    if (value < control.held(end)) {
        return std::nullopt;
    }
    if (end.contactRadius > 0.0) {
        return climb(control, value, end);
    }
    if (value <= control.held(touch_)) {
        return stableNoncontact(control, value);
    }
    return climb(control, value, curve_.contact(0.0));
}

MaugisPoint MaugisDugdale::climb(const MaugisControl& control, double value,
                                 const MaugisPoint& from) const noexcept {
    constexpr int kMaxIterations = 100;
    const double origin = control.held(from);
    if (value <= origin) {
        return from;
    }
    PowerLawSearch search(from.coordinate, origin, value);
    MaugisPoint point = curve_.contact(start_);
    for (int i = 0; i < kMaxIterations; ++i) {
        const Rise rise = heldRise(control, point);
        if (std::abs(rise.value - value) <= rise.rounding) {
            break;
        }
        const double next = search.next(point.coordinate, rise);
        const bool done = std::abs(next - point.coordinate) <= 2.0 * kEpsilon * next;
        point = curve_.contact(next);
        if (done) {
            break;
        }
    }
    return point;
}

/// The larger root of a quadratic in the cohesive radius.
MaugisPoint MaugisDugdale::stableNoncontact(const MaugisControl& control,
                                            double value) const noexcept {
    const double lambda = curve_.lambda();
    const double curvature = control.perIndentation - (pi * lambda * control.perForce);
    const double slope = control.perIndentation * 8.0 * lambda / (3.0 * pi);
    const double above = value + (control.perIndentation * curve_.range());
    const double root = std::sqrt(std::max(0.0, (slope * slope) + (2.0 * curvature * above)));
    return curve_.noncontact((slope + root) / curvature);
}

MaugisPoint MaugisDugdale::atContactRadius(double contactRadius) const noexcept {
    const auto excess = [&](double x) { return curve_.contact(x).contactRadius - contactRadius; };
    double low = start_;
    double high = start_;
    while (excess(low) > 0.0) {
        low /= 4.0;
    }
    while (excess(high) < 0.0) {
        high *= 4.0;
    }
    return curve_.contact(rootBetween(excess, low, high));
}

}  // namespace asperity
