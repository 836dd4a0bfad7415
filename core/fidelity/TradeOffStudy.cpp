#include "core/fidelity/TradeOffStudy.h"

#include "core/fidelity/ModelRun.h"
#include "core/fidelity/RateStudy.h"
#include "core/fidelity/SurfaceStudy.h"
#include "core/scene/ModelTerm.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Beyond this contact radius over tip radius the exact sphere is the reference.
constexpr double kLargeContact = 0.3;
constexpr double kP99 = 0.99;

double largestContactRatio(const ModelRun& run) {
    double largest = 0.0;
    for (const TipState& state : run.states) {
        largest = std::max(largest, state.contactRatio);
    }
    return largest;
}

bool isCurved(const ModelRun& run) {
    return std::ranges::any_of(run.states, [](const TipState& state) {
        return state.contact.contactRadius > 0.0 && state.radiusIsRough;
    });
}

double estimateError(const ModelRun& run, const std::vector<RecordedRun>& runs) {
    double sum = 0.0;
    std::size_t at = 0;
    for (const RecordedRun& recorded : runs) {
        for (const Vector3& force : recorded.trueForces) {
            sum += (run.estimates[at++] - force).squaredNorm();
        }
    }
    return std::sqrt(sum / static_cast<double>(at));
}

/// The scene's usual law afresh, on the exact sphere where contacts are wide.
class TickStudy {
public:
    TickStudy(Scene& scene, const TradeOffPlan& plan) : scene_(scene), model_(scene.model) {
        record(approachPath(scene, {.duration = plan.duration}), plan);
        const Vector2 other(0.31 * scene.surface.sizeX(), 0.62 * scene.surface.sizeY());
        record(rasterPath(scene, {.duration = plan.duration, .place = other}), plan);
        model_.law = chooseLaw(std::nullopt, scene.belief.contact.pair());
        if (scene.belief.contact.filmThickness() > 0.0) {
            model_.law.law = ContactLaw::HertzFilm;
        }
        model_ = modelWithTier(model_, {.law = model_.law.law,
                                        .solver = SolverTier::Exact,
                                        .footSearch = FootEffort::Certified});
        reference_ = run(model_);
        const SceneModel sphere = with(model_, ModelTerm::SphereCorrection);
        if (largestContactRatio(reference_) > kLargeContact) {
            // That law takes the sample as flat: nothing to hold on to where it is not.
            if (ModelRun exact = run(sphere); !isCurved(exact)) {
                model_ = sphere;
                reference_ = std::move(exact);
            }
        }
    }

    [[nodiscard]] const SceneModel& model() const { return model_; }
    [[nodiscard]] const ModelRun& reference() const { return reference_; }

    /// The tiers, taking turns.
    [[nodiscard]] std::vector<TickResult> measured(const std::vector<TickTier>& tiers, int rounds) {
        std::vector<TickResult> results;
        std::vector<std::vector<double>> times(tiers.size());
        for (const TickTier& tier : tiers) {
            results.push_back(resultOf(tier));
        }
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < tiers.size(); ++i) {
                const ModelRun timed = run(modelWithTier(model_, tiers[i]));
                times[i].insert(times[i].end(), timed.times.begin(), timed.times.end());
            }
        }
        for (std::size_t i = 0; i < results.size(); ++i) {
            results[i].median = quantile(times[i], 0.5);
            results[i].p99 = quantile(times[i], kP99);
        }
        return results;
    }

    /// What the reference leaves out itself.
    void doubt(TradeOffReference& reference) {
        const SceneModel sphere = with(model_, ModelTerm::SphereCorrection);
        if (!isSphere(model_.law.law) && isSphere(sphere.law.law)) {
            const SceneModel paraboloid =
                without(without(sphere, ModelTerm::SphereCorrection), ModelTerm::SampleCurvature);
            reference.forceDoubt = differenceOf(run(paraboloid), run(sphere)).rms;
            reference.forceDoubtBy = "the paraboloid against the exact sphere, as on a flat sample";
            return;
        }
        const SceneModel paraboloid = without(model_, ModelTerm::SphereCorrection);
        const SceneModel tail = with(paraboloid, ModelTerm::VanDerWaalsTail);
        if (has(paraboloid, ModelTerm::Adhesion)) {
            reference.forceDoubt = differenceOf(run(paraboloid), run(tail)).rms;
            reference.forceDoubtBy =
                "no law of the exact sphere has a tail: with and without it on "
                "the paraboloid";
            return;
        }
        reference.forceDoubtBy = "nothing finer is known";
    }

private:
    void record(const HandPath& path, const TradeOffPlan& plan) {
        runs_.push_back(recordRun(scene_, path, plan.duration));
    }

    [[nodiscard]] ModelRun run(const SceneModel& model) {
        setModel(scene_, model);
        return runModel(scene_, runs_);
    }

    [[nodiscard]] TickResult resultOf(const TickTier& tier) {
        const ModelRun done = run(modelWithTier(model_, tier));
        const ForceDifference difference = differenceOf(done, reference_);
        return {.tier = tier,
                .forceErrorRms = difference.rms,
                .forceErrorMax = difference.largest,
                .contactRadiusError = difference.contactRadius,
                .footError = difference.foot,
                .estimateErrorRms = estimateError(done, runs_)};
    }

    Scene& scene_;
    SceneModel model_;  ///< of the reference
    std::vector<RecordedRun> runs_;
    ModelRun reference_;
};

}  // namespace

TradeOff studyTradeOff(Scene& scene, const TradeOffPlan& plan) {
    const SceneModel before = scene.model;
    TickStudy ticks(scene, plan);
    TradeOff result;
    result.ticks = ticks.measured(tickTiers(scene), plan.rounds);
    TickTier own = tierOf(before);
    own.decoupling = DecouplingTier::Planar;
    TickTier estimating = own;
    estimating.decoupling = DecouplingTier::Estimator;
    result.decouplings = ticks.measured({own, estimating}, plan.rounds);
    ticks.doubt(result.reference);
    markFront(result.ticks, result.reference.forceDoubt);
    result.reference.tick = tierOf(ticks.model());
    result.reference.tickMedian = quantile(ticks.reference().times, 0.5);
    result.reference.forceScale = forceScale(ticks.reference());
    result.reference.contactRatio = largestContactRatio(ticks.reference());
    setModel(scene, ticks.model());
    studySurfaces(scene, ticks.reference().states, plan, result);
    setModel(scene, before);
    result.rates = studyRates(scene, plan.duration);
    return result;
}

}  // namespace asperity
