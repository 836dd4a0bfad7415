#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/scene/Scene.h"

#include <vector>

namespace asperity {

/// Short runs over a scene on which its models are compared: approach, slide and retract at the
/// highest feature and at two more places, and lines to and fro around the first. The inputs are
/// those of the scene's usual model; the model that the scene has at first is the reference.
class SampledRuns {
public:
    /// @param scene must outlive this; its model is changed and left changed
    explicit SampledRuns(Scene& scene);

    /// Whether ticks are so slow here that nobody would wait for more runs.
    [[nodiscard]] bool isSlow() const noexcept { return slow_; }

    /// By how much the force differs from the reference in all but 3 % of the ticks, as a share of
    /// the reference's root mean square; of the separate tip, whose forces are faint and felt all
    /// the same, as a share of a tenth of that. 0 where there is no force. Sets the scene's model.
    [[nodiscard]] double error(const SceneModel& model);

    /// The same between two models, as a share of the reference's force.
    [[nodiscard]] double difference(const SceneModel& a, const SceneModel& b);

    /// Makes another model the reference. Sets the scene's model.
    void refer(const SceneModel& model);

    /// Median of a tick in the last run [s].
    [[nodiscard]] double tickTime() const { return quantile(last_.times, 0.5); }

    /// The reference, all runs in a row.
    [[nodiscard]] const ModelRun& reference() const noexcept { return reference_; }

private:
    [[nodiscard]] ModelRun runWith(const SceneModel& model) const;
    [[nodiscard]] double share(const ModelRun& a, const ModelRun& b) const;

    Scene& scene_;
    std::vector<RecordedRun> runs_;
    ModelRun reference_;
    ModelRun last_;
    bool slow_ = false;
};

}  // namespace asperity
