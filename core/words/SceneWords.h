#pragma once

#include "core/fidelity/RequiredTerms.h"
#include "core/scene/SceneFields.h"
#include "core/surface/leveling/Leveling.h"

#include <string>
#include <vector>

namespace asperity {

/// Wider pixels are coarse, as a share of the tip's radius or of the width of a view.
inline constexpr double kWidePixel = 1.0 / 3.0;

struct SampleDescription;
struct SampleMaterial;

/// Returns the name of the sample: its file and channel, or its shape.
[[nodiscard]] std::string sampleName(const SampleDescription& sample);

/// The hardness of a material, or what is made of it where it is not stated, in one clause.
[[nodiscard]] std::string hardnessText(const SampleMaterial& material);

/// Returns how much a scan is smoothed and why, in one line: "smoothing: 1.2 pixels, by 30 pm of
/// height noise and a 15 nm tip".
[[nodiscard]] std::string smoothingNote(const Scene& scene);

/// Returns the decisions about the heights of a scene, one sentence each.
[[nodiscard]] std::vector<std::string> surfaceNotes(const Scene& scene);

/// Returns the decisions about its force, one sentence each: the contact law, the model, a hardness
/// that is estimated.
[[nodiscard]] std::vector<std::string> forceNotes(const Scene& scene, const RequiredTerms& needs);

struct Scene;

/// Note for every scan: the contact of a tip with it counts the imaging tip a second time.
inline constexpr const char* kScanHoldsItsTip =
    "the heights hold the shape of the tip that recorded them: bumps are wider, and hollows "
    "narrower and shallower, than on the sample";

/// One sentence on what is known of the tip that recorded the scene's scan, and what was done
/// about its shape.
[[nodiscard]] std::string imagingTipNote(const Scene& scene);

/// The same in a few words.
[[nodiscard]] std::string imagingTipWords(const Scene& scene);

/// Returns the effect of each leveling step on the heights, a sentence each, in order; a sentence
/// where there is no step.
[[nodiscard]] std::vector<std::string> levelingNotes(const std::vector<RemovedByStep>& removed);

/// The value of a key in the unit of its words: "20 nm", "on", "plane, quadratic".
/// @param scene that has it
[[nodiscard]] std::string valueText(const SceneField& field, const SceneDescription& scene);

/// Returns the name of a change of a key: "Tip radius: 20 nm", "Leveling: plane, quadratic".
/// @param scene that has the new value
[[nodiscard]] std::string changeText(const SceneField& field, const SceneDescription& scene);

}  // namespace asperity
