#pragma once

#include <cmath>
#include <limits>

namespace asperity {

/// One equilibrium of tip and sample on the curve of a contact law, stable or not.
///
/// Every law with one file of its own (HertzLaw, JkrLaw, ...) offers the same four functions, so
/// that ContactModel treats them alike; none of them allocates or throws:
///   LawPoint fold(double compliance) const
///       end of the stable branch on a lever of this compliance [m/N] (0: displacement control);
///   std::optional<LawPoint> stable(double approach, double compliance) const
///       the stable state where approach = indentation + compliance x force [m]; none below fold();
///   double energy(const LawPoint&) const
///       work done on separate bodies to reach the state along the curve [J], without the lever;
///   double onset() const
///       indentation at which separate bodies begin to attract each other [m], <= 0.
struct LawPoint {
    double force = 0.0;           ///< of the sample on the tip, > 0 repulsive [N]
    double indentation = 0.0;     ///< approach of the undeformed bodies, < 0: a gap [m]
    double contactRadius = 0.0;   ///< [m]
    double cohesiveRadius = 0.0;  ///< outer radius of the cohesive zone, >= contactRadius [m]
    double stiffness = 0.0;       ///< d(force)/d(indentation) along the curve [N/m]
    double coordinate = 0.0;      ///< on the curve, where a law can start from it; 0: none
};

/// Slope of a curve from its rates; the largest double where the curve is vertical.
[[nodiscard]] inline double curveStiffness(double forceRate, double indentationRate) noexcept {
    constexpr double kMax = std::numeric_limits<double>::max();
    if (std::abs(indentationRate) <= std::abs(forceRate) / kMax) {
        return std::copysign(kMax, forceRate);
    }
    return forceRate / indentationRate;
}

}  // namespace asperity
