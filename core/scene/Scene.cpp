#include "core/scene/Scene.h"

#include "core/Error.h"
#include "core/surface/BSplineFit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

ProbeSystem probeSystem(const SceneDescription& scene, const SampleMaterial& material,
                        const CantileverGeometry& probe) {
    const ContactPair pair = contactPair(scene, material);
    return {ContactModel(chooseLaw(scene.law, pair).law, pair, contactOptions(scene, material)),
            Cantilever(probe), material.friction};
}

/// Beyond these bounds a map is no scan of a microscope, and rounding would be all that is left.
void checkMap(const ScanMap& map) {
    constexpr double kSmallestPitch = 1e-13;  // [m]
    constexpr double kLargestLength = 1.0;    // [m]
    if (!(std::min(map.pitchX, map.pitchY) >= kSmallestPitch) ||
        !(std::max(map.sizeX(), map.sizeY()) <= kLargestLength)) {
        throw Error("the scan's pixels must be 0.1 pm or wider and the whole at most 1 m wide");
    }
    const bool tooHigh = std::any_of(map.heights.begin(), map.heights.end(), [&](double height) {
        return std::abs(map.datum + height) > kLargestLength;
    });
    if (tooHigh) {
        throw Error("the scan's heights must lie within 1 m of zero");
    }
}

Smoothing smoothingOf(const SampleDescription& sample, const ScanMap& map) {
    if (sample.smoothingLength != 0.0) {
        return smoothingByLength(sample.smoothingLength, map);
    }
    return {.x = sample.smoothingPixels, .y = sample.smoothingPixels};
}

InstrumentTruth instrumentTruth(const SceneDescription& scene) {
    CantileverGeometry probe = scene.probe;
    probe.thickness = thicknessForStiffness(probe, scene.truth.stiffness);
    const double noise = scene.truth.signalNoise;
    return {.system = probeSystem(scene, scene.truth.material, probe),
            .noise = {.bending = noise, .torsion = noise},
            .seed = scene.truth.noiseSeed,
            .temperature = scene.truth.temperature,
            .timeStep = 1.0 / scene.tickRate};
}

Scene assemble(const SceneDescription& description, const PlaneFit& removedPlane,
               BSplineSurface surface) {
    return {.description = description,
            .removedPlane = removedPlane,
            .surface = std::move(surface),
            .lawChoice =
                chooseLaw(description.law, contactPair(description, description.sample.material)),
            .belief = probeSystem(description, description.sample.material, description.probe),
            .truth = instrumentTruth(description),
            .signalSigma = {.bending = description.signalSigma, .torsion = description.signalSigma},
            .settings = {.positionGain = description.positionGain,
                         .forceGain = description.forceGain,
                         .correctionBandwidth = description.correctionBandwidth,
                         .positionControl = description.positionControl,
                         .forcesOn = true}};
}

}  // namespace

ContactModel contactModelAt(const Scene& scene, const TipState& state) noexcept {
    const double radius = state.effectiveRadius;
    return radius > 0.0 ? scene.belief.contact.withTipRadius(radius) : scene.belief.contact;
}

Scene buildScene(const SceneDescription& description, ScanMap map, Progress* progress) {
    checkScene(description);
    checkMap(map);
    const PlaneFit plane = fitPlane(map);
    reportTo(progress, 0.2);
    map = levelled(std::move(map), description.sample.levelling);
    reportTo(progress, 0.4);
    const Smoothing smoothing = smoothingOf(description.sample, map);
    ProgressPart fit(progress, 0.4, 1.0);
    return assemble(description, plane, fitSurface(std::move(map), smoothing, &fit));
}

Scene buildScene(const SceneDescription& description, const HeightMap& map) {
    return buildScene(description, singlePrecision(map));
}

Scene withMaterial(Scene scene, const SampleMaterial& material) {
    SceneDescription description = scene.description;
    if (description.truth.material == description.sample.material) {
        description.truth.material = material;
    }
    description.sample.material = material;
    checkScene(description);
    return assemble(description, scene.removedPlane, std::move(scene.surface));
}

}  // namespace asperity
