#pragma once

#include "core/curves/MeasuredForceCurve.h"

#include <vector>

namespace asperity {

/// One branch of a curve whose contact is at 0.
struct AlignedBranch {
    std::vector<double> separation;    ///< of tip and sample, < 0: indented [m]
    std::vector<double> baseDistance;  ///< the same of the undeflected tip [m]
    std::vector<double> force;         ///< above the baseline [N]
};

/// A measured curve, ready to be compared: its baseline at no force, its contact at no distance.
struct AlignedForceCurve {
    AlignedBranch approach;
    AlignedBranch retract;       ///< empty: the file holds none
    double baselineForce = 0.0;  ///< taken off at the contact [N]
    double baselineSlope = 0.0;  ///< and its tilt over the base's way to the sample [N/m]
    double retractOffset = 0.0;  ///< of the retract's baseline above it, taken off as well [N]
    double noise = 0.0;          ///< standard deviation about the baseline [N]
    double stiffness = 0.0;      ///< of the lever, with which deflections are computed [N/m]
    double lastPull = 0.0;       ///< base distance beyond which nothing but noise acts, >= 0 [m]
};

/// Aligns the approach that reaches the largest force, and the retract after it. The baseline is a
/// line through the far third of the approach; a retract that comes as far back has its own offset.
/// The contact is where the force of the approach last passes zero before its maximum.
/// Source: docs/measuring.md.
/// @param stiffness of the lever where the curve does not say it, > 0 [N/m]
/// @throw Error where there is no approach, too few points, or no contact beyond the noise
[[nodiscard]] AlignedForceCurve alignedCurve(const MeasuredForceCurve& curve, double stiffness);

}  // namespace asperity
