#pragma once

#include "core/ShareOut.h"
#include "core/scene/SceneDescription.h"
#include "core/studies/extremes/ExtremesStudy.h"

namespace asperity {

/// The materials of the tick's runs: soft and wide, adhesive, stiff; silicone rubber, polystyrene,
/// silicon oxide. Source: Vogl, Ma, Sitti (2005), table 1.
[[nodiscard]] std::vector<SampleMaterial> tickMaterials();

/// A tip on a random rough surface.
struct RoughPlace {
    double tipRadius = 0.0;  ///< [m]
    double roughness = 0.0;  ///< rms height over tip radius
};

/// Runs of the whole tick with a scripted device, with every effort of the closest point search;
/// the reference is the certified search where it proves its closest points. The device does not
/// give way, so that neither the loop's rate nor the force gain changes a state: both are the
/// scene's.
/// @throw Canceled
[[nodiscard]] ExtremesFindings tickExtremes(const TickGrid& grid, const RoughPlace& place,
                                            const CancelCheck& check);

}  // namespace asperity
