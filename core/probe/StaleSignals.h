#pragma once

#include "core/probe/OpticalLever.h"

namespace asperity {

/// How fast the model says that the signals change.
struct SignalHistory {
    LeverSignals expected;  ///< in the last tick [rad]
    LeverSignals rate;      ///< fastest over about the age of the signals [rad/s]
    bool started = false;
};

/// By how much the signals may differ from those of now, because they were measured `age` ago: the
/// fastest change that the model expected meanwhile, over that time. 0 for signals of now. [rad]
/// @param expected what the model expects of the signals now [rad]
[[nodiscard]] LeverSignals stalenessOf(const LeverSignals& expected, double age, double timeStep,
                                       SignalHistory& memory) noexcept;

/// Signals older than this are flagged, however little the model expects to happen [s].
inline constexpr double kOldSignals = 0.1;

}  // namespace asperity
