#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/scene/ModelTerm.h"
#include "core/studies/TradeOffStudy.h"

#include <cstddef>
#include <optional>
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

    /// Returns the resolution of the times measured so far, as a share: half of what the rounds of
    /// an option differ by, and no less than what the next run of the program differs by.
    [[nodiscard]] double timeResolution() const;

    /// Fills in what is known of the reference, and what it leaves out itself.
    void describe(TradeOffReference& reference);

private:
    [[nodiscard]] ModelRun run(const ForceModelOptions& model);
    [[nodiscard]] TickResult resultOf(const ForceModelOptions& options);
    /// Returns the change of the force by a term that the reference lacks, root mean square [N].
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

/// A whole way to run a scene: ticks of one kind at one rate, 1 kHz or more, and pictures of one
/// kind sixty times a second.
struct Composition {
    std::size_t tick = 0;   ///< index in TradeOff::ticks
    std::size_t rate = 0;   ///< in TradeOff::rates
    std::size_t frame = 0;  ///< in TradeOff::frames
    double load = 0.0;      ///< of one core
    /// The larger of two shares: of the force, what tick and rate miss together; of the
    /// indentation, what the picture does.
    double error = 0.0;

    [[nodiscard]] CostAndError costAndError() const { return {load, error}; }
};

/// Returns the Pareto-optimal ones, the cheapest first.
[[nodiscard]] std::vector<Composition> bestCompositions(const TradeOff& study);

/// Returns, of all whose error is at most `tolerance`, the nearest of those that cannot be told
/// from the cheapest.
[[nodiscard]] std::optional<Composition> cheapestComposition(const TradeOff& study,
                                                             double tolerance);

}  // namespace asperity
