#pragma once

#include "core/studies/TradeOffStudy.h"

#include <vector>

namespace asperity {

struct Scene;

/// The scene's approach at tick rates from 250 Hz to 8 kHz, each against twice the highest: what a
/// force misses that is held from tick to tick.
/// @param scene    has its rate changed
/// @param progress may be null  @throw Canceled
[[nodiscard]] std::vector<RateResult> studyRates(Scene& scene, double duration,
                                                 const Progress* progress);

}  // namespace asperity
