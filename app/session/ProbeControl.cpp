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

}  // namespace

ProbeControl::ProbeControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : LibraryControl(window, runs, edits, window.scenePanel().probes(), "probes", tr("Probe")) {
    readAll();
}

SceneDescription ProbeControl::read(const std::filesystem::path& file) const {
    return withProbe(defaultScene(), readProbe(file));
}

/// A probe says no name.
QString ProbeControl::nameOf(const SceneDescription& /*scene*/,
                             const std::filesystem::path& file) const {
    return file.empty() ? tr("of this scene")
                        : QString::fromStdString(file.stem().string()).replace('_', ' ');
}

bool ProbeControl::isSame(const SceneDescription& a, const SceneDescription& b) const {
    return a.probe == b.probe && a.detector == b.detector;
}

SceneDescription ProbeControl::with(const SceneDescription& scene,
                                    const SceneDescription& item) const {
    return withProbe(scene, {item.probe, item.detector});
}

SceneDescription ProbeControl::renamed(SceneDescription scene, const std::string& /*name*/) const {
    return scene;
}

std::string ProbeControl::textOf(const SceneDescription& scene, const std::string& notes) const {
    return probeText({scene.probe, scene.detector}, notes);
}

}  // namespace asperity
