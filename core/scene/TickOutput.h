#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/probe/ForceDecoupling.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Validity.h"

#include <cstdint>

namespace asperity {

/// Reason why the device force was switched off; latched until the operator resets it.
enum class Fault : std::uint8_t {
    None,
    NotFinite,       ///< a value of the input or of the result was NaN or infinite
    DeviceLost,      ///< the device was unplugged
    DeviceSilent,    ///< a device that streams sent no report any more
    VelocityTrip,    ///< the device moved faster than a hand does while the force acted
    SolverFailed,    ///< for a while no equilibrium of the tip was found
    InstrumentLost,  ///< the connection to the instrument broke
    RecordEnded,     ///< the base went deeper than the curve that the instrument plays
};

template <>
inline constexpr auto kEnumTable<Fault> = std::to_array<EnumRow<Fault>>(
    {{Fault::None, "none", ""},
     {Fault::NotFinite, "not_finite", "value not finite: forces switched off"},
     {Fault::DeviceLost, "device_lost", "device not connected: forces switched off"},
     {Fault::DeviceSilent, "device_silent", "no reports from the device: forces switched off"},
     {Fault::VelocityTrip, "velocity_trip", "device too fast: forces switched off"},
     {Fault::SolverFailed, "solver_failed", "equilibrium not found: forces switched off"},
     {Fault::InstrumentLost, "instrument_lost", "instrument not connected: forces switched off"},
     {Fault::RecordEnded, "record_ended", "below the recorded curve: forces switched off"}});

/// State of the force on its way to the device. A device that only senses knows On, Off, Fault.
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

/// Texts for people; empty where it acts as wanted or a fault says why it does not.
template <>
inline constexpr auto kEnumTable<ForceState> = std::to_array<NamedRow<ForceState>>(
    {{ForceState::Off, "forces off"},
     {ForceState::Released, "forces off: hold the dead-man switch"},
     {ForceState::Clutched, "clutch: device moves, tip stays"},
     {ForceState::Waiting, "forces wait for a small tip force"},
     {ForceState::Engaging, "forces ramp up"},
     {ForceState::On, ""},
     {ForceState::Limited, "force at its limit"},
     {ForceState::Fading, "forces fade: device silent"},
     {ForceState::Fault, ""}});

/// Result of one tick; lab frame.
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
