#include "app/session/MaterialControl.h"

#include "core/io/scene/SceneFile.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/ScenePanel.h"
#include "ui/window/MainWindow.h"

namespace asperity {

MaterialControl::MaterialControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : LibraryControl(window, runs, edits, window.scenePanel().materials(), "materials",
                     tr("Material"))
    , shown_(window) {
    connect(&window.controls(), &ControlBar::materialChosen, this, &MaterialControl::choose);
    readAll();
}

SceneDescription MaterialControl::read(const std::filesystem::path& file) const {
    return withMaterial(defaultScene(), readMaterialFile(file));
}

QString MaterialControl::nameOf(const SceneDescription& scene,
                                const std::filesystem::path& /*file*/) const {
    return QString::fromStdString(scene.sample.material.name).replace('_', ' ');
}

bool MaterialControl::isSame(const SceneDescription& a, const SceneDescription& b) const {
    return a.sample.material == b.sample.material;
}

SceneDescription MaterialControl::with(const SceneDescription& scene,
                                       const SceneDescription& item) const {
    return withMaterial(scene, item.sample.material);
}

SceneDescription MaterialControl::renamed(SceneDescription scene, const std::string& name) const {
    SampleMaterial material = scene.sample.material;
    material.name = name;
    return withMaterial(std::move(scene), material);
}

std::string MaterialControl::textOf(const SceneDescription& scene, const std::string& notes) const {
    return materialText(scene.sample.material, notes);
}

void MaterialControl::listed(const QStringList& names, int present) {
    shown_.controls().setMaterials(names);
    shown_.controls().setMaterial(present);
}

}  // namespace asperity
