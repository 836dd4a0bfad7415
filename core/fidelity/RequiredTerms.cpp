#include "core/fidelity/RequiredTerms.h"

#include "core/deformation/ContactDeformation.h"
#include "core/fidelity/SampledRuns.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace asperity {

namespace {

constexpr int kSamples = 65;
constexpr double kReach = 3.0;  // of a patch, in contact radii
constexpr std::size_t kMoments = 3;
constexpr int kRounds = 3;  // of timed patches

/// Contacts that differ, the one with the largest normal force first.
std::vector<const TipState*> moments(std::span<const TipState> states) {
    std::vector<const TipState*> bonded;
    for (const TipState& state : states) {
        if (state.converged && state.contact.contactRadius > 0.0) {
            bonded.push_back(&state);
        }
    }
    std::ranges::stable_sort(bonded, std::greater(),
                             [](const TipState* state) { return state->normalForce; });
    std::vector<const TipState*> chosen;
    for (std::size_t i = 0; i < kMoments && i < bonded.size(); ++i) {
        chosen.push_back(bonded[i * (bonded.size() - 1) / kMoments]);
    }
    return chosen;
}

double rms(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value * value;
    }
    return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

/// Returns what it makes, and the shortest time that this takes of a few rounds [s].
template <class Make>
auto timed(int rounds, const Make& make) {
    using Clock = std::chrono::steady_clock;
    double shortest = std::numeric_limits<double>::infinity();
    decltype(make()) made;
    for (int round = 0; round < rounds; ++round) {
        const auto start = Clock::now();
        made = make();
        shortest = std::min(shortest, std::chrono::duration<double>(Clock::now() - start).count());
    }
    return std::pair(std::move(made), shortest);
}

/// Root mean square of the distance between the patches' points [m].
double rmsDistance(const SurfacePatch& a, const SurfacePatch& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        sum += (a.points[i] - b.points[i]).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(a.points.size()));
}

/// Returns whether no two positions of the scan can come as near to a tip that feels it.
bool tipFitsEverywhere(const Scene& scene) {
    const BoxBounds scan = scene.surface.bounds().all();
    const double above = scene.belief.tipRadius() + scene.belief.contact.attractionRange();
    return !scene.shape && scan.concavity * (scan.highest - scan.lowest + above) < 1.0;
}

/// The usual model and every term of the scene that is still to be weighed.
ForceModelOptions fullModel(const Scene& scene, const ForceModelOptions& usual) {
    ForceModelOptions full = usual;
    for (const ModelTerm term : kSwitchedTerms) {
        const ForceModelOptions more = with(full, term);
        if (!isSettled(term, scene.description.choices) && isInScene(term, scene) &&
            more.law == full.law) {
            full = more;
        }
    }
    return full;
}

/// Decides about the terms of the force.
class ForceNeeds {
public:
    ForceNeeds(Scene& scene, RequiredTerms& needs, double longestTick, Progress* progress)
        : scene_(scene), needs_(needs), progress_(progress), runs_(scene, longestTick, progress) {}

    [[nodiscard]] bool isSlow() const { return runs_.isSlow(); }
    [[nodiscard]] double usualTickTime() const { return runs_.usualTickTime(); }
    /// Measures the full model. Sets the scene's model.
    [[nodiscard]] const ModelRun& reference() { return runs_.of(needs_.full).run; }

    void decide(bool tipFits) {
        chooseLawOfAll();
        for (TermNeed& need : needs_.terms) {
            const auto done = static_cast<double>(&need - needs_.terms.data());
            reportTo(progress_, done / static_cast<double>(needs_.terms.size()));
            if (!isOfSurface(need.term)) {
                weigh(need);
            }
            // No sampled run is as fast as a hand may be.
            const bool isBound = (need.term == ModelTerm::GlobalSearch && !tipFits) ||
                                 need.term == ModelTerm::Relaxation || need.term == ModelTerm::Drag;
            // What matters alone stays, also where other errors would make up for it.
            if (!isOfSurface(need.term) && has(needs_.full, need.term) && !need.overruled &&
                !isBound && need.effect <= needs_.tolerance) {
                free_.push_back(need.term);
            }
        }
        leaveOut();
        needs_.modelErrors = runs_.errors(needs_.model, needs_.full);
        needs_.fullTick = runs_.of(needs_.full).tickTime;
        needs_.modelTick = runs_.of(needs_.model).tickTime;
        measureError();
    }

private:
    TermNeed& need(ModelTerm term) { return needs_.terms[static_cast<std::size_t>(term)]; }

    void weigh(TermNeed& need) {
        if (!need.possible) {
            return;
        }
        const QuantityErrors errors = errorsWithout(need.term, needs_.full);
        need.effect = errors.worst();
        need.quantity = errors.worstQuantity();
        const TermPair models = pairOf(need.term, needs_.full);
        need.time = runs_.timeDifference(models.with, models.without);
        const ModelSample& more = runs_.of(models.with);  // the scene has the term then
        need.fact = factOf(need.term, scene_, more.run);
    }

