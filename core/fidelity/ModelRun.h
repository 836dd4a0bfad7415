#pragma once

#include "core/Progress.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticTick.h"

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

/// @param progress likewise  @throw Canceled
[[nodiscard]] ModelInputs recordInputs(const Scene& scene, const DevicePath& path, double duration,
                                       const Progress* progress = nullptr);

/// What a model made of recorded runs, a tick an element.
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

/// By how much forces differ over a run.
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

}  // namespace asperity
