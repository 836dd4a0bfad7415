#include "core/fidelity/SceneNeeds.h"

#include "core/fidelity/SampledRuns.h"
#include "core/fidelity/SurfaceNeeds.h"
#include "core/fidelity/TermFacts.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// How far from its sphere a tip looks for feet [m].
constexpr double kFeetReach = 10e-9;

/// Whether no two places of the scan can come as near to a tip that feels it.
bool tipFitsEverywhere(const Scene& scene) {
    const BoxBounds scan = scene.surface.bounds().all();
    const double above = scene.belief.tipRadius() + kFeetReach;
    return !scene.shape && scan.concavity * (scan.highest - scan.lowest + above) < 1.0;
}

/// The model with every term that the description does not settle.
SceneModel fullModel(const SceneDescription& scene) {
    SceneModel model = usualModel(scene);
    for (const ModelTerm term :
         {ModelTerm::SampleCurvature, ModelTerm::Friction, ModelTerm::Torsion, ModelTerm::MountTilt,
          ModelTerm::GlobalSearch}) {
        if (!isSettled(term, scene)) {
            model = with(model, term);
        }
    }
    return model;
}

/// Decides about the terms of the force.
class ForceNeeds {
public:
    /// @param scene has the full model
    ForceNeeds(Scene& scene, SceneNeeds& needs) : needs_(needs), runs_(scene) {}

    [[nodiscard]] bool isSlow() const { return runs_.isSlow(); }
    [[nodiscard]] const ModelRun& reference() const { return runs_.reference(); }

    void decide(const SceneDescription& description, bool tipFits) {
        chooseLawOfAll(description);
        needs_.fullTick = runs_.tickTime();
        for (TermNeed& need : needs_.terms) {
            if (isOfSurface(need.term) || !has(needs_.full, need.term)) {
                continue;
            }
            need.effect = runs_.error(without(needs_.full, need.term));
            need.time = needs_.fullTick - runs_.tickTime();
            const bool isBound = need.term == ModelTerm::GlobalSearch && !tipFits;
            // What matters alone stays, also where other errors would make up for it.
            if (!need.overruled && !isBound && need.effect <= needs_.tolerance) {
                free_.push_back(need.term);
            }
        }
        leaveOut();
        needs_.forceError = runs_.error(needs_.model);
        needs_.modelTick = runs_.tickTime();
    }

private:
    TermNeed& need(ModelTerm term) { return needs_.terms[static_cast<std::size_t>(term)]; }

    /// The exact sphere's law has no tail and takes the sample as flat. Where the scene
    /// says nothing of its law, it is taken if that matters less, or contacts are wide without
    /// load.
    void chooseLawOfAll(const SceneDescription& description) {
        const SceneModel sphere = with(needs_.full, ModelTerm::SphereCorrection);
        const bool said = isSettled(ModelTerm::Adhesion, description) ||
                          isSettled(ModelTerm::VanDerWaalsTail, description) ||
                          isSettled(ModelTerm::SphereCorrection, description);
        if (said || !has(sphere, ModelTerm::SphereCorrection)) {
            return;
        }
        const SceneModel neither = without(sphere, ModelTerm::SphereCorrection);
        const bool adhesive = has(neither, ModelTerm::Adhesion);
        const SceneModel tail = adhesive ? with(neither, ModelTerm::VanDerWaalsTail) : neither;
        const SceneModel flat = without(neither, ModelTerm::SampleCurvature);
        const double bySphere = runs_.difference(without(sphere, ModelTerm::SampleCurvature), flat);
        const double byTail = runs_.difference(tail, neither);
        const double byCurvature = runs_.difference(neither, flat);
        need(ModelTerm::SphereCorrection).effect = bySphere;
        need(ModelTerm::VanDerWaalsTail).effect = byTail;
        need(ModelTerm::SampleCurvature).effect = byCurvature;
        const bool isWide = has(needs_.full, ModelTerm::SphereCorrection);  // without load already
        const bool takesSphere =
            isWide || (bySphere > needs_.tolerance && bySphere > std::max(byTail, byCurvature));
        needs_.full.law.law = (takesSphere ? sphere : tail).law.law;
        runs_.refer(needs_.full);
    }

    /// The least effect first; then again what stayed, since what was left out after it can make up
    /// for it.
    void leaveOut() {
        std::ranges::stable_sort(free_, {}, [&](ModelTerm term) { return need(term).effect; });
        needs_.model = needs_.full;
        for (bool changed = true; changed;) {
            changed = false;
            for (const ModelTerm term : free_) {
                const SceneModel less = without(needs_.model, term);
                if (has(needs_.model, term) && runs_.error(less) <= needs_.tolerance) {
                    needs_.model = less;
                    changed = true;
                }
            }
        }
    }

    SceneNeeds& needs_;
    SampledRuns runs_;
    std::vector<ModelTerm> free_;  ///< to be left out
};

/// Decides about the terms of the picture.
void decideSurface(const SceneDescription& description, const SurfaceNeeds& surface,
                   SceneNeeds& needs) {
    if (description.deformation) {
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

}  // namespace

SceneNeeds fitModel(Scene& scene) {
    SceneNeeds needs{.terms = {}, .full = fullModel(scene.description)};
    needs.tolerance = scene.description.tolerance;
    for (const ModelTerm term : kModelTerms) {
        needs.terms.push_back(
            {.term = term, .overruled = isSettled(term, scene.description), .why = ""});
    }
    setModel(scene, needs.full);
    needs.model = needs.full;
    ForceNeeds force(scene, needs);
    if (!force.isSlow()) {
        force.decide(scene.description, tipFitsEverywhere(scene));
        setModel(scene, needs.full);
        const SurfaceNeeds surface = surfaceNeedsOf(scene, force.reference().states);
        fillIn(surface, needs);
        decideSurface(scene.description, surface, needs);
        for (TermNeed& need : needs.terms) {
            need.why = factOf(need.term, scene, force.reference(), surface);
        }
    }
    for (TermNeed& need : needs.terms) {
        need.on = has(needs.model, need.term);
    }
    setModel(scene, needs.model);
    return needs;
}

}  // namespace asperity
