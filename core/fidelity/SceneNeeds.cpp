#include "core/fidelity/SceneNeeds.h"

#include "core/fidelity/ReferenceModels.h"
#include "core/fidelity/SampledRuns.h"
#include "core/fidelity/TermFacts.h"
#include "core/scene/BelievedModel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// Whether no two places of the scan can come as near to a tip that feels it.
bool tipFitsEverywhere(const Scene& scene) {
    const BoxBounds scan = scene.surface.bounds().all();
    const double above = scene.belief.tipRadius() + scene.belief.contact.attractionRange();
    return !scene.shape && scan.concavity * (scan.highest - scan.lowest + above) < 1.0;
}

/// Decides about the terms of the force.
class ForceNeeds {
public:
    /// @param scene has the full model
    ForceNeeds(Scene& scene, SceneNeeds& needs, double longestTick, Progress* progress)
        : scene_(scene), needs_(needs), progress_(progress), runs_(scene, longestTick, progress) {}

    [[nodiscard]] bool isSlow() const { return runs_.isSlow(); }
    [[nodiscard]] double tickTime() const { return runs_.tickTime(); }
    [[nodiscard]] const ModelRun& reference() const { return runs_.reference(); }

    void decide(bool tipFits) {
        chooseLawOfAll();
        needs_.fullTick = runs_.tickTime();
        for (TermNeed& need : needs_.terms) {
            const auto done = static_cast<double>(&need - needs_.terms.data());
            reportTo(progress_, done / static_cast<double>(needs_.terms.size()));
            if (!isOfSurface(need.term)) {
                weigh(need);
            }
            const bool isBound = need.term == ModelTerm::GlobalSearch && !tipFits;
            // What matters alone stays, also where other errors would make up for it.
            if (!isOfSurface(need.term) && has(needs_.full, need.term) && !need.overruled &&
                !isBound && need.effect <= needs_.tolerance) {
                free_.push_back(need.term);
            }
        }
        leaveOut();
        needs_.forceError = runs_.error(needs_.model);
        needs_.modelTick = runs_.tickTime();
        measureError();
    }

private:
    TermNeed& need(ModelTerm term) { return needs_.terms[static_cast<std::size_t>(term)]; }

    void weigh(TermNeed& need) {
        if (!need.possible) {
            return;
        }
        const TermPair models = pairOf(need.term, needs_.full);
        const ModelDifference difference = runs_.between(models.with, models.without);
        need.effect = difference.effect;
        need.time = difference.time;
        need.fact = factOf(need.term, scene_, difference.with);
    }

    [[nodiscard]] double effectOf(ModelTerm term, const ForceModelOptions& model) {
        const TermPair models = pairOf(term, model);
        return runs_.between(models.with, models.without).effect;
    }

    [[nodiscard]] bool saysLaw() const {
        return std::ranges::any_of(kModelTerms, [&](ModelTerm term) {
            return isOfLaw(term) && isSettled(term, scene_.description.choices);
        });
    }

    /// No law has all. Where the scene says nothing of its law, that of the materials is taken as
    /// long as what it has no room for does not matter, otherwise the one that leaves out least.
    void chooseLawOfAll() {
        if (!saysLaw()) {
            needs_.full = withBestLaw(needs_.full);
        }
        runs_.refer(needs_.full);
    }

    [[nodiscard]] ForceModelOptions withBestLaw(const ForceModelOptions& model) {
        const bool isWide = has(model, ModelTerm::SphereCorrection);  // without load already
        return isWide ? model : withLawThatLeavesOutLeast(model);
    }

    [[nodiscard]] ForceModelOptions withLawThatLeavesOutLeast(const ForceModelOptions& model) {
        std::vector<std::pair<ModelTerm, double>> effects;
        for (const ModelTerm term : kModelTerms) {
            if ((isOfLaw(term) || term == ModelTerm::SampleCurvature) &&
                isPossible(term, scene_.description)) {
                effects.emplace_back(term, effectOf(term, model));
            }
        }
        const auto leftOutBy = [&effects](const ForceModelOptions& candidate) {
            double most = 0.0;
            for (const auto& [term, effect] : effects) {
                most = std::max(most, has(candidate, term) ? 0.0 : effect);
            }
            return most;
        };
        ForceModelOptions best = model;
        if (leftOutBy(best) <= needs_.tolerance) {
            return best;
        }
        for (const ModelTerm term : {ModelTerm::SphereCorrection, ModelTerm::FilmBase}) {
            const ForceModelOptions other = with(model, term);
            if (isPossible(term, scene_.description) && leftOutBy(other) < leftOutBy(best)) {
                best = other;
            }
        }
        return best;
    }

