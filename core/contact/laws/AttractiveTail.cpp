#include "core/contact/laws/AttractiveTail.h"

#include "core/contact/laws/ContactLaw.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

/// sum over n >= 1 of 2n / (2n+1) y^(2n+1) = y / (1 - y^2) - atanh(y), which cancels for small y.
double energyShapeBySeries(double y) noexcept {
    constexpr int kTerms = 16;  // enough for y < 0.3
    const double square = y * y;
    double power = y * square;
    double sum = 0.0;
    for (int n = 1; n <= kTerms; ++n) {
        sum += 2.0 * n / (2.0 * n + 1.0) * power;
        power *= square;
    }
    return sum;
}

double energyShape(double separation, double radius) noexcept {
    const double y = radius / (separation + radius);
    if (y < 0.3) {
        return energyShapeBySeries(y);
    }
    const double toFarSide = separation + (2.0 * radius);
    return ((radius / separation) * ((separation + radius) / toFarSide)) -
           (0.5 * std::log(toFarSide / separation));
}

constexpr int kMaxIterations = 100;
constexpr double kTailEpsilon = std::numeric_limits<double>::epsilon();

/// Integral of v^12 / (d + v^2)^2 over 0 .. 1, d > 0, by Gauss-Legendre; better than 1e-9.
double liftWorkIntegral(double d) noexcept {
    constexpr std::array<double, 5> kNodes{0.1488743389816312, 0.4333953941292472,
                                           0.6794095682990244, 0.8650633666889845,
                                           0.9739065285171717};
    constexpr std::array<double, 5> kWeights{0.2955242247147529, 0.2692667193099963,
                                             0.2190863625159820, 0.1494513491505806,
                                             0.0666713443086881};
    const auto integrand = [d](double v) {
        const double square = v * v;
        const double ratio = square * square * square / (d + square);
        return ratio * ratio;
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
        sum += 0.5 * kWeights[i] *
               (integrand(0.5 * (1.0 + kNodes[i])) + integrand(0.5 * (1.0 - kNodes[i])));
    }
    return sum;
}

}  // namespace

double VanDerWaals::energy(double separation) const noexcept {
    const double d = std::max(separation, kContactSeparation);
    return -hamaker_ / 3.0 * energyShape(d, radius_);
}

/// D (D + 2R) = q is a quadratic in D.
double VanDerWaals::separationAt(double force) const noexcept {
    const double q = radius_ * std::sqrt(-2.0 / 3.0 * hamaker_ * radius_ / force);
    return q / (radius_ + std::sqrt((radius_ * radius_) + q));
}

double hamakerConstant(double workOfAdhesion) noexcept {
    return 12.0 * std::numbers::pi * workOfAdhesion * kContactSeparation * kContactSeparation;
}

AttractiveTail::AttractiveTail(const VanDerWaals& attraction, double reducedModulus,
                               double joint) noexcept
    : attraction_(attraction)
    , liftFactor_(attraction.hamaker() * std::sqrt(2.0 * attraction.radius()) /
                  (16.0 * reducedModulus))
    , joint_(joint)
    , elasticInstability_(std::pow(2.5 * liftFactor_, 2.0 / 7.0)) {}

double AttractiveTail::lift(double separation) const noexcept {
    return liftFactor_ / (separation * separation * std::sqrt(separation));
}

double AttractiveTail::indentation(double separation) const noexcept {
    return kContactSeparation - separation - lift(separation);
}

double AttractiveTail::stiffness(double separation) const noexcept {
    return curveStiffness(attraction_.gradient(separation),
                          (2.5 * lift(separation) / separation) - 1.0);
}

double AttractiveTail::approach(double separation, double compliance) const noexcept {
    return indentation(separation) + (compliance * attraction_.force(separation));
}

/// The first part is the attraction of rigid bodies, the second its work on the lift.
double AttractiveTail::energy(double separation) const noexcept {
    const double radius = attraction_.radius();
    const double ratio = separation / (2.0 * radius);
    const double liftWork = 5.0 / 6.0 * attraction_.hamaker() * radius / (separation * separation) *
                            lift(separation) * liftWorkIntegral(ratio);
    return attraction_.energy(separation) + liftWork;
}

double AttractiveTail::softening(double separation, double compliance) const noexcept {
    return (2.5 * lift(separation) / separation) + (compliance * attraction_.gradient(separation));
}

/// The softening falls as a power between -3 and -5 of the separation, so Newton's method on the
/// logarithms converges from anywhere.
double AttractiveTail::endSeparation(double compliance) const noexcept {
    double d = std::max(joint_, elasticInstability_);
    if (softening(d, compliance) <= 1.0) {
        return d;
    }
    const double radius = attraction_.radius();
    for (int i = 0; i < kMaxIterations; ++i) {
        const double elastic = 2.5 * lift(d) / d;
        const double lever = compliance * attraction_.gradient(d);
        const double leverPower = (d / (d + radius)) - 3.0 - (3.0 * d / (d + (2.0 * radius)));
        const double total = elastic + lever;
        const double power = ((-3.5 * elastic) + (lever * leverPower)) / total;
        const double next = d * std::pow(total, -1.0 / power);
        const bool done = std::abs(next - d) <= 4.0 * kTailEpsilon * d;
        d = next;
        if (done) {
            break;
        }
    }
    return d;
}

/// The approach is a concave function of the separation, and without attraction the separation
/// would be larger: Newton's method from there falls onto the root without passing it.
double AttractiveTail::separationAt(double approach, double compliance, double end) const noexcept {
    double d = std::max(end, kContactSeparation - approach);
    for (int i = 0; i < kMaxIterations; ++i) {
        const double miss = this->approach(d, compliance) - approach;
        const double slope = softening(d, compliance) - 1.0;
        if (!(slope < 0.0)) {
            break;
        }
        const double next = std::max(end, d - (miss / slope));
        if (!(next < d)) {
            break;
        }
        d = next;
    }
    return d;
}

/// The softening falls with the separation: where it is below 1, the end is nearer.
std::optional<double> AttractiveTail::stableSeparation(double approach,
                                                       double compliance) const noexcept {
    constexpr double kClearlyAbove = 1.001;
    constexpr double kClearlyStable = 0.9;
    const double nearest = std::max(joint_, elasticInstability_);
    const double found = separationAt(approach, compliance, nearest);
    if (found > kClearlyAbove * nearest && softening(found, compliance) < kClearlyStable) {
        return found;
    }
    const double end = endSeparation(compliance);
    if (approach > this->approach(end, compliance)) {
        return std::nullopt;
    }
    return separationAt(approach, compliance, end);
}

}  // namespace asperity
