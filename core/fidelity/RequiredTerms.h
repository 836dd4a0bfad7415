#pragma once

#include "core/Progress.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/fidelity/ModelRun.h"
#include "core/scene/JudgedQuantity.h"
#include "core/scene/ModelTerm.h"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

struct Scene;

/// Differences between the models of the deformed surface in a scene: root mean squares over the
/// patches of some contacts, as shares of their indentation.
struct SurfaceNeeds {
    bool touches = false;         ///< whether any of the states was a contact
    bool halfSpaceHolds = false;  ///< at all states that were looked at
    HalfSpaceAnswer deepest;      ///< what the half-space says of itself at the deepest
    double outside = 0.0;         ///< contact radius from closed form
    double halfSpace = 0.0;       ///< closed form from half-space; 0 where that does not hold
    double outsideTime = 0.0;     ///< that the closed form takes longer than the contact radius [s]
    double halfSpaceTime = 0.0;   ///< that a solution of the half-space takes [s]
};

/// Looks at the states with the largest forces.
/// @param progress may be null @throw Canceled
[[nodiscard]] SurfaceNeeds surfaceNeedsOf(const Scene& scene, std::span<const TipState> states,
                                          Progress* progress = nullptr);

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

/// Worth of one term of the model in a scene.
struct TermNeed {
    ModelTerm term = ModelTerm::Adhesion;
    bool on = true;
    bool overruled = false;        ///< the scene says so itself
    bool possible = true;          ///< false: the sample has nothing to put in
    std::optional<TermFact> fact;  ///< none: of the surface, not possible, or not measured
    /// Effect of leaving it out of the model that has it and all terms that it does not exclude:
    /// change of the quantity that changes most, see QuantityErrors and SampledRuns; of terms of
    /// the surface that of its displacement, as a share of the indentation.
    double effect = 0.0;
    JudgedQuantity quantity = JudgedQuantity::PullOffForce;  ///< that; of terms of the force
    double time = 0.0;  ///< that it costs a tick, or a patch; of this machine [s]
};

/// Requirements of a scene on its model.
struct RequiredTerms {
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

    /// Returns the errors of `model` against what a user would read with every term in the law.
    [[nodiscard]] QuantityErrors totalErrors() const {
        QuantityErrors total = wholeErrors;
        total.add(lawErrors);
        return total;
    }
    /// Their worst, as a user is told: rounded up to two digits, more than which the positions and
    /// steps of the samples do not hold.
    [[nodiscard]] double statedError() const { return roundedUp(totalErrors().worst()); }
};

/// Returns what is known of a scene before its model is fitted: that has everything.
[[nodiscard]] RequiredTerms needsBeforeFit(const Scene& scene);

inline constexpr double kLongestTick = 1e-3;  ///< of scenes whose model is fitted [s]

/// Finds the terms that change any of the judged quantities, or displacements, by more than the
/// scene's tolerance, and gives the scene the model of these alone, and its error.
///
/// On sampled runs and cycles (SampledRuns) it leaves out one term after another, the least effect
/// first, as long as each alone and all together stay within the tolerance in every quantity. Terms
/// that the description settles stay as they are. The search for other closest points stays
/// wherever the scan has a hollow that the tip does not fit, whatever the runs meet; relaxation and
/// drag stay where the sample has them, whose effect depends on how fast a hand is. The error is
/// that of the model against the whole model (wholeModel(), under the law that leaves out least),
/// and that of the whole by each term that its law has no room for, weighed by the same pairs of
/// models as in TickStudy and added as squares. Decisions are reproducible, times
/// are of this machine. Where a tick takes longer than `longestTick` [s] everything is left on.
/// @param progress may be null @throw Error as setModel(); Canceled: the scene's model is any then
RequiredTerms fitModel(Scene& scene, double longestTick = kLongestTick,
                       Progress* progress = nullptr);

/// Returns the properties of a scene and a run of it that matter for a term of the force:
///
/// - adhesion: the largest pull and the largest push at the tip [N];
/// - van der Waals tail: the transition parameter;
/// - exact sphere, film's base: the widest contact, in tip radii and in film thicknesses;
/// - curvature of the sample, global search: the largest of sample and of hollows over the tip's;
///   infinite for the search on a shape, which may come near at several positions;
/// - body attraction: the largest force of it [N];
/// - work on retract: over that on approach;
/// - relaxation: how much stiffer the sample is at once, and its time [s];
/// - drag: in contact [N s/m];
/// - friction: coefficient and shear strength [Pa];
/// - torsion: how the tip yields across the lever, over its yielding along z;
/// - tilt: of the mount [rad].
/// @param scene has the model of the run, the term in
[[nodiscard]] TermFact factOf(ModelTerm term, const Scene& scene, const ModelRun& run);

}  // namespace asperity
