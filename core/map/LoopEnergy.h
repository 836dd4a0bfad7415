#pragma once

#include "core/map/Engagement.h"
#include "core/map/RetractCurve.h"

namespace asperity {

/// What snap-in and pull-off dissipate [J]: area between the bonded and the free branch of the
/// force along z over the base, from the one jump to the other. Of any number of contact points;
/// trapezoids between the states of the retract. Friction, which makes the way up another one than
/// the way down, is in it as far as it acts between the jumps.
[[nodiscard]] double loopEnergy(VerticalPath& path, const FoundJump& snapIn,
                                const RetractCurve& curve);

}  // namespace asperity
