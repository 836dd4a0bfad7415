#pragma once

#include "core/fidelity/SceneNeeds.h"

#include <string>
#include <vector>

namespace asperity {

/// Wider pixels are coarse, as a share of the tip's radius or of the width of a view.
inline constexpr double kWidePixel = 1.0 / 3.0;

struct SampleDescription;
struct SampleMaterial;

/// What the sample is: its file and channel, or its shape.
[[nodiscard]] std::string sampleName(const SampleDescription& sample);

/// The hardness of a material, or what is made of it where it is not stated, in one clause.
[[nodiscard]] std::string hardnessText(const SampleMaterial& material);

/// By how much a scan is smoothed and why, in one line: "smoothing: 1.2 pixels, by 30 pm of height
/// noise and a 15 nm tip".
[[nodiscard]] std::string smoothingNote(const Scene& scene);

/// What was decided about the heights of a scene, one sentence each.
[[nodiscard]] std::vector<std::string> surfaceNotes(const Scene& scene);

/// What was decided about its force, one sentence each: the contact law, the model, a hardness that
/// is estimated.
[[nodiscard]] std::vector<std::string> forceNotes(const Scene& scene, const SceneNeeds& needs);

}  // namespace asperity
