#pragma once

#include "core/haptics/coupling/CoupledDevice.h"

#include <string>

namespace asperity {

/// "1 mm : 1 nm, 1 N : 10 nN; the hand feels 247 N/m of 1.4 kN/m", the latter that of the contact.
[[nodiscard]] std::string feltWords(const DeviceScale& scale, const ScaleJudgment& judgment);

/// What of a scale is too much and the remedy, in one sentence with the numbers; empty: it holds.
[[nodiscard]] std::string refusalOf(const ScaleJudgment& judgment);

/// Why a device cannot drive the tip, likewise.
[[nodiscard]] std::string refusalOf(const CoupledDevice& device);

}  // namespace asperity
