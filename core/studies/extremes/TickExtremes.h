#pragma once

#include "core/ShareOut.h"
#include "core/scene/SceneDescription.h"
#include "core/studies/extremes/ExtremesStudy.h"

namespace asperity {

/// The materials of the tick's runs: soft and wide, adhesive, stiff; silicone rubber, polystyrene,
/// silicon oxide. Source: Vogl, Ma, Sitti (2005), table 1. Then the rubber with two works of
/// adhesion, and a gel that relaxes.
[[nodiscard]] std::vector<SampleMaterial> tickMaterials();

/// A tip on a random rough surface.
struct RoughSample {
    double tipRadius = 0.0;  ///< [m]
    double roughness = 0.0;  ///< rms height over tip radius
};

/// Runs of the whole tick with a scripted device, with every effort of the closest point search;
/// the reference is the certified search where it proves its closest points. The device does not
/// give way, so that neither the loop's rate nor the force gain changes a state: both are the
/// scene's.
/// @throw Canceled
[[nodiscard]] ExtremesFindings tickExtremes(const TickGrid& grid, const RoughSample& sample,
                                            const CancelCheck& check);

/// The first three of tickMaterials(), each with and without its adhesion.
[[nodiscard]] std::vector<SampleMaterial> holdMaterials();

/// A sample under a lever, asked at one rate.
struct HoldBench {
    SampleMaterial material;
    double leverStiffness = 0.0;  ///< [N/m]
    double tickRate = 0.0;        ///< [Hz]
    long first = 0;               ///< of the grid's settings; the others follow
};

/// All of the grid, highest rates first.
[[nodiscard]] std::vector<HoldBench> benchesOf(const CouplingGrid& grid);

/// Operators at one device of the Phantom class on one bench: what designCoupling() and
/// judgeScale() refuse is not tried; all else, and every device without a coupling, is put on the
/// virtual bench. The contact's stiffness that the guard is asked about is that under the device's
/// largest force.
/// @throw Canceled
[[nodiscard]] ExtremesFindings couplingExtremes(const CouplingGrid& grid, const HoldBench& bench,
                                                const CancelCheck& check);

}  // namespace asperity
