#include "core/contact/maugis/MaugisCurve.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

constexpr double kSeriesLimit = 0.5;  // below this angle A and B are sums of powers

/// phi with its sine and cosine, all to full relative precision at both ends of 0 .. pi/2.
struct Angle {
    double value;
    double sine;
    double cosine;
};

Angle angleOf(double coordinate) noexcept {
    if (coordinate > 1.0) {
        const double tangent = 1.0 / coordinate;
        const double cosine = 1.0 / std::sqrt(1.0 + (tangent * tangent));
        return {std::atan(tangent), tangent * cosine, cosine};
    }
    const double sine = 1.0 / std::sqrt(1.0 + (coordinate * coordinate));
    return {(pi / 2.0) - std::atan(coordinate), sine, coordinate * sine};
}

/// A(phi) and B(phi) of docs/theory.md 2.3: the two moments of the cohesive zone.
struct ZoneMoments {
    double geometric;  ///< A = sin(2 phi) / 2 - phi cos(2 phi)
    double elastic;    ///< B = phi sin(phi) - 2 sin^2(phi / 2)
};

/// Coefficients of powers of phi^2 in A / phi^3 and B / phi^2.
struct MomentSeries {
    static constexpr int kTerms = 10;  // the next one is below 1e-17 of the sum at kSeriesLimit
    std::array<double, kTerms> geometric{};
    std::array<double, kTerms> elastic{};
};

/// A = 1/2 sum (-1)^(k+1) 2k x^(2k+1) / (2k+1)!, x = 2 phi;  B = sum (-1)^(k+1) (2k-1) phi^(2k) /
/// (2k)!.
constexpr MomentSeries momentSeries() noexcept {
    MomentSeries series;
    double powerOfDouble = 2.0 / 3.0;  // 2^(2k+1) / (2 (2k+1)!) with its sign, at k = 1
    double power = 0.5;                // 1 / (2k)! with its sign, at k = 1
    for (std::size_t i = 0; i < MomentSeries::kTerms; ++i) {
        const double twoK = 2.0 * static_cast<double>(i + 1);
        series.geometric[i] = twoK * powerOfDouble;
        series.elastic[i] = (twoK - 1.0) * power;
        powerOfDouble *= -4.0 / ((twoK + 2.0) * (twoK + 3.0));
        power *= -1.0 / ((twoK + 1.0) * (twoK + 2.0));
    }
    return series;
}

/// The closed forms are differences of nearly equal numbers for small phi; these are not. Even and
/// odd terms are summed apart: half as long a chain of dependent operations.
ZoneMoments momentsBySeries(double phi) noexcept {
    constexpr MomentSeries kSeries = momentSeries();
    const double square = phi * phi;
    const double fourth = square * square;
    ZoneMoments even{0.0, 0.0};
    ZoneMoments odd{0.0, 0.0};
    for (std::size_t i = MomentSeries::kTerms; i > 0; i -= 2) {
        odd.geometric = (odd.geometric * fourth) + kSeries.geometric[i - 1];
        odd.elastic = (odd.elastic * fourth) + kSeries.elastic[i - 1];
        even.geometric = (even.geometric * fourth) + kSeries.geometric[i - 2];
        even.elastic = (even.elastic * fourth) + kSeries.elastic[i - 2];
    }
    return {(even.geometric + (odd.geometric * square)) * square * phi,
            (even.elastic + (odd.elastic * square)) * square};
}

ZoneMoments momentsOf(const Angle& phi) noexcept {
    if (phi.value < kSeriesLimit) {
        return momentsBySeries(phi.value);
    }
    const double cosineOfDouble = (phi.cosine - phi.sine) * (phi.cosine + phi.sine);
    return {(phi.sine * phi.cosine) - (phi.value * cosineOfDouble),
            (phi.value * phi.sine) - (1.0 - phi.cosine)};
}

}  // namespace

