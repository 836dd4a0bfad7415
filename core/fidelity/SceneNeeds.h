#pragma once

#include "core/Progress.h"
#include "core/fidelity/SurfaceNeeds.h"
#include "core/scene/JudgedQuantity.h"
#include "core/scene/ModelTerm.h"

#include <cmath>
#include <optional>
#include <vector>

namespace asperity {

struct Scene;

/// The error to two digits, the next larger ones; >= 0.
[[nodiscard]] inline double roundedUp(double error) noexcept {
    constexpr double kRounding = 1e-9;  // of binary numbers: 0.054 is 0.054
    if (!(error > 0.0)) {
        return 0.0;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(error)) - 1.0);
    return std::ceil((error / unit) - kRounding) * unit;
}

/// The quantities of a scene and a run of it that decide about a term, see factOf().
struct TermFact {
    double amount = 0.0;
    double other = 0.0;

    bool operator==(const TermFact&) const = default;
};

/// What one term of the model is worth in a scene.
struct TermNeed {
    ModelTerm term = ModelTerm::Adhesion;
    bool on = true;
    bool overruled = false;        ///< the scene says so itself
    bool possible = true;          ///< false: the sample has nothing to put in
    std::optional<TermFact> fact;  ///< none: of the surface, not possible, or not measured
    /// What leaving it out of the model changes that has it and all terms that it does not exclude:
    /// the quantity that changes most, see QuantityErrors and SampledRuns; of terms of the surface
    /// its displacement, as a share of the indentation.
    double effect = 0.0;
    JudgedQuantity quantity = JudgedQuantity::PullOffForce;  ///< that; of terms of the force
    double time = 0.0;  ///< that it costs a tick, or a patch, likewise; of this machine [s]
};

/// What a scene requires of its model.
struct SceneNeeds {
    std::vector<TermNeed> terms;  ///< in the order of kModelTerms
    ForceModelOptions full;       ///< with every term that can be in
    ForceModelOptions model;      ///< with those that matter
    double tolerance = 0.0;       ///< of each quantity and of indentations, as a share
    double setpoint = 0.0;        ///< of the force curves on which terms are judged [N]
    bool pending = false;         ///< all that follows, and what a term is worth, is not known yet
    QuantityErrors modelErrors;   ///< of `model` against `full`, as TermNeed::effect
    bool measured = false;        ///< whether the next three are known
    QuantityErrors wholeErrors;   ///< of `model` against the whole, which no scene can overrule
    QuantityErrors lawErrors;     ///< of the whole: terms that its law has no room for
    std::vector<ModelTerm> lawMisses;  ///< those of them that change a quantity
    double fullTick = 0.0;             ///< median of a tick with everything [s]
    double modelTick = 0.0;            ///< and of one with what matters [s]
    SurfaceNeeds surface;              ///< once `measured`

    /// Of `model` against what a user would read if a contact law had every term.
    [[nodiscard]] QuantityErrors totalErrors() const {
        QuantityErrors total = wholeErrors;
        total.add(lawErrors);
        return total;
    }
    /// Their worst, as a user is told: rounded up to two digits, more than which the positions and
    /// steps of the samples do not hold.
    [[nodiscard]] double statedError() const { return roundedUp(totalErrors().worst()); }
};

/// What is known of a scene before its model is fitted: that has everything.
[[nodiscard]] SceneNeeds needsBeforeFit(const Scene& scene);

inline constexpr double kLongestTick = 1e-3;  ///< of scenes whose model is fitted [s]

/// Finds the terms that change any of the judged quantities, or displacements, by more than the
/// scene's tolerance, and gives the scene the model of these alone, and its error.
///
/// On sampled runs and cycles (SampledRuns) it leaves out one term after another, the least effect
/// first, as long as each alone and all together stay within the tolerance in every quantity. Terms
/// that the description settles stay as they are. The search for other closest points stays
/// wherever the scan has a hollow that the tip does not fit, whatever the runs meet. The error is
/// that of the model against the whole model (wholeModel(), under the law that leaves out least),
/// and that of the whole by each term that its law has no room for, weighed by the same pairs of
/// models as in TickStudy and added as squares. Decisions are reproducible, times
/// are of this machine. Where a tick takes longer than `longestTick` [s] everything is left on.
/// @param progress may be null @throw Error as setModel(); Canceled: the scene's model is any then
SceneNeeds fitModel(Scene& scene, double longestTick = kLongestTick, Progress* progress = nullptr);

}  // namespace asperity
