#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/scene/Scene.h"

#include <vector>

namespace asperity {

/// By how much the force of a run differs from that of another in all but 3 % of the ticks, as a
/// share of that one's root mean square; of the separate tip, whose forces are faint and felt all
/// the same, as a share of a tenth of that. 0 where there is no force.
[[nodiscard]] double forceShare(const ModelRun& run, const ModelRun& reference);

/// What a part of the model does: the difference between the model with it and without.
struct ModelDifference {
    ModelRun with;
    double effect = 0.0;  ///< of the force, see forceShare()
    double time = 0.0;    ///< that a tick takes longer with it; of this machine [s]
};

/// Short runs over a scene on which its models are compared: approach, slide and retract at the
/// highest feature and at two more places, and lines to and fro around the first. The inputs are
/// those of the scene's usual model; the model that the scene has at first is the reference.
class SampledRuns {
public:
    /// @param scene       must outlive this; its model is changed and left changed
    /// @param longestTick of which somebody would wait for more runs [s]
    /// @param progress    may be null, must outlive this; asked at every tick whether the work is
    ///                    canceled. @throw Canceled, as all that runs a model
    SampledRuns(Scene& scene, double longestTick, const Progress* progress = nullptr);

    /// Whether ticks take longer than that here; then there is one run only, of the usual model.
    [[nodiscard]] bool isSlow() const noexcept { return slow_; }

    /// By how much the force differs from the reference, see forceShare(). Sets the scene's model.
    [[nodiscard]] double error(const ForceModelOptions& model);

    /// The same between two models; times are taken in turns. The scene has the model `with` then.
    [[nodiscard]] ModelDifference between(const ForceModelOptions& with,
                                          const ForceModelOptions& without);

    /// Makes another model the reference. Sets the scene's model.
    void refer(const ForceModelOptions& model);

    /// Median of a tick in the last run [s].
    [[nodiscard]] double tickTime() const { return quantile(last_.times, 0.5); }

    /// The reference, all runs in a row.
    [[nodiscard]] const ModelRun& reference() const noexcept { return reference_; }

private:
    [[nodiscard]] ModelRun runWith(const ForceModelOptions& model) const;

    Scene& scene_;
    const Progress* progress_;
    std::vector<ModelInputs> runs_;
    ForceModelOptions referred_;  ///< of the reference
    ModelRun reference_;
    ModelRun last_;
    bool slow_ = false;
};

}  // namespace asperity
