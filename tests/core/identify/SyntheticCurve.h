#pragma once

#include "core/curves/MeasuredForceCurve.h"
#include "core/identify/TipLaw.h"

#include <cstddef>

namespace asperity::test {

/// An elastic cycle on a lever, as an instrument would store it.
struct SyntheticCurve {
    TipForm tip{.kind = TipKind::Paraboloid, .radius = 10e-6};
    double reducedModulus = 2e3;  ///< [Pa]
    double stiffness = 0.05;      ///< of the lever [N/m]
    double contact = 3.2e-6;      ///< base at contact [m]
    double start = -4e-6;         ///< base from there [m]
    double end = 1.5e-6;          ///< [m]
    double offset = -2e-10;       ///< baseline at contact [N]
    double tilt = 5e-6;           ///< [N/m]
    double drag = 0.0;            ///< pushes up on the approach, down on the retract [N]
    double noise = 0.0;           ///< standard deviation of a sample [N]
    double memory = 0.0;          ///< correlation of the noise from one sample to the next
    std::size_t samples = 1000;   ///< of each branch

    /// Approach and retract with base, force and deflection. @param seed of the noise
    [[nodiscard]] MeasuredForceCurve curve(unsigned seed = 1) const;
    /// Force on the tip at a distance of the base from contact [N].
    [[nodiscard]] double force(const TipLaw& law, double beyond) const;
};

}  // namespace asperity::test
