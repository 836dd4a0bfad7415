/// Pictures of deformed surfaces for docs/deformation.md, on samples made up for them: indentation
/// and neck on fine and coarse pixels, the four deformations of one indentation, the exact sphere,
/// and a scan beside what erosion makes of it.
/// Usage: asperity_deformation_pictures OUT_FOLDER

#include "app/commands/VirtualDisplay.h"
#include "app/program/DataFolder.h"
#include "app/program/LoadedScene.h"
#include "app/reports/RunPictures.h"
#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tools/screenshots/PictureTool.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

namespace fs = std::filesystem;

ScanSize square(int pixels, double pitch) {
    return {.columns = pixels, .rows = pixels, .sizeX = pixels * pitch, .sizeY = pixels * pitch};
}

/// Pixels of 0.5 nm, ten across the contact.
HeightMap fineSmooth() {
    return sampledMap(square(256, 0.5_nm),
                      EggBox{.amplitude = 1.5_nm, .periodX = 64.0_nm, .periodY = 64.0_nm});
}

HeightMap fineRough() {
    return selfAffineMap(square(256, 0.5_nm), {.rms = 0.5_nm,
                                               .hurst = 0.8,
                                               .longestWave = 128.0_nm,
                                               .rollOffWave = 60.0_nm,
                                               .shortestWave = 5.0_nm,
                                               .seed = 4});
}

/// Pixels of 40 nm, wider than the whole contact.
HeightMap coarseSmooth() {
    return sampledMap(square(64, 40.0_nm),
                      EggBox{.amplitude = 20.0_nm, .periodX = 640.0_nm, .periodY = 640.0_nm});
}

HeightMap coarseRough() {
    return selfAffineMap(square(64, 40.0_nm), {.rms = 25.0_nm,
                                               .hurst = 0.8,
                                               .longestWave = 2.56_um,
                                               .rollOffWave = 800.0_nm,
                                               .shortestWave = 160.0_nm,
                                               .seed = 6});
}

constexpr double kImagingTip = 20.0_nm;

/// Spheres on a plane, as the imaging tip recorded them.
HeightMap recordedParticles() {
    const ScanSize size = square(256, 1.0_nm);
    return sampledMap(size, Nanoparticles({.count = 6,
                                           .medianRadius = 15.0_nm,
                                           .spread = 0.3,
                                           .smallest = 9.0_nm,
                                           .largest = 22.0_nm,
                                           .scanTipRadius = kImagingTip,
                                           .clearance = 2.0_nm,
                                           .seed = 5},
                                          size));
}

SceneDescription sceneOf(const std::string& material) {
    return readScene(dataFolder() / "scenes" / (material + ".toml"));
}

/// The tip's way down to the sample, along it and away, by the scripted device.
RunEvents approached(const Scene& scene, const PathPlan& plan) {
    RunEventRecorder recorder;
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    runVirtually(scene, slidePath(scene, plan), afm,
                 std::lround(plan.duration / scene.timeStep()) + 1,
                 [&recorder](const TickSample& sample) { recorder.take(sample); });
    return recorder.events();
}

/// A place off the summits, where the surface is tilted.
PathPlan planBesideMiddle(const Scene& scene) {
    PathPlan plan;
    plan.position = Vector2(0.42 * scene.surface.sizeX(), 0.46 * scene.surface.sizeY());
    return plan;
}

void drawContact(const fs::path& path, const Scene& scene, const std::string& sample) {
    const RunEvents events = approached(scene, planBesideMiddle(scene));
    const std::vector<DeformationView> views{
        contactView(scene, events.deepest.value(), "Indentation: " + sample),
        contactView(scene, events.beforePullOff.value(), "Neck: " + sample)};
    writeDeformationPicture(path, views);
}

void drawContacts(const fs::path& out) {
    const SceneDescription soft = sceneOf("polystyrene");
    drawContact(out / "contact_fine_smooth.png", buildScene(soft, fineSmooth()),
                "smooth, 0.5 nm pixels");
    drawContact(out / "contact_fine_rough.png", buildScene(soft, fineRough()),
                "rough, 0.5 nm pixels");
    SceneDescription stiff = sceneOf("silicon_oxide");
    stiff.zoomHalfWidth = 10.0_nm;
    drawContact(out / "contact_coarse_smooth.png", buildScene(stiff, coarseSmooth()),
                "smooth, 40 nm pixels");
    drawContact(out / "contact_coarse_rough.png", buildScene(stiff, coarseRough()),
                "rough, 40 nm pixels");
    drawContact(out / "contact_sphere.png", buildScene(sceneOf("sphere")), "exact sphere");
}

void drawDeformations(const fs::path& path) {
    SceneDescription stiff = sceneOf("silicon_oxide");
    stiff.zoomHalfWidth = 8.0_nm;
    stiff.tip.elastic = {.youngsModulus = 1100.0_GPa, .poissonRatio = 0.07};  // diamond
    Scene scene = buildScene(stiff, fineRough());
    const RunEvents events = approached(scene, planBesideMiddle(scene));
    std::vector<DeformationView> views;
    for (const auto& [model, title] :
         {std::pair(DeformationModel::FourPoint, "(a) Four points"),
          std::pair(DeformationModel::ContactRadius, "(b) Contact radius"),
          std::pair(DeformationModel::ClosedForm, "(c) Closed form"),
          std::pair(DeformationModel::HalfSpace, "(d) Half-space")}) {
        scene.model.deformation = model;
        views.push_back(contactView(scene, events.deepest.value(), title));
        views.back().caption += " Diamond tip.";
    }
    writeDeformationPicture(path, views, {.width = 1500, .height = 1560});
}

void drawErosion(const fs::path& out) {
    SceneDescription description = sceneOf("polystyrene");
    description.sample.imagingTipRadius = kImagingTip;
    description.sample.leveling = {};
    description.sample.smoothingPixels = 1.0;
    for (const bool erode : {false, true}) {
        description.sample.erode = erode;
        const Scene scene = buildScene(description, recordedParticles());
        const std::string title =
            erode ? "The same, that tip taken out" : "As a 20 nm tip recorded it";
        writeOverviewPicture(out / (erode ? "erosion_surface.png" : "erosion_scan.png"),
                             {.title = title,
                              .caption = "Spheres of 9 to 22 nm radius on a plane.",
                              .surface = scene.surface,
                              .tip = {},
                              .zoom = {},
                              .path = {}},
                             {.width = 1000, .height = 800});
    }
}

void draw(const fs::path& out) {
    const VirtualDisplay display;
    drawContacts(out);
    drawDeformations(out / "deformations.png");
    drawErosion(out);
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 1,
                                    "asperity_deformation_pictures OUT_FOLDER",
                                    [](char** arguments) {
                                        asperity::draw(arguments[1]);
                                        return 0;
                                    });
}
