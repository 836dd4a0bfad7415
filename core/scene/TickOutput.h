#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/probe/ForceDecoupling.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Validity.h"

#include <cstdint>

namespace asperity {

/// Why the device force was switched off; latched until the operator resets it.
enum class Fault : std::uint8_t {
    None,
    NotFinite,       ///< a value of the input or of the result was NaN or infinite
    DeviceLost,      ///< the device was unplugged
    DeviceSilent,    ///< a device that streams sent no report any more
    VelocityTrip,    ///< the device moved faster than a hand does while the force acted
    SolverFailed,    ///< for a while no equilibrium of the tip was found
    InstrumentLost,  ///< the connection to the instrument broke
};

template <>
inline constexpr auto kEnumTable<Fault> = std::to_array<EnumRow<Fault>>(
    {{Fault::None, "none", ""},
     {Fault::NotFinite, "not_finite", "a value was not a number: forces are off"},
     {Fault::DeviceLost, "device_lost", "the hand's device is not there: forces are off"},
     {Fault::DeviceSilent, "device_silent", "the hand's device is silent: forces are off"},
     {Fault::VelocityTrip, "velocity_trip", "the hand was too fast: forces are off"},
     {Fault::SolverFailed, "solver_failed", "no equilibrium of the tip was found: forces are off"},
     {Fault::InstrumentLost, "instrument_lost", "the instrument is not there: forces are off"}});

/// What becomes of the force on its way to the device. A device that only senses knows On, Off,
/// Fault.
enum class ForceState : std::uint8_t {
    Off,       ///< the operator switched it off
    Released,  ///< the dead-man switch is not held
    Clutched,  ///< the device moves and commands nothing: it feels no more than its workspace's
               ///< edge
    Waiting,   ///< until it may come on: little force, and the proxy near the device
    Engaging,  ///< comes on
    On,
    Limited,  ///< on, and more is wanted than device and scene allow
    Fading,   ///< the device has been silent for a moment
    Fault,    ///< off, see TickOutput::fault
};

/// For people; empty where it acts as wanted or a fault says why it does not.
template <>
inline constexpr auto kEnumTable<ForceState> = std::to_array<NamedRow<ForceState>>(
    {{ForceState::Off, "forces off (Esc)"},
     {ForceState::Released, "forces off: hold the dead-man switch"},
     {ForceState::Clutched, "clutch: the hand moves, the tip stays"},
     {ForceState::Waiting, "forces wait until the tip feels little"},
     {ForceState::Engaging, "forces come on"},
     {ForceState::On, ""},
     {ForceState::Limited, "force at its limit"},
     {ForceState::Fading, "forces fade: the hand's device is silent"},
     {ForceState::Fault, ""}});

/// What one tick makes; lab frame.
struct TickOutput {
    BaseMotion base;                        ///< commanded
    TipState model;                         ///< equilibrium of the believed system
    ForceEstimate estimate;                 ///< from the measured signals
    Vector3 tip = Vector3::Zero();          ///< apex, from base and estimated force [m]
    Vector3 deviceForce = Vector3::Zero();  ///< for the device, its axes [N]
    ValidityFlags flags;
    Fault fault = Fault::None;
    ForceState forceState = ForceState::On;

    [[nodiscard]] TipRegion region() const noexcept { return model.contact.region(); }
};
}  // namespace asperity
