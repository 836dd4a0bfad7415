#include "core/studies/TradeOffStudy.h"

#include "core/deformation/ContactDeformation.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/fidelity/ModelRun.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "core/studies/TickStudy.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

constexpr int kReferenceSamples = 193;  // of a patch, a side
constexpr double kReach = 3.0;          // of a patch, in contact radii

/// Contacts of the run, spread evenly.
std::vector<TipState> contactsOf(std::span<const TipState> states, int count) {
    std::vector<TipState> bonded;
    std::ranges::copy_if(states, std::back_inserter(bonded), [](const TipState& state) {
        return state.converged && state.contact.contactRadius > 0.0;
    });
    std::vector<TipState> chosen;
    for (int i = 0; i < count && !bonded.empty(); ++i) {
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        chosen.push_back(
            bonded[static_cast<std::size_t>(share * static_cast<double>(bonded.size() - 1))]);
    }
    return chosen;
}

PatchGrid gridOf(const TipState& state, int samples) {
    return {.halfWidth = kReach * state.contact.contactRadius, .samples = samples};
}

/// Displacement along z of a patch at a position of its grid, 0..1 along each side, between the
/// samples as a picture shows it [m].
double displacementAt(const SurfacePatch& patch, double column, double row) {
    const double x = column * (patch.columns - 1);
    const double y = row * (patch.rows - 1);
    const int j = std::min(static_cast<int>(x), patch.columns - 2);
    const int i = std::min(static_cast<int>(y), patch.rows - 2);
    const auto at = [&](int r, int c) {
        const std::size_t index = patch.index(r, c);
        return patch.points[index].z() - patch.rest[index].z();
    };
    const double low = std::lerp(at(i, j), at(i, j + 1), x - j);
    const double high = std::lerp(at(i + 1, j), at(i + 1, j + 1), x - j);
    return std::lerp(low, high, y - i);
}

/// Sums up differences of patches.
struct SurfaceError {
    double sum = 0.0;
    double largest = 0.0;
    std::size_t count = 0;

    void add(const SurfacePatch& patch, const SurfacePatch& reference) {
        for (int row = 0; row < reference.rows; ++row) {
            for (int column = 0; column < reference.columns; ++column) {
                const double x = static_cast<double>(column) / (reference.columns - 1);
                const double y = static_cast<double>(row) / (reference.rows - 1);
                const double error = displacementAt(patch, x, y) - displacementAt(reference, x, y);
                sum += error * error;
                largest = std::max(largest, std::abs(error));
                ++count;
            }
        }
    }
    [[nodiscard]] double rms() const {
        return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
    }
};

/// The half-space's patches, and the contacts that they are of: those where it holds.
struct SolvedContacts {
    std::vector<TipState> states;
    std::vector<SurfacePatch> patches;
    double forceError = 0.0;  ///< of the law against its own force, root mean square [N]
};

/// @param pixels of the half-space, a side
SolvedContacts solvedContacts(const Scene& scene, const std::vector<TipState>& states, int pixels) {
    SolvedContacts solved;
    double sum = 0.0;
    HalfSpaceModel model(pixels, {.tolerance = 1e-4});
    for (const TipState& state : states) {
        const HalfSpaceAnswer answer = model.solve(scene, state);
        if (answer.valid()) {
            solved.states.push_back(state);
            const double error = answer.force - state.normalForce;
            sum += error * error;
            solved.patches.push_back(
                halfSpacePatch(scene, answer, gridOf(state, kReferenceSamples)));
        }
    }
    if (!solved.states.empty()) {
        solved.forceError = std::sqrt(sum / static_cast<double>(solved.states.size()));
    }
    return solved;
}

/// The closed forms, to compare with where no half-space holds.
SolvedContacts closedForms(const Scene& scene, const std::vector<TipState>& states) {
    SolvedContacts closed{.states = states, .patches = {}};
    for (const TipState& state : states) {
        closed.patches.push_back(exactPatch(scene, state, DeformationModel::ClosedForm,
                                            gridOf(state, kReferenceSamples)));
    }
    return closed;
}