    /// Returns what leaving the term out changes, see TermNeed::effect.
    [[nodiscard]] QuantityErrors errorsWithout(ModelTerm term, const ForceModelOptions& model) {
        const TermPair models = pairOf(term, model);
        return runs_.errors(models.without, models.with);
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
    }

    /// The exact sphere stays where contacts are wide without load: it is the instrument's law
    /// there.
    [[nodiscard]] ForceModelOptions withBestLaw(const ForceModelOptions& model) {
        const bool isWide = has(model, ModelTerm::SphereCorrection);
        return isWide ? model : withLawThatLeavesOutLeast(model);
    }

    /// Laws are compared by the force along the runs: by its worst quantity the faintest adhesion
    /// would outweigh everything, since without it there is no pull-off at all.
    [[nodiscard]] ForceModelOptions withLawThatLeavesOutLeast(const ForceModelOptions& model) {
        std::vector<std::pair<ModelTerm, QuantityErrors>> effects;
        for (const ModelTerm term : kModelTerms) {
            if ((isOfLaw(term) || term == ModelTerm::SampleCurvature) &&
                isPossible(term, scene_.description)) {
                effects.emplace_back(term, errorsWithout(term, model));
            }
        }
        const auto leftOutBy = [&effects](const ForceModelOptions& candidate, const auto& valueOf) {
            double most = 0.0;
            for (const auto& [term, errors] : effects) {
                most = std::max(most, has(candidate, term) ? 0.0 : valueOf(errors));
            }
            return most;
        };
        const auto worstOf = [](const QuantityErrors& errors) { return errors.worst(); };
        const auto forceOf = [](const QuantityErrors& errors) {
            return errors[JudgedQuantity::RunForce];
        };
        ForceModelOptions best = model;
        if (leftOutBy(best, worstOf) <= needs_.tolerance) {
            return best;
        }
        for (const ModelTerm term : {ModelTerm::SphereCorrection, ModelTerm::FilmBase}) {
            const ForceModelOptions other = with(model, term);
            if (isPossible(term, scene_.description) &&
                leftOutBy(other, forceOf) < leftOutBy(best, forceOf)) {
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
                if (has(needs_.model, term) &&
                    runs_.errors(less, needs_.full).worst() <= needs_.tolerance) {
                    needs_.model = less;
                    changed = true;
                }
            }
        }
    }

    /// The model that has all, whatever the scene says; where it says nothing the full one.
    [[nodiscard]] ForceModelOptions theWhole() {
        ForceModelOptions whole = wholeModel(scene_);
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
        needs_.wholeErrors = runs_.errors(needs_.model, whole);
        for (const ModelTerm term : missingTerms(whole, scene_)) {
            const QuantityErrors errors = errorsWithout(term, whole);
            needs_.lawErrors.addSquares(errors);
            if (errors.worst() > 0.0) {
                needs_.lawMisses.push_back(term);
            }
        }
        needs_.measured = true;
    }

    Scene& scene_;
    RequiredTerms& needs_;
    Progress* progress_;
    SampledRuns runs_;
    std::vector<ModelTerm> free_;  ///< to be left out
};

