#pragma once

#include "core/surface/leveling/Leveling.h"

#include <string>
#include <vector>

namespace asperity {

/// What each leveling step did to the heights, a sentence each, in order; a sentence where there is
/// no step.
[[nodiscard]] std::vector<std::string> levelingNotes(const std::vector<RemovedByStep>& removed);

}  // namespace asperity
