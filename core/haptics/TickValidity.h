#pragma once

#include "core/probe/InnovationMonitor.h"
#include "core/scene/AsperityValidity.h"
#include "core/scene/TickOutput.h"
#include "core/scene/Validity.h"

namespace asperity {

struct Scene;

/// What model and estimate of a tick do not hold for. @param out with both of them
/// @param memory of the last tick, left to the next
[[nodiscard]] ValidityFlags tickValidity(const Scene& scene, const TickOutput& out,
                                         const InnovationVerdict& verdict,
                                         AsperityMemory& memory) noexcept;

}  // namespace asperity