FrameResult resultOf(const Scene& scene, const FrameOptions& options,
                     const SolvedContacts& reference, int rounds) {
    const std::vector<TipState>& states = reference.states;
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    SurfaceError error;
    for (std::size_t i = 0; i < states.size(); ++i) {
        SurfacePatch patch;
        for (int round = 0; round < rounds; ++round) {
            const auto start = Clock::now();
            patch = exactPatch(scene, states[i], options.deformation,
                               gridOf(states[i], options.samples));
            times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        }
        error.add(patch, reference.patches[i]);
    }
    return {.options = options,
            .median = quantile(times, 0.5),
            .surfaceErrorRms = error.rms(),
            .surfaceErrorMax = error.largest};
}

/// Estimates how much the half-space still changes with its pixels.
void doubt(const Scene& scene, const SolvedContacts& reference, TradeOffReference& result) {
    const SolvedContacts coarser =
        solvedContacts(scene, reference.states, HalfSpaceModel::kSamples);
    if (coarser.states.size() != reference.states.size()) {
        result.surfaceDoubtBy = SurfaceDoubt::CoarserFails;
        return;
    }
    SurfaceError error;
    for (std::size_t i = 0; i < reference.patches.size(); ++i) {
        error.add(coarser.patches[i], reference.patches[i]);
    }
    result.surfaceDoubt = error.rms();
    result.surfaceDoubtBy = SurfaceDoubt::ByCoarser;
}

double rmsIndentation(const std::vector<TipState>& states) {
    double sum = 0.0;
    for (const TipState& state : states) {
        sum += state.contact.indentation * state.contact.indentation;
    }
    return states.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(states.size()));
}

/// Draws contacts of a run with every frame option and compares each with a half-space of twice as
/// many pixels a side, at those contacts where that holds. Where it holds at none, the closed form
/// is the reference, and the half-space no option. Fills in the frames and the surface's part of
/// the reference.
/// @param progress may be null  @throw Canceled
void studySurfaces(const Scene& scene, std::span<const TipState> states, const TradeOffPlan& plan,
                   Progress* progress, TradeOff& result) {
    constexpr int kFinePixels = 2 * HalfSpaceModel::kSamples;
    const std::vector<TipState> contacts = contactsOf(states, plan.patches);
    reportTo(progress, 0.0);
    SolvedContacts reference = solvedContacts(scene, contacts, kFinePixels);
    const bool holds = !reference.states.empty();
    if (holds) {
        doubt(scene, reference, result.reference);
    } else {
        reference = closedForms(scene, contacts);
        result.reference.surfaceDoubtBy = SurfaceDoubt::NothingFiner;
    }
    result.reference.halfSpaceForce = reference.forceError;
    result.reference.contacts = static_cast<int>(reference.states.size());
    result.reference.contactsAsked = static_cast<int>(contacts.size());
    result.reference.frame = {.deformation = holds ? DeformationModel::HalfSpace
                                                   : DeformationModel::ClosedForm,
                              .samples = kReferenceSamples};
    result.reference.indentation = rmsIndentation(reference.states);
    const std::vector<FrameOptions> all = frameOptions();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const FrameOptions& options = all[i];
        reportTo(progress, static_cast<double>(i + 1) / static_cast<double>(all.size() + 1));
        if (holds || options.deformation != DeformationModel::HalfSpace) {
            result.frames.push_back(resultOf(scene, options, reference, plan.rounds));
        }
    }
}

constexpr double kMinRate = 250.0;       // [Hz]
constexpr double kMaxRate = 8e3;         // [Hz]
constexpr double kReferenceRate = 16e3;  // [Hz]

/// Course of a run, whatever its rate.
struct Course {
    DevicePath path;
    double duration = 0.0;  ///< [s]
    const Progress* progress = nullptr;
};

ModelRun runAt(Scene& scene, const Course& course, double rate) {
    scene.description.tickRate = rate;
    const ModelInputs run = recordInputs(scene, course.path, course.duration, course.progress);
    return runModel(scene, {run}, course.progress);
}

