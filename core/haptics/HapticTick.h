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
    Vector3 hand = Vector3::Zero();        ///< its position in the last tick [m]
    bool started = false;                  ///< false: `base` and `hand` hold nothing yet
    Fault fault = Fault::None;             ///< latched
    std::uint32_t rearms = 0;              ///< as the last tick's settings had them
};

/// Where the hand sends the cantilever's base in this tick, and how fast it moves there. The base
/// follows the hand's displacements times the gain, so that a changed gain moves nothing by itself.
[[nodiscard]] BaseMotion commandBase(const HandState& hand, const Settings& settings,
                                     double timeStep, const TickMemory& memory) noexcept;

/// One tick of the haptic loop: a pure function, so that a recorded run replays to the same bits.
/// The measurement in `input` must answer the base that commandBase() gives for the same hand.
/// No allocation, no lock, no log, no exception.
[[nodiscard]] TickOutput tick(const Scene& scene, const TickInput& input,
                              TickMemory& memory) noexcept;

}  // namespace asperity
