#pragma once

#include "core/Progress.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticTick.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <vector>

namespace asperity {

/// @param progress may be null @throw Canceled
void throwIfCanceled(const Progress* progress);

/// A run of the scene along a path, recorded once, so that several models can work on the same
/// inputs; a tick an element.
struct ModelInputs {
    std::vector<TickInput> inputs;
    std::vector<Vector3> trueForces;  ///< inside the instrument [N]
};

/// @param progress the same  @throw Canceled
[[nodiscard]] ModelInputs recordInputs(const Scene& scene, const DevicePath& path, double duration,
                                       const Progress* progress = nullptr);

/// Results of a model on recorded runs, a tick an element.
struct ModelRun {
    std::vector<TipState> states;    ///< as believed
    std::vector<Vector3> estimates;  ///< from the signals [N]
    std::vector<double> times;       ///< of ticks [s]; of this machine
};

/// Runs the scene's model over the inputs of each run, one after another.
/// @param progress may be null; asked at every tick whether the work is canceled
/// @throw Canceled
[[nodiscard]] ModelRun runModel(const Scene& scene, const std::vector<ModelInputs>& runs,
                                const Progress* progress = nullptr);

/// The largest value of a run's states, at least 0.
template <class Value>
[[nodiscard]] double largestOf(const ModelRun& run, const Value& value) {
    double largest = 0.0;
    for (const TipState& state : run.states) {
        largest = std::max(largest, value(state));
    }
    return largest;
}

/// Difference of forces over a run.
struct ForceDifference {
    double rms = 0.0;            ///< of the vector [N]
    double largest = 0.0;        ///< [N]
    double contactRadius = 0.0;  ///< largest [m]
    double closest = 0.0;        ///< largest, between the main closest points while both touch [m]
};

[[nodiscard]] ForceDifference differenceOf(const ModelRun& run, const ModelRun& reference);

/// Root mean square of the model's force over a run [N].
[[nodiscard]] double forceScale(const ModelRun& run);

/// The value below which a share of the values lies; 0 of none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// Every term that the law of the scene's materials has room for, whatever the scene overrules,
/// solved afresh and with the certified search for contact points. @throw Error as usualModel()
[[nodiscard]] ForceModelOptions wholeModel(const Scene& scene);

/// Returns whether a term can change anything in a scene. The attraction by the body beside a
/// contact cannot where the tip is nowhere blunt on the surface.
[[nodiscard]] bool isInScene(ModelTerm term, const Scene& scene) noexcept;

/// Terms of the force that the sample has and the model has not.
[[nodiscard]] std::vector<ModelTerm> missingTerms(const ForceModelOptions& model,
                                                  const Scene& scene);

/// A model with a term and the same without it; what excludes the term is out of both.
struct TermPair {
    ForceModelOptions with;
    ForceModelOptions without;
};

[[nodiscard]] TermPair pairOf(ModelTerm term, ForceModelOptions model);

}  // namespace asperity
