#pragma once

#include "core/fidelity/FidelityTier.h"
#include "core/haptics/HandPath.h"
#include "core/scene/Scene.h"

#include <vector>

namespace asperity {

/// What one tier costs and how far it is from the reference tier on the same run.
struct TierResult {
    FidelityTier tier;
    bool isReference = false;
    double tickMedian = 0.0;          ///< of one tick [s]
    double tickP99 = 0.0;             ///< [s]
    double patchMedian = 0.0;         ///< of one deformed patch [s]
    double forceErrorRms = 0.0;       ///< of the model force's vector over the run [N]
    double forceErrorMax = 0.0;       ///< [N]
    double contactRadiusError = 0.0;  ///< largest [m]
    double surfaceErrorRms = 0.0;     ///< of the patch's points along z, while bonded [m]
    double surfaceErrorMax = 0.0;     ///< [m]
};

/// How much is measured.
struct TradeOffPlan {
    PathPlan path{.duration = 2.0};
    int rounds = 5;         ///< timed runs of each tier, tiers taking turns
    int patches = 8;        ///< moments of the run at which surfaces are compared
    int patchSamples = 97;  ///< per side of a patch
};

/// Runs the scene's approach path with every tier. Accuracy is taken on the virtual clock and is
/// reproducible; times are of this machine, the tiers interleaved so that they share its mood.
[[nodiscard]] std::vector<TierResult> studyTradeOff(const Scene& scene, const TradeOffPlan& plan);

}  // namespace asperity
