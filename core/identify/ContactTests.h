#pragma once

#include "core/identify/ElasticFit.h"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

/// Numbers by which an elastic fit is judged. Source: docs/measured.md.
struct ContactTests {
    std::size_t samples = 0;  ///< in contact
    double rangeOverNoise = 0.0;
    double largestIndentation = 0.0;  ///< [m]
    double exponent = 0.0;            ///< of force over indentation beyond 15 % of the largest
    double windowRatio = 1.0;         ///< E* of the upper over the lower half of the indentation
    double radiusRatio = 0.0;   ///< largest contact radius over tip radius; 0: the tip has none
    double slope = 0.0;         ///< d(deflection)/d(base) at the deepest quarter of the forces
    double contactShare = 0.0;  ///< change of E if the contact were where `deviation` sees it
};

/// @param deviation base at contact by ContactMethod::Deviation [m]
[[nodiscard]] ContactTests contactTests(const BranchSamples& branch, double stiffness, double noise,
                                        const TipLaw& tip, const ElasticFit& fit, double deviation);

/// A sentence on what a test says.
struct FitConcern {
    std::string text;
    bool againstModel = true;  ///< else against the accuracy of a value
};

/// Returns what the tests say against the model or its values.
/// @param isKnown the user has named the tip
[[nodiscard]] std::vector<FitConcern> concerns(const ContactTests& tests, const TipForm& tip,
                                               bool isKnown);

}  // namespace asperity
