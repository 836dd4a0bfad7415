#pragma once

#include "core/probe/InnovationMonitor.h"
#include "core/scene/Scene.h"
#include "core/scene/TickOutput.h"
#include "core/scene/Validity.h"

namespace asperity {

/// What model and estimate of a tick do not hold for. @param out with both of them
[[nodiscard]] ValidityFlags tickValidity(const Scene& scene, const TickOutput& out,
                                         const InnovationVerdict& verdict) noexcept;

}  // namespace asperity
