#include "core/contact/laws/HertzLaw.h"

#include <algorithm>
#include <cmath>

namespace asperity {

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

}  // namespace asperity