    /// The least effect first; then again what stayed, since what was left out after it can make up
    /// for it.
    void leaveOut() {
        std::ranges::stable_sort(free_, {}, [&](ModelTerm term) { return need(term).effect; });
        needs_.model = needs_.full;
        for (bool changed = true; changed;) {
            changed = false;
            for (const ModelTerm term : free_) {
                const ForceModelOptions less = without(needs_.model, term);
                if (has(needs_.model, term) && runs_.error(less) <= needs_.tolerance) {
                    needs_.model = less;
                    changed = true;
                }
            }
        }
    }

    /// The model that has all, whatever the scene says; where it says nothing the full one.
    [[nodiscard]] ForceModelOptions theWhole() {
        ForceModelOptions whole = wholeModel(scene_.description);
        whole.solver = needs_.full.solver;  // they agree to nine digits
        whole.decoupling = needs_.full.decoupling;
        if (saysLaw()) {
            return withBestLaw(whole);
        }
        whole.law = needs_.full.law;
        return whole;
    }

    void measureError() {
        const ForceModelOptions whole = theWhole();
        const bool isFull = ofForce(whole) == ofForce(needs_.full);
        needs_.wholeError = isFull ? needs_.forceError : runs_.between(whole, needs_.model).effect;
        double sum = 0.0;
        for (const ModelTerm term : missingTerms(whole, scene_.description)) {
            const double effect = isFull ? need(term).effect : effectOf(term, whole);
            sum += effect * effect;
            if (effect > 0.0) {
                needs_.lawMisses.push_back(term);
            }
        }
        needs_.lawError = std::sqrt(sum);
        needs_.measured = true;
    }

    Scene& scene_;
    SceneNeeds& needs_;
    Progress* progress_;
    SampledRuns runs_;
    std::vector<ModelTerm> free_;  ///< to be left out
};

/// Decides about the terms of the picture.
void decideSurface(const SceneDescription& description, SceneNeeds& needs) {
    const SurfaceNeeds& surface = needs.surface;
    if (description.choices.deformation) {
        return;
    }
    if (surface.halfSpaceHolds && surface.halfSpace > needs.tolerance) {
        needs.model = with(needs.model, ModelTerm::HalfSpaceSolve);
    } else if (surface.touches && surface.outside <= needs.tolerance) {
        needs.model = without(needs.model, ModelTerm::OutsideDisplacement);
    }
}

void fillIn(const SurfaceNeeds& surface, SceneNeeds& needs) {
    for (TermNeed& need : needs.terms) {
        if (need.term == ModelTerm::OutsideDisplacement) {
            need.effect = surface.outside;
            need.time = surface.outsideTime;
        } else if (need.term == ModelTerm::HalfSpaceSolve) {
            need.effect = surface.halfSpace;
            need.time = surface.halfSpaceTime;
        }
    }
}

void decideAll(Scene& scene, ForceNeeds& force, SceneNeeds& needs, Progress* progress) {
    force.decide(tipFitsEverywhere(scene));
    setModel(scene, needs.full);
    needs.surface = surfaceNeedsOf(scene, force.reference().states, progress);
    fillIn(needs.surface, needs);
    decideSurface(scene.description, needs);
}

}  // namespace

SceneNeeds needsBeforeFit(const SceneDescription& scene) {
    const ForceModelOptions full = usualModel(scene);
    SceneNeeds needs{
        .terms = {}, .full = full, .model = full, .tolerance = scene.tolerance, .pending = true};
    for (const ModelTerm term : kModelTerms) {
        needs.terms.push_back({.term = term,
                               .on = has(full, term),
                               .overruled = isSettled(term, scene.choices),
                               .possible = isPossible(term, scene)});
    }
    return needs;
}

SceneNeeds fitModel(Scene& scene, double longestTick, Progress* progress) {
    SceneNeeds needs = needsBeforeFit(scene.description);
    needs.pending = false;
    setModel(scene, needs.full);
    ProgressPart forcePart(progress, 0.0, 0.7);
    ForceNeeds force(scene, needs, longestTick, &forcePart);
    if (force.isSlow()) {
        needs.fullTick = needs.modelTick = force.tickTime();
    } else {
        ProgressPart surfacePart(progress, 0.7, 1.0);
        decideAll(scene, force, needs, &surfacePart);
    }
    for (TermNeed& need : needs.terms) {
        need.on = has(needs.model, need.term);
    }
    setModel(scene, needs.model);
    return needs;
}

}  // namespace asperity
