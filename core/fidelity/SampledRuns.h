#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/fidelity/SampledCycle.h"
#include "core/scene/ForceModelOptions.h"
#include "core/scene/JudgedQuantity.h"

#include <list>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

struct Scene;

/// What a model makes of the sampled runs and cycles of a scene.
struct ModelSample {
    ForceModelOptions model;  ///< as ofForce() has it
    ModelRun run;             ///< all runs in a row
    double tickTime = 0.0;    ///< median of a tick in them; of this machine [s]
    std::vector<std::optional<SampledCycle>> cycles;  ///< a place each, see sampleCycle()
};

/// Runs and cycles over a scene on which its models are compared. Runs: approach, slide and retract
/// at the highest feature and, half and a quarter as deep, at two more places, and lines to and fro
/// around the first; the inputs are those of the scene's usual model. Cycles to the scene's
/// setpoint: at sampledPlaces().
class SampledRuns {
public:
    /// @param scene       must outlive this; its model is changed and left changed
    /// @param longestTick of which somebody would wait for more runs [s]
    /// @param progress    may be null, must outlive this; asked at every tick and cycle whether the
    ///                    work is canceled. @throw Canceled, as all that runs a model
    SampledRuns(Scene& scene, double longestTick, const Progress* progress = nullptr);

    /// Whether ticks take longer than that here; then there is one run only, of the usual model.
    [[nodiscard]] bool isSlow() const noexcept { return slow_; }
    /// Median of a tick of the usual model in the first run [s].
    [[nodiscard]] double usualTickTime() const noexcept { return usualTickTime_; }

    /// What a model makes of them, computed once for each model. Sets the scene's model. Stays
    /// where it is as long as this lives.
    [[nodiscard]] const ModelSample& of(const ForceModelOptions& model);

    /// The error of each quantity, the worst of all runs and cycles. Sets the scene's model.
    [[nodiscard]] QuantityErrors errors(const ForceModelOptions& model,
                                        const ForceModelOptions& reference);

    /// Returns by how much the median tick of one model takes longer than that of another one in
    /// the first run [s]. One comes right after the other: others work on the machine, too. Sets
    /// the scene's model.
    [[nodiscard]] double timeDifference(const ForceModelOptions& one,
                                        const ForceModelOptions& other);

private:
    void addRun(const DevicePath& path);

    Scene& scene_;
    const Progress* progress_;
    std::vector<ModelInputs> runs_;
    std::vector<Vector2> places_;
    std::list<ModelSample> samples_;
    double usualTickTime_ = 0.0;
    bool slow_ = false;
};

/// The error of the force of a run against that of another, see ForceSquares. A tick in which one
/// of them holds the tip and the other does not does not count where those beside it agree: there a
/// jump comes by a fraction of a tick earlier, and only a cycle says by which, see SampledCycle.
[[nodiscard]] double forceShare(std::span<const TipState> run, std::span<const TipState> reference);

}  // namespace asperity
