#pragma once

#include "ui/Steady.h"

#include <optional>

namespace asperity {

/// By how much displacements, and the gap with them, are drawn larger than life: a round number
/// that seldom changes, or what the user wants.
class Magnification {
public:
    /// Empty: chosen from what there is to see. @param factor >= 1
    void fix(std::optional<double> factor) { fixed_ = factor; }

    /// @param displacement largest magnitude shown [m]
    /// @param gap          between tip and surface at rest, < 0 when indented [m]
    /// @param tipRadius    [m]
    double fit(double displacement, double gap, double tipRadius);
    [[nodiscard]] double factor() const;

private:
    SteadyFactor chosen_{1e-15};
    std::optional<double> fixed_;
};

}  // namespace asperity
