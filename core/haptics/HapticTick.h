#pragma once

#include "core/Vector.h"
#include "core/haptics/Proxy.h"
#include "core/haptics/governor/ForceGovernor.h"
#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/probe/InnovationMonitor.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"
#include "core/scene/TipValidity.h"
#include "core/scene/Validity.h"

namespace asperity {

struct Scene;

/// State carried from tick to tick (the closest-point cache is separate).
struct TickMemory {
    EquilibriumMemory model;
    Vector3 base = Vector3::Zero();          ///< commanded in the last tick [m]
    Vector3 compensation = Vector3::Zero();  ///< how far the tip was commanded ahead of it [m]
    PositionControl control = PositionControl::Base;  ///< of the last tick
    Vector3 correction = Vector3::Zero();             ///< slow part of estimate minus model [N]
    InnovationMemory innovation;                      ///< what many ticks say of the estimate
    SignalHistory signals;                            ///< by which late answers lose weight
    MappingMemory mapping;
    ProxyMemory proxy;
    GuideMemory guide;
    GovernorMemory governor;
    AsperityMemory asperity;    ///< flags of the topography around the contact
    double unsolved = 0.0;      ///< for how long there has been no equilibrium [s]
    bool started = false;       ///< false: `base` holds nothing yet
    Fault fault = Fault::None;  ///< latched
    std::uint32_t rearms = 0;   ///< as the last tick's settings had them
};

/// Command of the device to the cantilever's base in this tick. The base, or the tip, follows the
/// displacements of the device, or of the proxy that it is coupled to, times the gain, so that a
/// changed gain, coupling, view or control and a clutch move nothing by themselves.
struct BaseCommand {
    BaseMotion base;                         ///< with the velocity that the device gives
    Vector3 compensation = Vector3::Zero();  ///< commanded position of the tip less the base [m]
    bool tipHeld = true;  ///< false: no position of the base can hold the tip where it shall be
    MappingStep device;   ///< the motion to there, and what the workspace does to the device
    GuideStep guide;      ///< what pulled at the proxy
    ProxyStep proxy;      ///< where it went, and the force of the coupling on the device
};

/// With the tip under control, the base goes ahead by the deflection C F that the model expects at
/// the commanded position of the tip. Where the lever would jump from there (between its fold and
/// that of displacement control) the tip cannot be held, and the base keeps its last compensation.
/// @param tracker of the surface that the model believes in: saves time, changes nothing
/// Source: Vogl, Ma, Sitti (2005), direct tip control; docs/theory.md 2.5 (the folds).
[[nodiscard]] BaseCommand commandBase(const Scene& scene, const TickInput& input,
                                      const TickMemory& memory,
                                      ClosestPointTracker& tracker) noexcept;
[[nodiscard]] BaseCommand commandBase(const Scene& scene, const TickInput& input,
                                      const TickMemory& memory) noexcept;

/// One tick of the haptic loop: a pure function, so that a recorded run replays to the same bits.
/// No allocation, no lock, no log, no exception.
/// @param input   its measurement answers the command's base
/// @param command what commandBase() gives for this input and memory
/// @param tracker as in commandBase()
[[nodiscard]] TickOutput tick(const Scene& scene, const TickInput& input,
                              const BaseCommand& command, TickMemory& memory,
                              ClosestPointTracker& tracker) noexcept;
[[nodiscard]] TickOutput tick(const Scene& scene, const TickInput& input,
                              const BaseCommand& command, TickMemory& memory) noexcept;

/// The same where the measurement is known beforehand, as in a recording.
[[nodiscard]] TickOutput tick(const Scene& scene, const TickInput& input, TickMemory& memory,
                              ClosestPointTracker& tracker) noexcept;
[[nodiscard]] TickOutput tick(const Scene& scene, const TickInput& input,
                              TickMemory& memory) noexcept;

/// Returns what model and estimate of a tick do not hold for. @param out with both of them
/// @param memory of the last tick, left to the next
[[nodiscard]] ValidityFlags tickValidity(const Scene& scene, const TickOutput& out,
                                         const InnovationVerdict& verdict,
                                         AsperityMemory& memory) noexcept;

}  // namespace asperity