MaugisPoint MaugisCurve::contact(double coordinate) const noexcept {
    const Angle phi = angleOf(coordinate);
    const auto [geometric, elastic] = momentsOf(phi);
    const double linear = 4.0 / 3.0 * lambda_ * lambda_ * elastic;
    const double c = 2.0 / (linear + std::sqrt((linear * linear) + (2.0 * lambda_ * geometric)));
    const double a = c * phi.cosine;
    const double zone = phi.value + (phi.sine * phi.cosine);

    // Derivatives by phi over cos(phi): they all vanish with cos(phi) where contact begins, their
    // quotients do not. The sign turns them towards higher load, i.e. smaller phi.
    const double cRate = -phi.value * 2.0 * lambda_ * c * ((c * phi.sine) + (2.0 / 3.0 * lambda_)) /
                         ((lambda_ * c * geometric) + linear);
    const double aRate = (phi.cosine * phi.cosine * cRate) - (c * phi.sine);
    MaugisPoint point;
    point.coordinate = coordinate;
    point.angle = phi.value;
    point.contactRadius = a;
    point.cohesiveRadius = c;
    point.force = (a * a * a) - (lambda_ * c * c * zone);
    point.indentation = (a * a) - (4.0 / 3.0 * lambda_ * c * phi.sine);
    point.forceRate =
        -((3.0 * a * c * aRate) - (2.0 * lambda_ * c * ((cRate * zone) + (c * phi.cosine))));
    point.indentationRate = -((2.0 * c * aRate) - (4.0 / 3.0 * lambda_ * ((cRate * phi.sine) + c)));
    return point;
}

MaugisPoint MaugisCurve::noncontact(double cohesiveRadius) const noexcept {
    const double c = cohesiveRadius;
    MaugisPoint point;
    point.angle = pi / 2.0;
    point.cohesiveRadius = c;
    point.force = -pi / 2.0 * lambda_ * c * c;
    point.indentation = (c * c / 2.0) - (8.0 * lambda_ / (3.0 * pi) * c) - range();
    point.forceRate = -pi * lambda_ * c;
    point.indentationRate = c - (8.0 * lambda_ / (3.0 * pi));
    return point;
}

double MaugisCurve::touchRadius() const noexcept {
    const double half = 4.0 / 3.0 * (1.0 - (2.0 / pi)) * lambda_;
    const double product = 4.0 / (pi * lambda_);
    return product / (half + std::sqrt((half * half) + product));
}

double MaugisCurve::range() const noexcept { return 2.0 / (pi * lambda_); }

double MaugisCurve::energy(const MaugisPoint& point) const noexcept {
    const double c = point.cohesiveRadius;
    if (point.contactRadius == 0.0) {
        return -pi / 2.0 * lambda_ * c * c * c * ((c / 4.0) - (8.0 * lambda_ / (9.0 * pi)));
    }
    const double a = point.contactRadius;
    const double lift = 4.0 / 3.0 * lambda_ * c * std::sin(point.angle);
    const double width = 2.0 * c * std::pow(std::sin(point.angle / 2.0), 2);  // c - a
    const double inContact =
        (8.0 / 15.0 * std::pow(a, 5)) - (4.0 / 3.0 * lift * a * a * a) + (lift * lift * a);
    const double inZone = 16.0 / 27.0 * lambda_ * lambda_ * width * width * ((2.0 * c) + a);
    return (0.75 * (inContact + inZone)) - (c * c) + cohesiveWork(point);
}

/// pi lambda times the integral of gap(r) r over the cohesive zone: work still to be had from it.
/// The displacement enters by its Abel transform (docs/theory.md 4.1), which integrates in closed
/// form.
double MaugisCurve::cohesiveWork(const MaugisPoint& point) const noexcept {
    const double a = point.contactRadius;
    const double c = point.cohesiveRadius;
    const double delta = point.indentation;
    const double edge = c * std::sin(point.angle);
    const double complement = std::atan(point.coordinate);  // pi/2 - phi
    const double width = 2.0 * c * std::pow(std::sin(point.angle / 2.0), 2);
    const double square = edge * edge;  // c^2 - a^2
    const double undeformed = (square * ((c * c) + (a * a)) / 8.0) - (delta * square / 2.0);
    const double outer =
        (delta / 2.0 * ((a * edge) + (c * c * complement))) -
        (((std::pow(c, 4) * complement) + (a * edge * ((2.0 * a * a) - (c * c)))) / 8.0);
    const double inner = pi / 4.0 * a * a * (delta - (a * a / 4.0));
    const double zone = 4.0 / 9.0 * lambda_ * width * width * ((2.0 * c) + a);
    return pi * lambda_ * (undeformed + (2.0 / pi * (outer - inner - zone)));
}

}  // namespace asperity
