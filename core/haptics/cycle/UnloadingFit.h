#pragma once

#include "core/haptics/cycle/ContactCycle.h"
#include "core/haptics/cycle/ForceDistancePoint.h"

#include <optional>

namespace asperity {

/// Contact stiffness dF/d(indentation) at the beginning of unloading: from the deepest place until
/// the force has fallen to three quarters. Force and separation are each fitted with a line over
/// the base distance, which has no noise, so that their ratio is not biased as a fit of two noisy
/// quantities to each other is. O(1), allocation-free.
/// Source: initial unloading stiffness, Oliver and Pharr (1992).
class UnloadingFit {
public:
    /// Begins at the deepest place so far.
    /// @param force the trend there [N]
    void restart(const ForceDistancePoint& deepest, double force) noexcept;
    /// Takes a tick after that; what comes below three quarters of the force is left out.
    /// @param force the trend [N]
    void take(const ForceDistancePoint& point, double force) noexcept;

    /// None where there is no unloading yet, or a slope is less than ten times its standard
    /// deviation: then the contact is stiffer, or softer, than the lever can tell [N/m].
    [[nodiscard]] std::optional<Reading> stiffness() const noexcept;

private:
    void add(const ForceDistancePoint& point) noexcept;
    /// Of a quantity over the base distance, from its sums. There is some spread.
    [[nodiscard]] Reading slopeOf(double sum, double sumOfSquares,
                                  double sumOfProducts) const noexcept;

    bool open_ = false;
    double endForce_ = 0.0;  ///< below which unloading counts no more [N]
    ForceDistancePoint first_;
    // Sums of differences from the first point.
    double count_ = 0.0;
    double base_ = 0.0;            ///< of base distances [m]
    double force_ = 0.0;           ///< [N]
    double separation_ = 0.0;      ///< [m]
    double baseBase_ = 0.0;        ///< [m^2]
    double baseForce_ = 0.0;       ///< [N m]
    double baseSeparation_ = 0.0;  ///< [m^2]
    double separation2_ = 0.0;     ///< [m^2]
    double force2_ = 0.0;          ///< [N^2]
};

}  // namespace asperity
