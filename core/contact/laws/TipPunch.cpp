#include "core/contact/laws/TipPunch.h"

#include "core/contact/numerics/GaussLegendre.h"

#include <cmath>

namespace asperity {

namespace {

PunchContact onSphere(const SphereContact& contact) noexcept {
    return {.coordinate = contact.depth,
            .depth = contact.depth,
            .radius = contact.radius,
            .rim = contact.rim};
}

SphereContact sphereEdge(const PunchContact& contact) noexcept {
    return {contact.depth, contact.radius, contact.rim};
}

}  // namespace

TipPunch::TipPunch(double coneHalfAngle) noexcept {
    if (!(coneHalfAngle > 0.0)) {
        return;
    }
    sine_ = std::sin(coneHalfAngle);
    cosine_ = std::cos(coneHalfAngle);
    slope_ = cosine_ / sine_;
    joint_ = std::log((1.0 + cosine_) / sine_);  // atanh(cosine), exact for slender cones
}

PunchContact TipPunch::contact(double coordinate) const noexcept {
    return coordinate > joint_ ? onCone(sine_ * sine_ * (coordinate - joint_), coordinate)
                               : onSphere(sphereContact(coordinate));
}

PunchContact TipPunch::contactOfRadius(double radius) const noexcept {
    const double excess = radius - cosine_;
    return hasCone() && excess > 0.0 ? onCone(excess, joint_ + (excess / (sine_ * sine_)))
                                     : onSphere(sphereContactOfRadius(radius));
}

/// ln((1 + a) / (s + q)), without cancellation where it is small.
double TipPunch::sphereLogarithm(double radius, double run) const noexcept {
    const double square = cosine_ * cosine_;
    return std::log1p(((square / (1.0 + sine_)) + (square / (radius + run))) / (sine_ + run));
}

/// With a d(depth)/da = (a s - q) / ((1 + a) (s + q)) + r0^2 / (s (s + q)), in which the parts that
/// are infinite at the joint have canceled each other.
PunchContact TipPunch::onCone(double excess, double coordinate) const noexcept {
    const double a = cosine_ + excess;
    const double q = std::sqrt(excess * (cosine_ + a));
    const double bend = (((a * sine_) - q) / (1.0 + a)) + (cosine_ * slope_);
    return {.coordinate = coordinate,
            .depth = sphereLogarithm(a, q) + (slope_ * std::atan2(q, cosine_)),
            .radius = a,
            .rim = sine_,
            .depthRate = sine_ * sine_ * bend / ((sine_ + q) * a),
            .run = q};
}

PunchRing TipPunch::sphereRing(double radius) noexcept {
    const double depth = std::atanh(radius);
    return {radius, radius * depth, depth + (radius / ((1.0 - radius) * (1.0 + radius)))};
}

PunchRing TipPunch::coneRing(double run) const noexcept {
    const double a = std::hypot(cosine_, run);
    const double depth = sphereLogarithm(a, run) + (slope_ * std::atan2(run, cosine_));
    const double bend = (((a * sine_) - run) / (1.0 + a)) + (cosine_ * slope_);
    return {a, a * depth, depth + (bend / (sine_ + run))};
}

/// Integral of r^2 f'(r) / sqrt(a^2 - r^2) over the sphere f, to the joint: in closed form, or,
/// where that would cancel, by its depth u = a - sqrt(a^2 - r^2).
double TipPunch::sphereShare(double radius, double run) const noexcept {
    constexpr double kBlunt = 0.5;  // radius of the joint
    if (cosine_ > kBlunt) {
        return 0.5 * (((1.0 + (radius * radius)) * sphereLogarithm(radius, run)) - radius +
                      (sine_ * run));
    }
    return gaussLegendre(
        [radius](double u) {
            const double square = u * ((2.0 * radius) - u);
            return square / std::sqrt(1.0 - square);
        },
        0.0, cosine_ * cosine_ / (radius + run));
}

double TipPunch::force(const PunchContact& contact) const noexcept {
    if (!(contact.run > 0.0)) {
        return sphereForce(sphereEdge(contact));
    }
    const double a = contact.radius;
    const double q = contact.run;
    const double cone = slope_ * ((a * a * std::atan2(q, cosine_)) + (cosine_ * q));
    return cone + (2.0 * sphereShare(a, q));
}

/// Integral of the square of the indentation over the contact radius, along the cone; the logarithm
/// of 1 + q / s for a variable smoothes its beginning.
double TipPunch::coneSquareMoment(double run) const noexcept {
    const double end = std::log1p(run / sine_);
    const int pieces = static_cast<int>(end) + 1;
    const auto integrand = [this](double y) {
        const double q = sine_ * std::expm1(y);
        const double a = std::hypot(cosine_, q);
        const double lift = a * (sphereLogarithm(a, q) + (slope_ * std::atan2(q, cosine_)));
        return lift * lift * (q / a) * (sine_ + q);
    };
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        sum += gaussLegendre(integrand, end * i / pieces, end * (i + 1) / pieces);
    }
    return sum;
}

double TipPunch::elasticEnergy(const PunchContact& contact, double indentation) const noexcept {
    if (!(contact.run > 0.0)) {
        return sphereElasticEnergy(sphereEdge(contact), indentation);
    }
    const double a = contact.radius;
    const double twiceMoment = (2.0 * a * a * contact.depth) - force(contact);
    const double squares =
        sphereElasticEnergy(sphereContact(joint_), 0.0) + coneSquareMoment(contact.run);
    return (indentation * ((indentation * a) - twiceMoment)) + squares;
}

}  // namespace asperity
