#pragma once

#include "core/studies/extremes/HoldOutcome.h"
#include "vtkplugins/pictures/ShareMaps.h"

#include <vector>

namespace asperity {

/// What becomes of a device with and without a coupling, over the loop's rate: by the delay and by
/// the decade of the contact's stiffness at the device.
[[nodiscard]] ShareMapPage couplingMap(const std::vector<HoldOutcome>& holds);

}  // namespace asperity
