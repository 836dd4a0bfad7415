#include "core/scene/Scene.h"

#include "core/Error.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/SimulatedAfm.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/ShapeSample.h"
#include "core/scene/TipValidity.h"
#include "core/surface/HeightMap.h"
#include "core/surface/HeightMoments.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/imaging/TipErosion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

double datumOf(const HeightMap& /*map*/) { return 0.0; }
double datumOf(const ScanMap& map) { return map.datum; }

/// Beyond these bounds a map is no scan of a microscope, and rounding would be all that is left.
template <class Map>
void checkMap(const Map& map) {
    constexpr double kMinPitch = 1e-13;  // [m]
    constexpr double kMaxLength = 1.0;   // [m]
    if (!(std::min(map.pitchX, map.pitchY) >= kMinPitch) ||
        !(std::max(map.sizeX(), map.sizeY()) <= kMaxLength)) {
        throw Error("the scan's pixels must be 0.1 pm or wider and the whole at most 1 m wide");
    }
    const bool tooHigh = std::any_of(map.heights.begin(), map.heights.end(), [&](double height) {
        return std::abs(datumOf(map) + height) > kMaxLength;
    });
    if (tooHigh) {
        throw Error("the scan's heights must lie within 1 m of zero");
    }
}

/// The sample as made from a height map.
struct PreparedSample {
    std::vector<RemovedByStep> removed;
    BSplineSurface surface;
    CertaintyMap certainty;
    ScanSmoothing smoothing;
    std::optional<NurbsSurface> shape = std::nullopt;
    std::shared_ptr<const HeightMoments> moments = nullptr;  ///< where they are known already
};

/// Returns what is known of the surface under the image that a tip recorded: the image itself
/// unless the scene says that the tip's shape is to be taken out.
template <class Map>
BasicTipReconstruction<Map> surfaceUnder(const SampleDescription& sample, Map image,
                                         Progress* progress) {
    if (sample.erode) {
        return reconstructed(std::move(image), sample.imagingTipRadius, progress,
                             TouchedPoint::BetweenPixels);
    }
    std::vector<std::uint8_t> certain = certainPixels(image, sample.imagingTipRadius, progress);
    return {std::move(image), std::move(certain)};
}

/// Smoothing goes before erosion, which would take every dip of the noise for the surface.
template <class Map>
PreparedSample prepared(const SceneDescription& scene, LeveledMap<Map> level, Progress* progress) {
    const SampleDescription& sample = scene.sample;
    const ScanSmoothing smoothing = smoothingFor(scene, level.map);
    ProgressPart smoothingPart(progress, 0.0, 0.2);
    Map map =
        smoothed(withInvalidPixelsFilled(std::move(level.map)), smoothing.width, &smoothingPart);
    ProgressPart eroding(progress, 0.2, 0.8);
    BasicTipReconstruction<Map> known = surfaceUnder(sample, std::move(map), &eroding);
    CertaintyMap certainty(known.surface, known.certain);
    ProgressPart fitting(progress, 0.8, 1.0);
    return {std::move(level.removed), fitSurface(std::move(known.surface), {}, &fitting),
            std::move(certainty), smoothing};
}

template <class Map>
PreparedSample prepareSample(const SceneDescription& scene, Map map, Progress* progress) {
    const SampleDescription& sample = scene.sample;
    ProgressPart leveling(progress, 0.0, 0.4);
    LeveledMap<Map> level =
        leveledInSteps(std::move(map), sample.leveling, sample.levelPoints, &leveling);
    ProgressPart rest(progress, 0.4, 1.0);
    if (sample.imagingTipRadius > 0.0) {
        return prepared(scene, std::move(level), &rest);
    }
    const ScanSmoothing smoothing = smoothingFor(scene, level.map);
    return {std::move(level.removed),
            fitSurface(std::move(level.map), smoothing.width, &rest),
            {},
            smoothing};
}

