#pragma once

#include "core/Random.h"
#include "core/haptics/bench/VirtualBench.h"

namespace asperity {

/// A person as the operator model has it; lengths are those of the hand and of the screen. Where
/// the numbers come from: docs/experiments.md.
struct OperatorTraits {
    double sightTime = 0.25;    ///< from what the screen shows to a movement that answers it [s]
    double touchTime = 0.15;    ///< likewise from what the hand feels [s]
    double moveTime = 0.05;     ///< of a movement of no difficulty, Fitts' a [s]
    double timePerBit = 0.12;   ///< Fitts' b [s/bit]
    double aimError = 0.05;     ///< standard deviation of a movement's end, of its length
    double acuity = 0.3e-3;     ///< standard deviation of a place seen on the screen [m]
    double depthFactor = 3.0;   ///< by how much that is more along the line of sight
    double hiddenFactor = 3.0;  ///< by how much that is more of a tip that nothing shows
    double leastForce = 0.06;   ///< change of force that the hand notices [N]
    double forceShare = 0.1;    ///< likewise as a share of the force (Weber)
    double tremor = 0.05e-3;    ///< root mean square, each axis [m]
    double tremorRate = 9.0;    ///< [Hz]
    double tolerance = 1.0e-3;  ///< distance on the screen with which the person is content [m]
    double patience = 10.0;     ///< in which the person becomes content with twice as much [s]
    double dwell = 0.3;         ///< for which the tip is looked at before the button is pressed [s]
    double pressTime = 0.2;     ///< from the decision to the button [s]
    ArmImpedance arm = kNormalGrip;
};

/// Somebody: each trait that differs from person to person is drawn around the usual one, with a
/// standard deviation of 20 % (log-normal).
[[nodiscard]] OperatorTraits drawOperator(Random& random);
/// A participant of a study with this seed, from 1.
[[nodiscard]] OperatorTraits operatorOf(std::uint64_t seed, int participant);

}  // namespace asperity