/// Between ticks the last force holds.
double holdError(const ModelRun& held, double rate, const ModelRun& finest) {
    double sum = 0.0;
    for (std::size_t i = 0; i < finest.states.size(); ++i) {
        const auto tick = static_cast<std::size_t>(static_cast<double>(i) * rate / kReferenceRate);
        const TipState& state = held.states[std::min(tick, held.states.size() - 1)];
        sum += (state.force - finest.states[i].force).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(finest.states.size()));
}

/// The scene's approach at tick rates from 250 Hz to 8 kHz, each against twice the highest: what a
/// force misses that is held from tick to tick.
/// @param scene    has its rate changed
/// @param progress may be null  @throw Canceled
std::vector<RateResult> studyRates(Scene& scene, double duration, const Progress* progress) {
    const Course course{slidePath(scene, {.duration = duration}), duration, progress};
    const ModelRun finest = runAt(scene, course, kReferenceRate);
    std::vector<RateResult> results;
    for (double rate = kMinRate; rate <= kMaxRate; rate *= 2.0) {
        const ModelRun run = runAt(scene, course, rate);
        results.push_back({.rate = rate,
                           .load = rate * quantile(run.times, 0.5),
                           .holdErrorRms = holdError(run, rate, finest)});
    }
    return results;
}

/// Laws between which there is a choice; which of them is right depends on the materials.
std::vector<ContactLaw> lawsFor(const SceneDescription& scene) {
    std::vector<ContactLaw> laws;
    std::ranges::copy_if(kValues<ContactLaw>, std::back_inserter(laws), [&scene](ContactLaw law) {
        return (!isFilm(law) || isPossible(ModelTerm::FilmBase, scene)) &&
               (!isAdhesive(law) || isPossible(ModelTerm::Adhesion, scene));
    });
    std::ranges::stable_sort(
        laws, {}, [](ContactLaw law) { return isAdhesive(law) ? 1 + int{isSphere(law)} : 0; });
    return laws;
}

bool hasTable(const Scene& scene, ContactLaw law) {
    ForceModelOptions model = scene.model;
    model.law = law;
    model.solver = SolverSetting::Table;
    return believedSystem(scene.description, model).contact.table() != nullptr;
}

void addOnce(std::vector<ForceModelOptions>& all, const ForceModelOptions& options) {
    if (std::ranges::find(all, options) == all.end()) {
        all.push_back(options);
    }
}

using Indices = std::vector<std::size_t>;

/// Runs of equal error are in the order of their cost.
auto byError(std::span<const CostAndError> choices, double errorResolution) {
    return [=](std::size_t i) {
        return std::pair(std::max(choices[i].error, errorResolution), choices[i].cost);
    };
}