/// Returns the smoothing of a scene's surface, but for the width, which its description states.
ScanSmoothing keptSmoothing(const Scene& scene) {
    return {.width = {},
            .heightNoise = scene.heightNoise,
            .curvatureNoise = scene.curvatureNoise,
            .choice = scene.smoothing};
}

/// With the model's friction or none.
std::shared_ptr<const MaterialField> believedField(const Scene& scene) {
    const SceneDescription& description = scene.description;
    MaterialMaps maps = scene.maps.sample;
    if (!scene.model.friction) {
        maps.friction = nullptr;
    }
    return materialField(std::move(maps), description.sample.material, scene.belief.friction,
                         description.tip.elastic);
}

/// Finds whether the sample beside contacts attracts the tip: the instrument has it where it does,
/// the model where the scene says so, or where nothing else is said and the law has a tail.
/// @param known moments of the surface; null: not yet
void findBodyAttraction(Scene& scene, std::shared_ptr<const HeightMoments> known) {
    const std::optional<bool> said = scene.description.choices.bodyAttraction;
    const bool isBlunt = !scene.shape && isBluntTip(scene.surface, scene.truth);
    if (isBlunt || said == true) {
        scene.moments = known ? std::move(known) : std::make_shared<HeightMoments>(scene.surface);
    }
    const bool attracts =
        isBlunt && isAttractedBeside(*scene.moments, scene.truth, scene.description.tolerance);
    scene.truth.beside = attracts || said == true ? scene.moments : nullptr;
    scene.model.bodyAttraction = said.value_or(attracts && hasTail(scene.model.law));
    scene.belief.beside = scene.model.bodyAttraction ? scene.moments : nullptr;
}

/// As the estimator takes it: what the detector leaves, and the lever's end that heat shakes.
LeverSignals signalDeviation(const SceneDescription& description) {
    const FlexuralMode shaken = flexuralMode(description.probe, 1);
    const double heat =
        shaken.endSlope * thermalDeviation(description.truth.temperature, shaken.stiffness);
    return {.bending = std::hypot(description.signalSigma, heat),
            .torsion = description.signalSigma};
}

/// The description of the scene states a low-pass that was chosen.
Scene assemble(SceneDescription description, PreparedSample sample, const SceneMaps& read) {
    if (sample.smoothing.choice && leavesSmoothing(description.sample)) {
        description.sample.smoothingPixels = sample.smoothing.choice->pixels;
    }
    SampleMaterial& believed = description.sample.material;
    SampleMaterial& actual = description.truth.material;
    const SceneMaps maps{.sample = mapsOf(believed, read.sample, "[sample]"),
                         .truth = mapsOf(actual, read.truth, "[truth]"),
                         .curve = read.curve};
    if (description.truth.curve.empty() != (maps.curve == nullptr)) {
        throw Error("[truth]: the instrument's curve is not the one that was read");
    }
    believed = withLargest(std::move(believed), maps.sample);
    actual = withLargest(std::move(actual), maps.truth);
    checkScene(description);
    const ForceModelOptions model = usualModel(description);
    Scene scene{.description = description,
                .removedBySteps = sample.removed,
                .removedPlane = sumOfPlanes(sample.removed),
                .surface = std::move(sample.surface),
                .certainty = std::move(sample.certainty),
                .heightNoise = sample.smoothing.heightNoise,
                .curvatureNoise = sample.smoothing.curvatureNoise,
                .smoothing = sample.smoothing.choice,
                .shape = std::move(sample.shape),
                .maps = maps,
                .model = model,
                .belief = believedSystem(description, model),
                .truth = trueSystem(description),
                .signalSigma = signalDeviation(description),
                .normalDeviation = description.uncertainty.normalDeviation(),
                .settings = description.settings};
    scene.belief.field = believedField(scene);
    scene.truth.field =
        materialField(maps.truth, actual, scene.truth.friction, description.tip.elastic);
    findBodyAttraction(scene, std::move(sample.moments));
    return scene;
}

template <class Map>
Scene sceneOn(const SceneDescription& description, Map map, Progress* progress,
              const SceneMaps& maps) {
    checkScene(description);
    checkMap(map);
    return assemble(description, prepareSample(description, std::move(map), progress), maps);
}

