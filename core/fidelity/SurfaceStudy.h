#pragma once

#include "core/fidelity/TradeOffStudy.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"

#include <span>

namespace asperity {

/// Draws contacts of a run with every frame tier and compares each with the reference's patch, a
/// half-space of twice as many pixels a side where that holds, else the closed form. Fills in the
/// frames and the surface's part of the reference.
void studySurfaces(const Scene& scene, std::span<const TipState> states, const TradeOffPlan& plan,
                   TradeOff& result);

}  // namespace asperity
