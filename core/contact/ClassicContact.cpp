#include "core/contact/ClassicContact.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Force over indentation^(3/2) [N / m^(3/2)].
double hertzFactor(const ContactPair& pair) noexcept {
    return 4.0 / 3.0 * pair.reducedModulus * std::sqrt(pair.tipRadius);
}

}  // namespace

double hertzForce(const ContactPair& pair, double indentation) noexcept {
    if (!(indentation > 0.0)) {
        return 0.0;
    }
    return hertzFactor(pair) * indentation * std::sqrt(indentation);
}

double hertzContactRadius(const ContactPair& pair, double indentation) noexcept {
    return indentation > 0.0 ? std::sqrt(pair.tipRadius) * std::sqrt(indentation) : 0.0;
}

/// With y = sqrt(indentation) the balance is y^2 + b y^3 = approach. Each term alone bounds y from
/// above, and from above Newton's method on a convex function falls onto the root.
double hertzIndentation(const ContactPair& pair, double approach, double compliance) noexcept {
    constexpr int kMaxIterations = 60;
    const double b = compliance * hertzFactor(pair);
    if (!(approach > 0.0) || b == 0.0) {
        return approach;
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
    return y * y;
}

}  // namespace asperity