bool haveSameSurface(SampleDescription a, const SampleDescription& b) {
    a.material = b.material;
    return a == b;
}

bool haveSameMaps(const SceneDescription& a, const SceneDescription& b) {
    return a.sample.material.maps == b.sample.material.maps &&
           a.truth.material.maps == b.truth.material.maps && a.truth.curve == b.truth.curve &&
           a.truth.curveStiffness == b.truth.curveStiffness;
}

}  // namespace

ContactModel contactModelAt(const ProbeSystem& system, const TipState& state) noexcept {
    const double radius = state.effectiveRadius;
    if (!(radius > 0.0)) {
        return system.contact;
    }
    ContactModel model = system.contact.withPair(system.pairAt(state.closest.point, radius));
    model.setBodyPull(state.body);
    return model;
}

ContactModel contactModelAt(const Scene& scene, const TipState& state) noexcept {
    return contactModelAt(scene.belief, state);
}

Scene buildScene(const SceneDescription& description, ScanMap map, Progress* progress,
                 const SceneMaps& maps) {
    return sceneOn(description, std::move(map), progress, maps);
}

Scene buildScene(const SceneDescription& description, HeightMap map, Progress* progress,
                 const SceneMaps& maps) {
    return sceneOn(description, std::move(map), progress, maps);
}

Scene buildScene(const SceneDescription& description, const SceneMaps& maps) {
    checkScene(description);
    if (!description.sample.shape) {
        throw Error("[sample]: a scene without a height map needs a shape");
    }
    const ShapeDescription& shape = *description.sample.shape;
    return assemble(description, {{}, fitSurface(shapeMap(shape)), {}, {}, shapeSurface(shape)},
                    maps);
}

Scene withMaterial(Scene scene, const SampleMaterial& material) {
    const ScanSmoothing smoothing = keptSmoothing(scene);
    const SceneDescription description = withMaterial(scene.description, material);
    checkScene(description);
    return assemble(description,
                    {std::move(scene.removedBySteps), std::move(scene.surface),
                     std::move(scene.certainty), smoothing, std::move(scene.shape),
                     std::move(scene.moments)},
                    scene.maps);
}

Scene withDescription(const Scene& scene, const SceneDescription& description) {
    checkScene(description);
    SceneDescription next = description;
    if (leavesSmoothing(next.sample)) {
        next.sample.smoothingPixels = scene.description.sample.smoothingPixels;
        next.sample.smoothingLength = scene.description.sample.smoothingLength;
    }
    return assemble(std::move(next),
                    {scene.removedBySteps, scene.surface, scene.certainty, keptSmoothing(scene),
                     scene.shape, scene.moments},
                    scene.maps);
}

void setModel(Scene& scene, const ForceModelOptions& model) {
    scene.belief = believedSystem(scene.description, model);
    scene.model = model;
    scene.leftOut.reset();
    scene.belief.field = believedField(scene);
    scene.belief.beside = model.bodyAttraction ? scene.moments : nullptr;
}

SceneChange changeBetween(const SceneDescription& from, const SceneDescription& to) {
    if (from == to) {
        return SceneChange::None;
    }
    if (!haveSameSurface(from.sample, to.sample) || !haveSameMaps(from, to)) {
        return SceneChange::Surface;
    }
    SceneDescription shown = from;
    adoptShown(shown, to);
    // The one deviation that the tick reads.
    const bool isSameEstimate =
        from.uncertainty.normalDeviation() == to.uncertainty.normalDeviation();
    return shown == to && isSameEstimate ? SceneChange::Shown : SceneChange::Model;
}

void adoptShown(SceneDescription& scene, const SceneDescription& from) {
    scene.setpoint = from.setpoint;
    scene.zoomHalfWidth = from.zoomHalfWidth;
    scene.uncertainty = from.uncertainty;
    scene.markers = from.markers;
    scene.settings = from.settings;
}

}  // namespace asperity
