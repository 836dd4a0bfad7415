#pragma once

#include "core/ShareOut.h"
#include "core/scene/SceneDescription.h"
#include "core/studies/extremes/ExtremesStudy.h"

namespace asperity {

/// The materials of tickMaterials(), each with and without its adhesion.
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
