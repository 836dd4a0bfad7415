#pragma once

#include "core/Vector.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"

namespace asperity {

/// All that one tick hands to the next.
struct TickMemory {
    EquilibriumMemory model;
    Vector3 base = Vector3::Zero();        ///< commanded in the last tick [m]
    Vector3 correction = Vector3::Zero();  ///< slow part of estimate minus model [N]
    bool started = false;                  ///< false: `base` holds nothing yet
    Fault fault = Fault::None;             ///< latched
};

/// Where the hand sends the cantilever's base in this tick, and how fast it moves there.
[[nodiscard]] BaseMotion commandBase(const HandState& hand, const Settings& settings,
                                     double timeStep, const TickMemory& memory) noexcept;

/// One tick of the haptic loop: a pure function, so that a recorded run replays to the same bits.
/// The measurement in `input` must answer the base that commandBase() gives for the same hand.
/// No allocation, no lock, no log, no exception.
[[nodiscard]] TickOutput tick(const Scene& scene, const TickInput& input,
                              TickMemory& memory) noexcept;

}  // namespace asperity
