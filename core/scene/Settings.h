#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/scene/CouplingGains.h"
#include "core/scene/GovernorLimits.h"
#include "core/scene/VirtualFixture.h"
#include "core/scene/Workspace.h"

#include <cstdint>

namespace asperity {

/// What the device commands.
enum class PositionControl : std::uint8_t {
    Base,  ///< the cantilever's base; the tip stays behind by the lever's deflection
    Tip,   ///< the tip: the base goes ahead by the deflection that the model expects
};

template <>
inline constexpr auto kEnumTable<PositionControl> = std::to_array<EnumRow<PositionControl>>(
    {{PositionControl::Base, "base"}, {PositionControl::Tip, "tip"}});

/// Knobs that may change from one tick to the next.
struct Settings {
    double positionGain = 1.0;          ///< base displacement per device displacement
    double forceGain = 1.0;             ///< device force per force at the tip
    double correctionBandwidth = 20.0;  ///< of the slow correction from the estimate [Hz]
    PositionControl positionControl = PositionControl::Base;
    CouplingGains coupling;   ///< of the device and what it commands
    GovernorLimits governor;  ///< of the force, where the device renders it
    /// Turn from the device's axes to the world's: along its axis, as long as its angle [rad].
    Vector3 deviceTurn = Vector3::Zero();
    Workspace workspace;           ///< of the device
    bool clutched = false;         ///< the device moves, what it commands stays
    int clutchButton = kNoButton;  ///< that does so while it is held
    int trialButton = kNoButton;   ///< that begins and ends a trial of a study
    VirtualFixture guide;          ///< lengths of the world
    bool forcesOn = true;          ///< false: the operator feels nothing
    std::uint32_t rearms = 0;      ///< how often the operator has reset a fault

    bool operator==(const Settings&) const = default;
};

}  // namespace asperity