/// Decides about the terms of the picture.
void decideSurface(const SceneDescription& description, RequiredTerms& needs) {
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

void fillIn(const SurfaceNeeds& surface, RequiredTerms& needs) {
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

void decideAll(Scene& scene, ForceNeeds& force, RequiredTerms& needs, Progress* progress) {
    force.decide(tipFitsEverywhere(scene));
    setModel(scene, needs.full);
    needs.surface = surfaceNeedsOf(scene, force.reference().states, progress);
    fillIn(needs.surface, needs);
    decideSurface(scene.description, needs);
}

double curvatureOf(const ModelRun& run) {
    return largestOf(run, [](const TipState& state) {
        return std::max(std::abs(state.closest.curvatures.largest),
                        std::abs(state.closest.curvatures.smallest));
    });
}

}  // namespace

SurfaceNeeds surfaceNeedsOf(const Scene& scene, std::span<const TipState> states,
                            Progress* progress) {
    HalfSpaceModel halfSpace;
    SurfaceNeeds needs;
    std::vector<double> outside;
    std::vector<double> halfSpaces;
    std::vector<double> outsideTimes;
    std::vector<double> solveTimes;
    for (const TipState* state : moments(states)) {
        const PatchGrid grid{.halfWidth = kReach * state->contact.contactRadius,
                             .samples = kSamples};
        const auto patch = [&](DeformationModel model) {
            return timed(kRounds, [&] { return exactPatch(scene, *state, model, grid); });
        };
        const double depth = std::abs(state->contact.indentation);
        const auto share = [depth](double distance) {
            return depth > 0.0 ? distance / depth : 0.0;
        };
        const double done = static_cast<double>(outside.size()) / kMoments;
        reportTo(progress, done);
        const auto [radius, radiusTime] = patch(DeformationModel::ContactRadius);
        const auto [closed, closedTime] = patch(DeformationModel::ClosedForm);
        outside.push_back(share(rmsDistance(radius, closed)));
        outsideTimes.push_back(closedTime - radiusTime);
        reportTo(progress, done + 0.5 / kMoments);
        const auto [answer, solveTime] = timed(1, [&] { return halfSpace.solve(scene, *state); });
        if (!needs.touches) {
            needs.deepest = answer;
        }
        needs.halfSpaceHolds = answer.valid() && (!needs.touches || needs.halfSpaceHolds);
        needs.touches = true;
        if (answer.valid()) {
            const SurfacePatch solved = halfSpacePatch(scene, answer, grid);
            halfSpaces.push_back(share(rmsDistance(closed, solved)));
            solveTimes.push_back(solveTime);
        }
    }
    needs.outsideTime = quantile(outsideTimes, 0.5);
    needs.halfSpaceTime = quantile(std::move(solveTimes), 0.0);  // the first one sets up as well
    needs.outside = rms(outside);
    needs.halfSpace = rms(halfSpaces);
    return needs;
}

RequiredTerms needsBeforeFit(const Scene& scene) {
    const SceneDescription& description = scene.description;
    ForceModelOptions full = usualModel(description);
    full.bodyAttraction =
        description.choices.bodyAttraction.value_or(scene.truth.beside != nullptr);
    RequiredTerms needs{.terms = {},
                        .full = full,
                        .model = full,
                        .tolerance = description.tolerance,
                        .setpoint = description.setpoint,
                        .pending = true};
    for (const ModelTerm term : kModelTerms) {
        needs.terms.push_back({.term = term,
                               .on = has(full, term),
                               .overruled = isSettled(term, description.choices),
                               .possible = isInScene(term, scene)});
    }
    return needs;
}

RequiredTerms fitModel(Scene& scene, double longestTick, Progress* progress) {
    // A scene that ticks too slowly to be fitted keeps what it was loaded with.
    RequiredTerms needs = needsBeforeFit(scene);
    needs.pending = false;
    setModel(scene, needs.full);
    ProgressPart forcePart(progress, 0.0, 0.7);
    ForceNeeds force(scene, needs, longestTick, &forcePart);
    if (force.isSlow()) {
        needs.fullTick = needs.modelTick = force.usualTickTime();
    } else {
        needs.full = fullModel(scene, needs.full);
        ProgressPart surfacePart(progress, 0.7, 1.0);
        decideAll(scene, force, needs, &surfacePart);
    }
    for (TermNeed& need : needs.terms) {
        need.on = has(needs.model, need.term);
    }
    setModel(scene, needs.model);
    if (needs.measured) {
        scene.leftOut = needs.totalErrors();
    }
    return needs;
}

TermFact factOf(ModelTerm term, const Scene& scene, const ModelRun& run) {
    const SampleMaterial& material = scene.description.sample.material;
    switch (term) {
    case ModelTerm::Adhesion:
        return {largestOf(run, [](const TipState& s) { return -s.normalForce; }),
                largestOf(run, [](const TipState& s) { return s.normalForce; })};
    case ModelTerm::VanDerWaalsTail:
        return {scene.belief.contact.lambda()};
    case ModelTerm::SphereCorrection:
        return {largestOf(run, [](const TipState& s) { return s.contactRatio; })};
    case ModelTerm::FilmBase:
        return {largestOf(run, [](const TipState& s) { return s.contact.contactRadius; }) /
                material.filmThickness};
    case ModelTerm::SampleCurvature:
        return {curvatureOf(run) * scene.belief.tipRadius()};
    case ModelTerm::BodyAttraction:
        return {largestOf(
            run, [](const TipState& s) { return std::abs(s.body.at(s.contact.indentation)); })};
    case ModelTerm::RetractWork:
        return {material.retractWork / material.workOfAdhesion};
    case ModelTerm::Relaxation:
        return {1.0 + (material.relaxingModulus / material.elastic.youngsModulus),
                material.relaxationTime};
    case ModelTerm::Drag:
        return {material.drag / material.dragOffset};
    case ModelTerm::Friction:
        return {material.friction.coefficient, material.friction.shearStrength};
    case ModelTerm::Torsion: {
        const Matrix3& c = scene.belief.cantilever.complianceInCantileverFrame();
        return {c(1, 1) / c(2, 2)};
    }
    case ModelTerm::MountTilt:
        return {scene.description.probe.mountTilt};
    case ModelTerm::GlobalSearch:
        return {scene.shape ? std::numeric_limits<double>::infinity()
                            : scene.surface.bounds().all().concavity * scene.belief.tipRadius()};
    case ModelTerm::OutsideDisplacement:
    case ModelTerm::HalfSpaceSolve:
        break;
    }
    return {};
}

}  // namespace asperity
