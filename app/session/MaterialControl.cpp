#include "app/session/MaterialControl.h"

#include "core/io/scene/SceneFile.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/ScenePanel.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

LibraryKind materialKind() {
    using Scene = SceneDescription;
    return {
        .folder = "materials",
        .noun = LibraryControl::tr("Material"),
        .read =
            [](const auto& file) { return withMaterial(defaultScene(), readMaterialFile(file)); },
        .nameOf =
            [](const Scene& scene, const auto& /*file*/) {
                return QString::fromStdString(scene.sample.material.name).replace('_', ' ');
            },
        .isSame = [](const Scene& a,
                     const Scene& b) { return a.sample.material == b.sample.material; },
        .with = [](const Scene& scene,
                   const Scene& item) { return withMaterial(scene, item.sample.material); },
        .renamed =
            [](const Scene& scene, const std::string& name) {
                SampleMaterial material = scene.sample.material;
                material.name = name;
                return withMaterial(scene, material);
            },
        .textOf =
            [](const Scene& scene, const std::string& notes) {
                return materialText(scene.sample.material, notes);
            }};
}

}  // namespace

MaterialControl::MaterialControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : LibraryControl(window, runs, edits, window.scenePanel().materials(), materialKind()) {
    ControlBar& bar = window.controls();
    connect(&bar, &ControlBar::materialChosen, this, &MaterialControl::choose);
    connect(this, &MaterialControl::listed, &bar, [&bar](const QStringList& names, int present) {
        bar.setMaterials(names);
        bar.setMaterial(present);
    });
    readAll();
}

}  // namespace asperity
