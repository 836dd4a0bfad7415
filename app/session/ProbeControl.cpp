#include "app/session/ProbeControl.h"

#include "core/io/scene/ProbeFile.h"
#include "core/scene/SceneFieldChange.h"
#include "ui/panels/ScenePanel.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

SceneDescription withProbe(SceneDescription scene, const ProbeDescription& probe) {
    const SceneDescription before = scene;
    scene.probe = probe.lever;
    scene.detector = probe.detector;
    carryTruth(before, scene);
    return scene;
}

/// A probe says no name.
LibraryKind probeKind() {
    using Scene = SceneDescription;
    return {.folder = "probes",
            .noun = LibraryControl::tr("Probe"),
            .read = [](const auto& file) { return withProbe(defaultScene(), readProbe(file)); },
            .nameOf =
                [](const Scene& /*scene*/, const auto& file) {
                    return file.empty()
                               ? LibraryControl::tr("of this scene")
                               : QString::fromStdString(file.stem().string()).replace('_', ' ');
                },
            .isSame = [](const Scene& a,
                         const Scene& b) { return a.probe == b.probe && a.detector == b.detector; },
            .with =
                [](const Scene& scene, const Scene& item) {
                    return withProbe(scene, {item.probe, item.detector});
                },
            .renamed = [](const Scene& scene, const std::string& /*name*/) { return scene; },
            .textOf =
                [](const Scene& scene, const std::string& notes) {
                    return probeText({scene.probe, scene.detector}, notes);
                }};
}

}  // namespace

ProbeControl::ProbeControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : LibraryControl(window, runs, edits, window.scenePanel().probes(), probeKind()) {
    readAll();
}

}  // namespace asperity
