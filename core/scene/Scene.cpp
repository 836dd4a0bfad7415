#include "core/scene/Scene.h"

#include "core/surface/BSplineFit.h"
#include "core/surface/GaussianFilter.h"
#include "core/surface/InvalidPixels.h"

namespace asperity {

namespace {

ProbeSystem probeSystem(const SceneDescription& scene, const SampleMaterial& material,
                        const CantileverGeometry& probe) {
    const ContactPair pair{.tipRadius = scene.tip.radius,
                           .reducedModulus = reducedModulus(material.elastic, scene.tip.elastic),
                           .workOfAdhesion = material.workOfAdhesion};
    return {ContactModel(scene.law, pair), Cantilever(probe), material.friction};
}

InstrumentTruth instrumentTruth(const SceneDescription& scene) {
    CantileverGeometry probe = scene.probe;
    probe.thickness = thicknessForStiffness(probe, scene.truth.stiffness);
    const double noise = scene.truth.signalNoise;
    return {.system = probeSystem(scene, scene.truth.material, probe),
            .noise = {.bending = noise, .torsion = noise},
            .seed = scene.truth.noiseSeed};
}

}  // namespace

Scene buildScene(const SceneDescription& description, const HeightMap& map) {
    checkScene(description);
    const HeightMap filled = withInvalidPixelsFilled(levelled(map, description.sample.levelling));
    return {.description = description,
            .removedPlane = fitPlane(map),
            .surface = fitSurface(smoothed(filled, description.sample.smoothingPixels)),
            .belief = probeSystem(description, description.sample.material, description.probe),
            .truth = instrumentTruth(description),
            .signalSigma = {.bending = description.signalSigma, .torsion = description.signalSigma},
            .settings = {.positionGain = description.positionGain,
                         .forceGain = description.forceGain,
                         .correctionBandwidth = description.correctionBandwidth,
                         .forcesOn = true}};
}

}  // namespace asperity
