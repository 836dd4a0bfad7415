#pragma once

#include "core/contact/laws/ContactModel.h"

#include <optional>
#include <vector>

namespace asperity {

/// One point of an approach or retract curve.
struct ForceCurvePoint {
    double basePosition = 0.0;  ///< x_b, of the lever's base towards the sample; 0: first touch [m]
    ContactState state;
};

/// A jump of the tip while the base is at rest.
struct TipJump {
    double basePosition = 0.0;  ///< [m]
    ContactState before;
    ContactState after;  ///< with the energy lost
};

/// The snap-in of a law on a lever; none: the force has no jump on the way in.
/// @param compliance of the lever along the surface's normal [m/N]
[[nodiscard]] std::optional<TipJump> snapInOf(const ContactModel& model,
                                              double compliance) noexcept;
/// The pull-off of a law on a lever, on the way out.
[[nodiscard]] std::optional<TipJump> pullOffOf(const ContactModel& model,
                                               double compliance) noexcept;

/// The strongest pull that the law has between tip and sample, and where the base of a lever has it
/// on the way out. On a stiff lever the tip passes it and is pulled less when it comes off. None:
/// the law never pulls.
[[nodiscard]] std::optional<ForceCurvePoint> strongestPullOf(const ContactModel& model,
                                                             double compliance) noexcept;

/// The base position at which a tip in contact is pushed with a force [m]; none: the law reaches it
/// at no position within its range.
/// @param force > 0 [N]
[[nodiscard]] std::optional<double> basePositionAt(const ContactModel& model, double compliance,
                                                   double force) noexcept;

/// Curve that a lever shows as its base approaches the sample and retracts.
struct ForceCurve {
    std::vector<ForceCurvePoint> approach;
    std::vector<ForceCurvePoint> retract;
    std::optional<TipJump> snapIn;             ///< none: the force has no jump on the way in
    std::optional<TipJump> pullOff;            ///< none: the force has no jump on the way out
    std::optional<ForceCurvePoint> strongest;  ///< none: the law never pulls
};

/// Part of the curve that is followed.
struct ForceCurvePlan {
    double farthest = 0.0;  ///< base position where the curve begins and ends, < 0 [m]
    double deepest = 0.0;   ///< where it turns, > 0 [m]
    int points = 500;       ///< at least 2 along each way, besides the two sides of each jump
};

/// A plan that shows both jumps and a push as strong as the law's strongest pull.
/// @param compliance of the lever along the surface's normal [m/N]
/// @throw Error where that is outside 0 .. 1e6 m/N
[[nodiscard]] ForceCurvePlan curvePlan(const ContactModel& model, double compliance);

/// The quasi-static curve of a law on a lever, with points about equally far apart along the drawn
/// curve, its jumps and the strongest pull among them. Source: docs/theory.md 7.1.
/// @throw Error where the compliance or the plan is outside what a law can follow
[[nodiscard]] ForceCurve forceCurve(const ContactModel& model, double compliance,
                                    const ForceCurvePlan& plan);

}  // namespace asperity
