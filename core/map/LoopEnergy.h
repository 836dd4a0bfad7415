#pragma once

#include "core/map/Engagement.h"
#include "core/map/RetractCurve.h"

namespace asperity {

/// What a cycle dissipates [J]: area between its way down and its way up, of the force along z over
/// the base, from the setpoint to the pull-off. Of any number of contact points, and whatever they
/// do one after the other; friction is in it. Trapezoids between some 30 states of each way.
[[nodiscard]] double loopEnergy(VerticalPath& path, const Engagement& engaged,
                                const RetractCurve& curve);

}  // namespace asperity
