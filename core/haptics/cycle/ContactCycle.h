#pragma once

#include "core/Vector.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// How far a cycle has come.
enum class CyclePhase : std::uint8_t {
    Apart,     ///< the tip has not touched yet
    Contact,   ///< it has, and has not come off
    Complete,  ///< it has come off
};

/// A value read from a curve with its standard deviation, in the unit of the value.
struct Reading {
    double value = 0.0;
    double sigma = 0.0;
};

/// What a force-distance curve shows of one cycle: approach, contact, retract, off. Forces are
/// estimates along the normal. Areas are those between curve and axis; the distance may be the
/// separation or the base's: the deflection of an elastic lever adds no area to a closed curve.
/// They are exact for a tip that moves along the normal: over rough ground a slide changes both
/// distances, too.
struct ContactCycle {
    CyclePhase phase = CyclePhase::Apart;
    double touchTime = 0.0;           ///< first tick in contact [s]
    Vector2 place = Vector2::Zero();  ///< of the tip in that tick, world x, y [m]
    double offTime = 0.0;             ///< first tick after it [s]
    /// The tip was in contact when the run began: there is no approach, and its touch is not seen.
    bool fromStart = false;
    Reading maxForce;             ///< repulsive [N]
    double maxIndentation = 0.0;  ///< of the undeformed surface, >= 0 [m]
    /// Strongest pull of the first approach, > 0; none: no pull beyond the noise [N]
    std::optional<Reading> snapIn;
    double snapInSeparation = 0.0;    ///< where that was [m]
    double snapInBaseDistance = 0.0;  ///< gap that the undeflected tip had there [m]
    /// Strongest pull of the last retract branch, > 0; none: no pull beyond the noise [N]
    std::optional<Reading> pullOff;
    double pullOffSeparation = 0.0;    ///< where that was [m]
    double pullOffBaseDistance = 0.0;  ///< [m]
    /// Work of adhesion: area between the last retract branch and zero force, where it pulls [J]
    double adhesionWork = 0.0;
    double hysteresis = 0.0;  ///< area between approach and retract so far [J]
    /// Standard deviation of both areas: noise of the force, and ticks too few for its jumps [J]
    double areaSigma = 0.0;
    bool slid = false;  ///< tip or base moved sideways in contact: the curves are not of one place
    /// Contact stiffness at the beginning of unloading; none: no such branch, or the contact is
    /// stiffer than the lever can tell [N/m]
    std::optional<Reading> stiffness;

    [[nodiscard]] bool touched() const noexcept { return phase != CyclePhase::Apart; }
    [[nodiscard]] bool complete() const noexcept { return phase == CyclePhase::Complete; }
    /// The energy dissipated. None where approach and retract are no closed loop at one place: the
    /// tip has not come off, slid, or was in contact from the start [J]
    [[nodiscard]] std::optional<Reading> closedHysteresis() const noexcept {
        return complete() && !slid && !fromStart ? std::optional(Reading{hysteresis, areaSigma})
                                                 : std::nullopt;
    }
};

}  // namespace asperity
