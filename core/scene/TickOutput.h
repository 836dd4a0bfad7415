#pragma once

#include "core/Vector.h"
#include "core/probe/ForceDecoupling.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Validity.h"

#include <cstdint>

namespace asperity {

/// Why the force at the hand was switched off; latched until a person takes
/// it back.
enum class Fault : std::uint8_t {
    None,
    NotFinite,       ///< a value of the input or of the result was NaN or infinite
    DeviceLost,      ///< the hand's device was unplugged
    DeviceSilent,    ///< a device that streams sent no report any more
    VelocityTrip,    ///< the hand moved faster than a hand does while the force acted
    SolverFailed,    ///< for a while no equilibrium of the tip was found
    InstrumentLost,  ///< the connection to the instrument broke
};

/// What becomes of the force on its way to the hand. A hand that only senses knows On, Off, Fault.
enum class ForceState : std::uint8_t {
    Off,       ///< a person switched it off
    Released,  ///< the dead-man switch is not held
    Clutched,  ///< the hand moves and commands nothing: it feels no more than its workspace's edge
    Waiting,   ///< until it may come on: little force, and the proxy near the hand
    Engaging,  ///< comes on
    On,
    Limited,  ///< on, and more is wanted than device and scene allow
    Fading,   ///< the device has been silent for a moment
    Fault,    ///< off, see TickOutput::fault
};

/// What one tick makes; lab frame.
struct TickOutput {
    BaseMotion base;                      ///< commanded
    TipState model;                       ///< equilibrium of the believed system
    ForceEstimate estimate;               ///< from the measured signals
    Vector3 tip = Vector3::Zero();        ///< apex, from base and estimated force [m]
    Vector3 handForce = Vector3::Zero();  ///< for the device, its axes [N]
    ValidityFlags flags;
    Fault fault = Fault::None;
    ForceState forceState = ForceState::On;

    [[nodiscard]] TipRegion region() const noexcept { return model.contact.region(); }
};

/// "none" or the reason, e.g. "not_finite".
[[nodiscard]] const char* faultName(Fault fault) noexcept;

}  // namespace asperity