Indices allOf(std::span<const CostAndError> choices) {
    Indices all(choices.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

/// Restores a scene's model and rate in the end.
class SceneKept {
public:
    explicit SceneKept(Scene& scene)
        : scene_(scene), model_(scene.model), tickRate_(scene.description.tickRate) {}
    SceneKept(const SceneKept&) = delete;
    SceneKept& operator=(const SceneKept&) = delete;
    ~SceneKept() {
        scene_.description.tickRate = tickRate_;
        setModel(scene_, model_);
    }

    [[nodiscard]] const ForceModelOptions& model() const { return model_; }

private:
    Scene& scene_;
    ForceModelOptions model_;
    double tickRate_;
};

/// The scene's own model with both models from signals to force.
std::vector<ForceModelOptions> decouplingModels(const ForceModelOptions& model) {
    ForceModelOptions planar = ofForce(model);
    planar.decoupling = DecouplingModel::Planar;
    ForceModelOptions estimating = planar;
    estimating.decoupling = DecouplingModel::Estimator;
    return {planar, estimating};
}

void measureTicks(TickStudy& study, std::vector<ForceModelOptions> models,
                  const std::vector<ForceModelOptions>& decouplings, TradeOff& result) {
    const auto count = static_cast<std::ptrdiff_t>(models.size());
    models.insert(models.end(), decouplings.begin(), decouplings.end());
    const std::vector<TickResult> all = study.measured(models);
    result.ticks.assign(all.begin(), all.begin() + count);
    result.decouplings.assign(all.begin() + count, all.end());
    result.timeResolution = study.timeResolution();
    study.describe(result.reference);
    markFront(result.ticks, result.ofTicks());
}

}  // namespace

std::string nameOf(const FrameOptions& options) {
    const std::string side = std::to_string(options.samples);
    return std::string(nameOf(options.deformation)) + ", " + side + " x " + side;
}

std::vector<ForceModelOptions> tickModels(const Scene& scene) {
    const bool attracts = isInScene(ModelTerm::BodyAttraction, scene);
    std::vector<ForceModelOptions> all;
    for (const ContactLaw law : lawsFor(scene.description)) {
        for (const SolverSetting solver : {SolverSetting::Table, SolverSetting::Newton}) {
            if (solver == SolverSetting::Table && !hasTable(scene, law)) {
                continue;
            }
            for (const SearchEffort effort :
                 {SearchEffort::Local, SearchEffort::Global, SearchEffort::Certified}) {
                ForceModelOptions model{.law = law,
                                        .solver = solver,
                                        .closestPointSearch = effort,
                                        .bodyAttraction = attracts};
                for (const ModelTerm term : kMaterialTerms) {
                    model.*traitsOf(term).option = isInScene(term, scene);
                }
                all.push_back(ofForce(model));
            }
        }
    }
    const ForceModelOptions own = ofForce(scene.model);
    addOnce(all, own);
    for (const ModelTerm left : kSwitchedTerms) {
        ForceModelOptions less = own;
        for (const ModelTerm term : kSwitchedTerms) {
            less.*traitsOf(term).option = term != left && isInScene(term, scene);
        }
        addOnce(all, ofForce(less));
    }
    return all;
}

std::vector<FrameOptions> frameOptions() {
    std::vector<FrameOptions> all;
    for (const DeformationModel deformation :
         {DeformationModel::FourPoint, DeformationModel::ContactRadius,
          DeformationModel::ClosedForm, DeformationModel::HalfSpace}) {
        for (const int samples : {25, 49, 97}) {
            all.push_back({deformation, samples});
        }
    }
    return all;
}

std::vector<bool> paretoFront(std::span<const CostAndError> choices, const Resolution& resolution) {
    std::vector<bool> front(choices.size(), false);
    Indices order = allOf(choices);
    std::ranges::stable_sort(order, {}, byError(choices, resolution.error));
    double cheapest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        front[i] = choices[i].cost * (1.0 + resolution.cost) < cheapest;
        cheapest = front[i] ? choices[i].cost : cheapest;
    }
    return front;
}

std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance,
                           const Resolution& resolution) {
    Indices within = allOf(choices);
    std::erase_if(within, [&](std::size_t i) { return choices[i].error > tolerance; });
    double cheapest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : within) {
        cheapest = std::min(cheapest, choices[i].cost);
    }
    std::erase_if(within, [&](std::size_t i) {
        return choices[i].cost > cheapest * (1.0 + resolution.cost);
    });
    const auto best = std::ranges::min_element(within, {}, byError(choices, resolution.error));
    return best == within.end() ? choices.size() : *best;
}

TradeOff studyTradeOff(Scene& scene, const TradeOffPlan& plan, Progress* progress) {
    const SceneKept before(scene);
    TradeOff result;
    ProgressPart ticking(progress, 0.0, 0.8);
    std::vector<ForceModelOptions> models = tickModels(scene);
    TickStudy ticks(scene, plan, &ticking);
    models.push_back(ofForce(ticks.model()));
    measureTicks(ticks, models, decouplingModels(before.model()), result);
    setModel(scene, ticks.model());
    ProgressPart drawing(progress, 0.8, 0.95);
    studySurfaces(scene, ticks.reference().states, plan, &drawing, result);
    markFront(result.frames, result.ofFrames());
    setModel(scene, before.model());
    result.rates = studyRates(scene, plan.duration, progress);
    reportTo(progress, 1.0);
    return result;
}

}  // namespace asperity
