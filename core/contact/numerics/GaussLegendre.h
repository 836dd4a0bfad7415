#pragma once

#include <array>

namespace asperity {

/// Integral of a smooth function from `low` to `high` by the 16-point rule of Gauss and Legendre,
/// exact for polynomials up to degree 31. Bounded, no allocation. A function may return several
/// numbers at once, of a type with +, += and a product with a number, whose default is zero.
template <typename Function>
auto gaussLegendre(const Function& function, double low, double high) noexcept {
    struct Node {
        double place;
        double weight;
    };
    constexpr std::array<Node, 8> kNodes{{{0.98940093499164993, 0.027152459411754095},
                                          {0.94457502307323258, 0.062253523938647893},
                                          {0.86563120238783174, 0.095158511682492785},
                                          {0.75540440835500303, 0.12462897125553387},
                                          {0.61787624440264375, 0.14959598881657673},
                                          {0.45801677765722739, 0.16915651939500254},
                                          {0.28160355077925891, 0.18260341504492359},
                                          {0.09501250983763744, 0.1894506104550685}}};
    const double center = 0.5 * (low + high);
    const double half = 0.5 * (high - low);
    decltype(function(low)) sum{};
    for (const Node& node : kNodes) {
        const double offset = half * node.place;
        sum += node.weight * (function(center - offset) + function(center + offset));
    }
    return half * sum;
}

}  // namespace asperity
