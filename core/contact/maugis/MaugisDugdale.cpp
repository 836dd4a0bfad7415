#include "core/contact/maugis/MaugisDugdale.h"

#include "core/contact/Within.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

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

using std::numbers::pi;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Approximations of the coordinates of three states, from which the exact ones are searched.
struct Landmarks {
    double loadFold;          ///< smallest force
    double displacementFold;  ///< smallest indentation; 0 where that state has no contact
    double noForce;           ///< contact without force
};

/// Rational fits between the limits for small and large lambda, within 1e-3, 1e-4 and 4e-2.
Landmarks landmarksOf(double lambda) noexcept {
    constexpr double kLimit = 0.9379474570;  // lambda* of docs/theory.md 2.5
    const double root = std::sqrt(lambda);
    const double t = root / (1.0 + root);
    const double load =
        (1.85611 + (t * (-7.14419 + (t * (11.80781 + (t * (-7.80180 + (t * 3.12816)))))))) /
        (1.0 + (t * (-4.85040 + (t * (10.27633 + (t * (-10.04824 + (t * 5.73558))))))));
    const double r = std::min(kLimit / lambda, 1.0);
    const double displacement =
        (0.6057094 + (r * (-0.3530192 + (r * (-0.3815663 + (r * 0.2001644)))))) /
        (1.0 + (r * (-1.5811170 + (r * (0.6165144 - (r * 0.0027015))))));
    const double noForce = 1.12512 + (t * (-1.58859 + (t * 1.57031)));
    return {load * lambda * root / (1.0 + root), displacement * lambda * (1.0 - r),
            noForce * (root + lambda)};
}

/// Root near `guess` of a `function` that rises from below 0 at `low` to above 0 at `high`: secant
/// steps within the shrinking bracket, and a search that cannot fail where they are not enough.
template <typename Function>
double rootNear(const Function& function, double guess, double low, double high) noexcept {
    constexpr int kMaxIterations = 20;
    constexpr double kFirstStep = 1e-3;  // relative
    double previous = guess;
    double fPrevious = function(previous);
    double here = std::min((1.0 + kFirstStep) * guess, 0.5 * (guess + high));
    for (int i = 0; i < kMaxIterations; ++i) {
        const double fHere = function(here);
        if (fHere == fPrevious) {
            break;
        }
        (fHere < 0.0 ? low : high) = here;
        const double trial = here - (fHere * (here - previous) / (fHere - fPrevious));
        const double next = trial >= low && trial <= high ? trial : 0.5 * (low + high);
        // What is left after a secant step is about the product of the two offsets it started from.
        const double left = std::abs((next - here) * (next - previous)) / next;
        if (left <= 0.01 * kEpsilon * next || std::abs(next - here) <= 2.0 * kEpsilon * next) {
            return next;
        }
        previous = std::exchange(here, next);
        fPrevious = fHere;
    }
    return rootBetween(function, low, high);
}

