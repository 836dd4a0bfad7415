#pragma once

#include "core/probe/OpticalLever.h"

namespace asperity {

/// How much the model says that the signals change.
struct SignalHistory {
    LeverSignals expected;  ///< in the last tick [rad]
    LeverSignals change;    ///< over about the age of the signals, all ways added up [rad]
    bool started = false;
};

/// By how much the signals may differ from those of now, because they were measured `age` ago: all
/// that the model expected to change meanwhile. 0 for signals of now. [rad]
/// @param expected what the model expects of the signals now [rad]
[[nodiscard]] LeverSignals stalenessOf(const LeverSignals& expected, double age, double timeStep,
                                       SignalHistory& memory) noexcept;

/// Signals older than this are flagged, however little the model expects to happen [s].
inline constexpr double kOldSignals = 0.1;

}  // namespace asperity
