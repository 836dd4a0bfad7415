#include "core/studies/DeformationStudy.h"

#include "core/deformation/ContactDeformation.h"
#include "core/fidelity/ModelRun.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

using SteadyClock = std::chrono::steady_clock;

/// The paper's materials.
std::vector<SampleMaterial> paperMaterials() {
    return {{.name = "silicon oxide",
             .elastic = {.youngsModulus = 70e9, .poissonRatio = 0.27},
             .workOfAdhesion = 0.2},
            {.name = "polystyrene",
             .elastic = {.youngsModulus = 2e9, .poissonRatio = 0.4},
             .workOfAdhesion = 0.066},
            {.name = "silicone rubber",
             .elastic = {.youngsModulus = 1e6, .poissonRatio = 0.5},
             .workOfAdhesion = 0.022}};
}

HeightMap flatHeights() {
    constexpr int kPixels = 64;
    constexpr double kPitch = 4e-9;
    HeightMap map{.columns = kPixels,
                  .rows = kPixels,
                  .pitchX = kPitch,
                  .pitchY = kPitch,
                  .heights = {},
                  .invalid = {}};
    map.heights.assign(map.index(kPixels, 0), 0.0);
    return map;
}

/// Both surfaces with the material and the law of the exact sphere.
Scene sceneOf(Scene scene, const SampleMaterial& material) {
    const ModelChoices& said = scene.description.choices;
    scene.description.choices = {.law = ContactLaw::SphereMaugis,  // it settles its terms
                                 .solver = said.solver,
                                 .closestPointSearch = said.closestPointSearch,
                                 .decoupling = said.decoupling,
                                 .deformation = said.deformation};
    return withMaterial(std::move(scene), material);
}

/// The tip is lowered in the middle of the scan until the sample bears the load.
std::optional<TipState> loadedState(const Scene& scene, double load) {
    constexpr double kStart = 10e-9;  // above the surface
    constexpr double kStep = 0.02e-9;
    constexpr int kSteps = 5500;
    EquilibriumMemory memory;
    ClosestPointTracker tracker;
    Vector3 position(0.5 * scene.surface.sizeX(), 0.5 * scene.surface.sizeY(), 0.0);
    const double surface = scene.surface.at(position.x(), position.y()).height;
    for (int step = 0; step < kSteps; ++step) {
        position.z() = surface + kStart - step * kStep;
        const TipState state =
            tipEquilibrium(scene.surface, scene.belief, {.position = position}, memory, tracker);
        if (state.contact.contactRadius > 0.0 && state.normalForce > load) {
            return state;
        }
    }
    return std::nullopt;
}

/// A position where every model is compared.
struct Site {
    const Scene& scene;
    TipState state;
    PatchGrid grid;
};

template <class Make>
double medianTime(int rounds, const Make& make) {
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        const auto start = SteadyClock::now();
        make();
        times.push_back(std::chrono::duration<double>(SteadyClock::now() - start).count());
    }
    return quantile(std::move(times), 0.5);
}

/// The finer half-space on a scan, the closed form on a flat sample; none where neither holds.
std::optional<SurfacePatch> referenceOf(const Site& site, bool flat) {
    if (flat) {
        return exactPatch(site.scene, site.state, DeformationModel::ClosedForm, site.grid);
    }
    constexpr int kFineSamples = 2 * HalfSpaceModel::kSamples;
    HalfSpaceModel model(kFineSamples, {.tolerance = 1e-4});
    const HalfSpaceAnswer answer = model.solve(site.scene, site.state);
    return answer.valid() ? std::optional(halfSpacePatch(site.scene, answer, site.grid))
                          : std::nullopt;
}

void compare(const SurfacePatch& patch, const SurfacePatch& reference, DeformationResult& result) {
    double sum = 0.0;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        const double error = (patch.points[i] - reference.points[i]).norm();
        sum += error * error;
        result.errorMax = std::max(result.errorMax, error);
    }
    const double depth = std::abs(result.indentation);
    result.errorRms = std::sqrt(sum / static_cast<double>(patch.points.size())) / depth;
    result.errorMax /= depth;
    result.compared = true;
}

/// Own force, answer and warm time of the half-space.
void askHalfSpace(const Site& site, int rounds, DeformationResult& result) {
    HalfSpaceModel model;
    const HalfSpaceAnswer answer = model.solve(site.scene, site.state);
    result.halfSpace = answer;
    result.ownForce = answer.force;
    // A frame later the tip is a little deeper; there and back, so that each frame starts from
    // another one.
    TipState other = site.state;
    other.contact.indentation *= 1.02;
    bool back = false;
    result.time = medianTime(rounds, [&] {
        const HalfSpaceAnswer next = model.solve(site.scene, back ? site.state : other);
        back = !back;
        if (next.valid()) {
            (void)halfSpacePatch(site.scene, next, site.grid);
        }
    });
}

DeformationResult resultOf(const Site& site, DeformationModel model,
                           const std::optional<SurfacePatch>& reference, int rounds) {
    const ContactState& contact = site.state.contact;
    DeformationResult result{.material = site.scene.description.sample.material.name,
                             .surface = "",
                             .model = model,
                             .indentation = contact.indentation,
                             .contactRatio = contact.contactRadius / site.scene.belief.tipRadius(),
                             .lawForce = site.state.normalForce,
                             .ownForce = site.state.normalForce};
    SurfacePatch patch;
    result.coldTime =
        medianTime(rounds, [&] { patch = exactPatch(site.scene, site.state, model, site.grid); });
    result.time = result.coldTime;
    if (model == DeformationModel::HalfSpace) {
        askHalfSpace(site, rounds, result);
    }
    if (reference) {
        compare(patch, *reference, result);
    }
    return result;
}

}  // namespace

std::vector<DeformationResult> studyDeformation(const Scene& scene, const DeformationPlan& plan,
                                                Progress* progress) {
    constexpr double kReach = 3.0;  // of a patch in contact radii
    const Scene level = buildScene(scene.description, flatHeights());
    std::vector<DeformationResult> results;
    double done = 0.0;
    for (const SampleMaterial& material : paperMaterials()) {
        for (const bool flat : {true, false}) {
            reportTo(progress, done++ / (2.0 * paperMaterials().size()));
            const Scene there = sceneOf(flat ? level : scene, material);
            const std::optional<TipState> state = loadedState(there, plan.load);
            if (!state) {
                continue;
            }
            const Site site{.scene = there,
                            .state = *state,
                            .grid = {.halfWidth = kReach * state->contact.contactRadius,
                                     .samples = plan.samples}};
            const std::optional<SurfacePatch> reference = referenceOf(site, flat);
            for (const DeformationModel model : kDeformationModels) {
                results.push_back(resultOf(site, model, reference, plan.rounds));
                results.back().surface = flat ? "flat" : "scan";
            }
        }
    }
    return results;
}

}  // namespace asperity