/// d coordinate / d phi = -1 / sin^2 = -(1 + coordinate^2), and the rates of a point are by -phi
/// over cos(phi).
double ratePerCoordinate(const MaugisPoint& point) noexcept {
    return point.contactRadius /
           (point.cohesiveRadius * (1.0 + (point.coordinate * point.coordinate)));
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

/// Coordinates from which Newton's method may set out: nothing overflows between them.
bool isStart(double coordinate) noexcept { return isWithin(coordinate, 1e-30, 1e18); }

/// Newton's step; infinite where it would leave the branch.
double newtonStep(const Rise& rise, double value, double coordinate) noexcept {
    const double climb = value - rise.value;
    const bool stays = rise.rate > 0.0 && std::abs(climb) <= coordinate * rise.rate;
    return stays ? climb / rise.rate : kInfinity;
}

/// From the second of two states, `width` apart, to where the cubic through both and their rates
/// takes the value.
double inverseHermite(double width, const Rise& before, const Rise& rise, double value) noexcept {
    const double span = rise.value - before.value;
    const double t = (value - rise.value) / span;
    const double chord = width / span;
    const double slope = 1.0 / rise.rate;
    const double bend = slope - chord;
    const double twist = slope + (1.0 / before.rate) - (2.0 * chord);
    return span * t * (slope + (t * (bend + ((1.0 + t) * twist))));
}

/// The state where one of its rates turns from falling to rising.
MaugisPoint foldOf(const MaugisCurve& curve, double MaugisPoint::*rate,
                   double Landmarks::*guess) noexcept {
    const Landmarks near = landmarksOf(curve.lambda());
    const auto rateAt = [&](double coordinate) { return curve.contact(coordinate).*rate; };
    return curve.contact(rootNear(rateAt, near.*guess, 0.0, near.noForce * 1.5));
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

MaugisDugdale::MaugisDugdale(double lambda, LoadFold loadFold) noexcept
    : curve_(lambda)
    , touch_(curve_.noncontact(curve_.touchRadius()))
    , lowestContact_(curve_.contact(0.0)) {
    if (touch_.indentationRate < 0.0) {
        lowestContact_ =
            foldOf(curve_, &MaugisPoint::indentationRate, &Landmarks::displacementFold);
    }
    if (loadFold == LoadFold::Kept) {
        loadFold_ = this->loadFold();
    }
}

MaugisPoint MaugisDugdale::loadFold() const noexcept {
    return loadFold_ ? *loadFold_ : foldOf(curve_, &MaugisPoint::forceRate, &Landmarks::loadFold);
}

MaugisPoint MaugisDugdale::fold(const MaugisControl& control) const noexcept {
    if (control.perIndentation == 0.0) {
        return loadFold();
    }
    if (control.heldRate(touch_) > 0.0) {
        const double lift = 8.0 * curve_.lambda() / (3.0 * pi);
        return curve_.noncontact(
            control.perIndentation * lift /
            (control.perIndentation - (pi * curve_.lambda() * control.perForce)));
    }
    if (control.perForce == 0.0) {
        return lowestContact_;
    }
    // Between these ends the two parts of the rate have opposite signs: their balance over their
    // sum runs from -1 to 1.
    const auto balance = [&](double x) {
        const MaugisPoint point = curve_.contact(x);
        const double pull = control.perForce * std::abs(point.forceRate);
        return (point.indentationRate - pull) / (std::abs(point.indentationRate) + pull);
    };
    const MaugisPoint loadFold = this->loadFold();
    const double low = lowestContact_.coordinate;
    const double high = loadFold.coordinate;
    const double pull = control.perForce * std::abs(lowestContact_.forceRate);
    const double part = pull / (pull + loadFold.indentationRate);
    return curve_.contact(rootNear(balance, low + (part * (high - low)), low, high));
}

std::optional<MaugisPoint> MaugisDugdale::stable(const MaugisControl& control,
                                                 double value) const noexcept {
    // Every fold lies at or below the one in load control, so above it none needs to be found.
    const MaugisPoint loadFold = this->loadFold();
    if (value >= control.held(loadFold)) {
        return climb(control, value, loadFold);
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

std::optional<MaugisPoint> MaugisDugdale::stable(const MaugisControl& control, double value,
                                                 double start) const noexcept {
    return isStart(start) ? stable(control, value, curve_.contact(start)) : stable(control, value);
}

std::optional<MaugisPoint> MaugisDugdale::stable(const MaugisControl& control, double value,
                                                 const MaugisPoint& start) const noexcept {
    std::optional<MaugisPoint> point;
    if (isStart(start.coordinate)) {
        point = follow(control, value, start);
    }
    if (!point) {
        point = stable(control, value);
    }
    return point;
}

/// Steps of at most a factor of two along the branch with contact. Nothing is returned where they
/// do not settle at once, or so near a fold that rounding could decide on the other side of it.
/// `start` is not believed to be on this curve: at least one step is taken.
std::optional<MaugisPoint> MaugisDugdale::follow(const MaugisControl& control, double value,
                                                 const MaugisPoint& start) const noexcept {
    constexpr int kMaxIterations = 6;
    double previous = start.coordinate;
    Rise before = heldRise(control, start);
    double here = previous + newtonStep(before, value, previous);
    for (int i = 0; i < kMaxIterations; ++i) {
        if (!isWithin(here, 0.5 * previous, 2.0 * previous)) {
            break;
        }
        const MaugisPoint point = curve_.contact(here);
        const Rise rise = heldRise(control, point);
        const double miss = std::abs(rise.value - value);
        if (miss <= rise.rounding) {
            return isSurelyStable(control, point) ? std::optional(point) : std::nullopt;
        }
        if (miss > here * rise.rate || rise.value == before.value) {
            break;
        }
        const double step = inverseHermite(here - previous, before, rise, value);
        previous = std::exchange(here, here + step);
        before = rise;
    }
    return std::nullopt;
}

/// Any state in contact that rises is stable; one close to a fold only seems to rise or not.
bool MaugisDugdale::isSurelyStable(const MaugisControl& control,
                                   const MaugisPoint& point) const noexcept {
    constexpr double kClear = 1e-3;  // of the held value's size, per relative change of coordinate
    if (control.heldRate(touch_) > 0.0) {
        return true;
    }
    const Rise rise = heldRise(control, point);
    return rise.rate * point.coordinate > kClear * rise.rounding / (2.0 * kEpsilon);
}

MaugisPoint MaugisDugdale::climb(const MaugisControl& control, double value,
                                 const MaugisPoint& from) const noexcept {
    const double origin = control.held(from);
    if (value <= origin) {
        return from;
    }
    MaugisPoint point;
    const auto heldAt = [&](double coordinate) {
        point = curve_.contact(coordinate);
        return heldRise(control, point);
    };
    const double guess = landmarksOf(curve_.lambda()).noForce;
    const double found = RisingSearch(from.coordinate, origin, value).solve(heldAt, guess);
    if (found != point.coordinate) {
        point = curve_.contact(found);
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
    double low = landmarksOf(curve_.lambda()).noForce;
    double high = low;
    while (excess(low) > 0.0) {
        low /= 4.0;
    }
    while (excess(high) < 0.0) {
        high *= 4.0;
    }
    return curve_.contact(rootBetween(excess, low, high));
}

MaugisUnits maugisUnits(const ContactPair& pair) noexcept {
    const double stiffness = 4.0 / 3.0 * pair.reducedModulus;  // K
    const double force = std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
    const double radius = std::cbrt(force * pair.tipRadius / stiffness);
    return {.radius = radius, .force = force, .indentation = radius * (radius / pair.tipRadius)};
}

double transitionParameter(const MaugisUnits& units, double cohesiveStress) noexcept {
    return 2.0 * cohesiveStress * units.radius * units.radius / units.force;
}

}  // namespace asperity
