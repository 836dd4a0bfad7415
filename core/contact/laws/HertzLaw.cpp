#include "core/contact/laws/HertzLaw.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kHardnessOverYieldStress = 2.8;

}  // namespace

HertzLaw::HertzLaw(const ContactPair& pair) noexcept
    : tipRadius_(pair.tipRadius)
    , factor_(4.0 / 3.0 * pair.reducedModulus * std::sqrt(pair.tipRadius)) {}

LawPoint HertzLaw::atContactRadius(double contactRadius) const noexcept {
    LawPoint point = atIndentation(contactRadius * (contactRadius / tipRadius_));
    point.contactRadius = contactRadius;
    point.cohesiveRadius = contactRadius;
    return point;
}

LawPoint HertzLaw::atForce(double force) const noexcept {
    const double root = std::cbrt(force / factor_);
    LawPoint point = atIndentation(root * root);
    point.force = force;
    return point;
}

LawPoint HertzLaw::atIndentation(double indentation) const noexcept {
    const double root = std::sqrt(indentation);
    const double radius = std::sqrt(tipRadius_) * root;
    return {.force = factor_ * indentation * root,
            .indentation = indentation,
            .contactRadius = radius,
            .cohesiveRadius = radius,
            .stiffness = 1.5 * factor_ * root};
}

LawPoint HertzLaw::fold(double /*compliance*/) const noexcept { return {}; }

/// With y = sqrt(indentation) the balance is y^2 + b y^3 = approach. Each term alone bounds y from
/// above, and from above Newton's method on a convex function falls onto the root.
std::optional<LawPoint> HertzLaw::stable(double approach, double compliance) const noexcept {
    constexpr int kMaxIterations = 60;
    if (!(approach >= 0.0)) {
        return std::nullopt;
    }
    const double b = compliance * factor_;
    if (approach == 0.0 || b == 0.0) {
        return atIndentation(approach);
    }
    double y = std::min(std::sqrt(approach), std::cbrt(approach / b));
    for (int i = 0; i < kMaxIterations; ++i) {
        const double miss = (y * y * (1.0 + (b * y))) - approach;
        const double next = y - (miss / (y * (2.0 + (3.0 * b * y))));
        if (!(next < y)) {
            break;
        }
        y = next;
    }
    return atIndentation(y * y);
}

double HertzLaw::energy(const LawPoint& point) const noexcept {
    return 0.4 * factor_ * point.indentation * point.indentation * std::sqrt(point.indentation);
}

DmtLaw::DmtLaw(const ContactPair& pair) noexcept
    : elastic_(pair), attraction_(2.0 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius) {}

LawPoint DmtLaw::attracted(LawPoint point) const noexcept {
    point.force -= attraction_;
    return point;
}

LawPoint DmtLaw::atContactRadius(double contactRadius) const noexcept {
    return attracted(elastic_.atContactRadius(contactRadius));
}

LawPoint DmtLaw::atForce(double force) const noexcept {
    return attracted(elastic_.atForce(force + attraction_));
}

LawPoint DmtLaw::atIndentation(double indentation) const noexcept {
    return attracted(elastic_.atIndentation(indentation));
}

LawPoint DmtLaw::fold(double compliance) const noexcept {
    return attracted(elastic_.fold(compliance));
}

/// The constant attraction moves the lever by a constant.
std::optional<LawPoint> DmtLaw::stable(double approach, double compliance) const noexcept {
    const auto point = elastic_.stable(approach + (compliance * attraction_), compliance);
    return point ? std::optional(attracted(*point)) : std::nullopt;
}

double DmtLaw::energy(const LawPoint& point) const noexcept {
    return elastic_.energy(point) - (attraction_ * point.indentation);
}

LawPoint SneddonLaw::pointAt(const PunchContact& contact) const noexcept {
    const double a = contact.radius;
    return units_.toSi({.force = punch_.force(contact),
                        .indentation = a * contact.depth,
                        .contactRadius = a,
                        .cohesiveRadius = a,
                        .stiffness = 2.0 * a});
}

/// Indentation and deflection of a lever of this compliance, along the tip.
Rise SneddonLaw::approachAt(const PunchContact& contact, double compliance) const noexcept {
    constexpr double kRounding = 4e-16;
    const double a = contact.radius;
    const double value = (a * contact.depth) + (compliance * punch_.force(contact));
    const double indentationRate =
        (a * contact.depthRate) + (contact.depth * contact.rim * contact.rim);
    return {value, indentationRate * (1.0 + (2.0 * a * compliance)), kRounding * value};
}

LawPoint SneddonLaw::at(double contactRadius) const noexcept {
    return pointAt(punch_.contactOfRadius(contactRadius / units_.length));
}

LawPoint SneddonLaw::fold(double /*compliance*/) noexcept { return {}; }

std::optional<LawPoint> SneddonLaw::stable(double approach, double compliance) const noexcept {
    if (!(approach > 0.0)) {
        return std::nullopt;
    }
    const double soft = compliance * units_.stiffness;
    const double target = approach / units_.length;
    const double coordinate =
        RisingSearch(0.0, 0.0, target)
            .solve([&](double x) { return approachAt(punch_.contact(x), soft); },
                   std::fmin(std::sqrt(target), target));
    return pointAt(punch_.contact(coordinate));
}

double SneddonLaw::energy(const LawPoint& point) const noexcept {
    const LawPoint unit = units_.fromSi(point);
    return units_.energy() *
           punch_.elasticEnergy(punch_.contactOfRadius(unit.contactRadius), unit.indentation);
}

double yieldPressure(double hardness, double poissonRatio) noexcept {
    const double yieldStress = hardness / kHardnessOverYieldStress;
    return 1.295 * std::exp(0.736 * poissonRatio) * yieldStress;
}

}  // namespace asperity
