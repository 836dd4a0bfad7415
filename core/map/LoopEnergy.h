#pragma once

#include "core/map/Engagement.h"

#include <optional>

namespace asperity {

/// What adhesion dissipates in a cycle [J], of any number of contact points and whatever they do
/// one after the other: area between its way down and its way up, of the force along z over the
/// base, from the setpoint to the pull-off, both without friction. Trapezoids between some 30
/// states of each way. None: the tip stays bonded.
[[nodiscard]] std::optional<double> loopEnergy(VerticalPath& path, const Engagement& engaged);

}  // namespace asperity
