#include "core/fidelity/TradeOffStudy.h"

#include "core/fidelity/ModelRun.h"
#include "core/fidelity/ModelTerm.h"
#include "core/fidelity/RateStudy.h"
#include "core/fidelity/SurfaceStudy.h"

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
        record(scratchPath(scene, {.duration = plan.duration}), plan);
        model_.law = chooseLaw(std::nullopt, scene.belief.contact.pair());
        if (scene.belief.contact.filmThickness() > 0.0) {
            model_.law.law = ContactLaw::HertzFilm;
        }
        model_ = modelWithTier(model_, {.law = model_.law.law,
                                        .solver = SolverTier::Exact,
                                        .footSearch = FootEffort::Certified});
        reference_ = run(model_);
        if (largestContactRatio(reference_) > kLargeContact) {
            model_ = with(model_, ModelTerm::SphereCorrection);
            reference_ = run(model_);
        }
    }

    [[nodiscard]] const SceneModel& model() const { return model_; }
    [[nodiscard]] const ModelRun& reference() const { return reference_; }

    [[nodiscard]] std::vector<TickResult> measured(int rounds) {
        std::vector<TickResult> results;
        std::vector<std::vector<double>> times;
        for (const TickTier& tier : tickTiers(scene_)) {
            results.push_back(resultOf(tier));
            times.emplace_back();
        }
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < results.size(); ++i) {
                const ModelRun timed = run(modelWithTier(model_, results[i].tier));
                times[i].insert(times[i].end(), timed.times.begin(), timed.times.end());
            }
        }
        std::vector<CostAndError> choices;
        for (std::size_t i = 0; i < results.size(); ++i) {
            results[i].median = quantile(times[i], 0.5);
            results[i].p99 = quantile(times[i], kP99);
            choices.push_back(results[i].costAndError());
        }
        const std::vector<bool> front = paretoFront(choices);
        for (std::size_t i = 0; i < results.size(); ++i) {
            results[i].onFront = front[i];
        }
        return results;
    }

    /// What the reference leaves out itself.
    void doubt(TradeOffReference& reference) {
        const SceneModel sphere = with(model_, ModelTerm::SphereCorrection);
        if (!isSphere(model_.law.law) && isSphere(sphere.law.law)) {
            const SceneModel paraboloid = without(sphere, ModelTerm::SphereCorrection);
            reference.forceDoubt = differenceOf(run(paraboloid), run(sphere)).rms;
            reference.forceDoubtBy = "the paraboloid against the exact sphere";
            return;
        }
        SceneModel warm = model_;
        warm.solver = SolverTier::Newton;
        reference.forceDoubt = differenceOf(run(warm), reference_).rms;
        reference.forceDoubtBy = "solved afresh against solved from the previous state";
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
    result.ticks = ticks.measured(plan.rounds);
    ticks.doubt(result.reference);
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
