#pragma once

#include "core/probe/TipEquilibrium.h"
#include "core/studies/TradeOffStudy.h"

#include <span>

namespace asperity {

struct Scene;

/// Draws contacts of a run with every frame option and compares each with a half-space of twice as
/// many pixels a side, at those contacts where that holds. Where it holds at none, the closed form
/// is the reference, and the half-space no option. Fills in the frames and the surface's part of
/// the reference.
/// @param progress may be null  @throw Canceled
void studySurfaces(const Scene& scene, std::span<const TipState> states, const TradeOffPlan& plan,
                   Progress* progress, TradeOff& result);

}  // namespace asperity
