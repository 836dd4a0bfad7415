#pragma once

#include "core/contact/maugis/MaugisCurve.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// What is held while tip and sample find their equilibrium, in the units of MaugisPoint: the sum
/// perIndentation * indentation + perForce * force.
struct MaugisControl {
    double perIndentation = 0.0;
    double perForce = 0.0;

    static constexpr MaugisControl load() noexcept { return {0.0, 1.0}; }
    static constexpr MaugisControl displacement() noexcept { return {1.0, 0.0}; }
    /// The base of a spring; its compliance in units of indentation over force, >= 0.
    static constexpr MaugisControl spring(double compliance) noexcept { return {1.0, compliance}; }

    [[nodiscard]] constexpr double held(const MaugisPoint& point) const noexcept {
        return (perIndentation * point.indentation) + (perForce * point.force);
    }
    /// Its rate along the curve towards higher load: stable states have > 0.
    [[nodiscard]] constexpr double heldRate(const MaugisPoint& point) const noexcept {
        return (perIndentation * point.indentationRate) + (perForce * point.forceRate);
    }
};

/// Stable equilibria of the Maugis-Dugdale curve and the folds where they end. The stable branch
/// runs from high load to one fold, with contact or without. Bounded, no allocation.
/// Source: docs/theory.md 2.5, 2.7, 7.1.
class MaugisDugdale {
public:
    /// Whether the fold in load control is found at once, for laws that many cold solutions are
    /// asked of, or by each that asks for it: a law that follows a way never does.
    enum class LoadFold : std::uint8_t { Kept, OnDemand };

    explicit MaugisDugdale(double lambda, LoadFold loadFold = LoadFold::Kept) noexcept;

    [[nodiscard]] const MaugisCurve& curve() const noexcept { return curve_; }

    /// The state with contact and the smallest indentation: the fold in displacement control, or
    /// first touch where that fold has no contact.
    [[nodiscard]] const MaugisPoint& lowestContact() const noexcept { return lowestContact_; }
    /// End of the stable branch: the smallest value that can be held in contact or cohesion.
    [[nodiscard]] MaugisPoint fold(const MaugisControl& control) const noexcept;
    /// The stable state at a held value; none below the fold.
    [[nodiscard]] std::optional<MaugisPoint> stable(const MaugisControl& control,
                                                    double value) const noexcept;
    /// The same state to rounding, by Newton's method from a state near it, such as the previous
    /// one of a slow motion, of this transition parameter or one close to it. A `start` far away or
    /// without contact only costs time.
    [[nodiscard]] std::optional<MaugisPoint> stable(const MaugisControl& control, double value,
                                                    const MaugisPoint& start) const noexcept;
    /// The same from the coordinate of such a state, one evaluation of the curve more; any number
    /// is allowed, even one that is not.
    [[nodiscard]] std::optional<MaugisPoint> stable(const MaugisControl& control, double value,
                                                    double start) const noexcept;
    /// The state with this contact radius (> 0), stable or not.
    [[nodiscard]] MaugisPoint atContactRadius(double contactRadius) const noexcept;

private:
    /// The smallest force of all states.
    [[nodiscard]] MaugisPoint loadFold() const noexcept;
    [[nodiscard]] MaugisPoint climb(const MaugisControl& control, double value,
                                    const MaugisPoint& from) const noexcept;
    [[nodiscard]] std::optional<MaugisPoint> follow(const MaugisControl& control, double value,
                                                    const MaugisPoint& start) const noexcept;
    [[nodiscard]] bool isSurelyStable(const MaugisControl& control,
                                      const MaugisPoint& point) const noexcept;
    [[nodiscard]] MaugisPoint stableNoncontact(const MaugisControl& control,
                                               double value) const noexcept;

    MaugisCurve curve_;
    MaugisPoint touch_;  ///< first touch, as a state without contact
    std::optional<MaugisPoint> loadFold_;
    MaugisPoint lowestContact_;  ///< end of the stable states with contact, by indentation
};

}  // namespace asperity
