#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/scene/ModelTerm.h"
#include "core/studies/TradeOffStudy.h"

#include <vector>

namespace asperity {

/// Measures models for a tick on the same recorded inputs. The reference has every term that a law
/// has room for, whatever the scene overrules: the law of its materials, afresh, with certified
/// closest points; the film's where its base matters more than adhesion; the exact sphere's where
/// contacts are wider than 0.3 tip radii and the sample is about flat.
class TickStudy {
public:
    /// @param scene    has its model changed
    /// @param progress may be null  @throw Canceled, there and in all that runs
    TickStudy(Scene& scene, const TradeOffPlan& plan, Progress* progress);

    [[nodiscard]] const ForceModelOptions& model() const { return model_; }  ///< of the reference
    [[nodiscard]] const ModelRun& reference() const { return reference_; }

    /// The models, taking turns.
    [[nodiscard]] std::vector<TickResult> measured(const std::vector<ForceModelOptions>& models);

    /// Of the times measured so far, as a share: half of what the rounds of an option differ by,
    /// and no less than what the next run of the program differs by.
    [[nodiscard]] double timeResolution() const;

    /// Fills in what is known of the reference, and what it leaves out itself.
    void describe(TradeOffReference& reference);

private:
    [[nodiscard]] ModelRun run(const ForceModelOptions& model);
    [[nodiscard]] TickResult resultOf(const ForceModelOptions& options);
    /// What a term moves the force by that the reference has no room for, root mean square [N].
    [[nodiscard]] double missedBy(ModelTerm term);
    void chooseReference();

    Scene& scene_;
    TradeOffPlan plan_;
    Progress* progress_;
    ForceModelOptions model_;
    std::vector<ModelInputs> runs_;
    ModelRun reference_;
    std::vector<double> spreads_;  ///< of each option's rounds
};

}  // namespace asperity
