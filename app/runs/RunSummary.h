#pragma once

#include "app/program/LoadedScene.h"
#include "core/haptics/RunEvents.h"

#include <string>

namespace asperity {

/// summary.json of a run: versions, scene, input and its hash, statistics and events. Depends on
/// the run alone, so that the same run gives the same bytes.
[[nodiscard]] std::string runSummary(const LoadedScene& loaded, const RunEvents& events);

}  // namespace asperity
