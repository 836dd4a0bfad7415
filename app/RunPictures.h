#pragma once

#include "app/RunCurves.h"
#include "core/haptics/RunEvents.h"
#include "core/scene/Scene.h"

#include <filesystem>

namespace asperity {

/// Draws what a run did into `folder`: deformation.png (largest indentation, and the adhesion neck
/// where there was one), overview.png, forces.png; and writes deformation.exr, the deformed surface
/// at the largest indentation. @throw Error
void writeRunPictures(const std::filesystem::path& folder, const Scene& scene,
                      const RunEvents& events, const RunCurves& curves);

}  // namespace asperity
