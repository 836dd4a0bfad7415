#include "app/session/MaterialControl.h"

#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneParameter.h"
#include "ui/panels/ControlBar.h"
#include "ui/window/MainWindow.h"

#include <algorithm>

namespace asperity {

namespace {

/// What the window calls a material.
QString shownName(const SampleMaterial& material) {
    return QString::fromStdString(material.name).replace('_', ' ');
}

}  // namespace

MaterialControl::MaterialControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window), runs_(runs), edits_(edits) {
    readMaterials();
    connect(&window.controls(), &ControlBar::materialChosen, this, &MaterialControl::choose);
    connect(&runs, &RunControl::begun, this, &MaterialControl::show);
    connect(&edits, &SceneEdits::changed, this, &MaterialControl::show);
}

void MaterialControl::readMaterials() {
    for (const std::filesystem::path& file : dataFiles("materials")) {
        try {
            const SceneDescription scene = withMaterial(defaultScene(), readMaterialFile(file));
            checkScene(scene);
            materials_.push_back(scene.sample.material);
        } catch (const Error& error) {
            window_.tell(QString::fromUtf8(error.what()));
        }
    }
}

void MaterialControl::choose(int index) {
    if (const SceneDescription* const now = edits_.wanted()) {
        const SampleMaterial& material = materials_.at(static_cast<std::size_t>(index));
        edits_.change(tr("Material: %1").arg(shownName(material)), withMaterial(*now, material));
    }
}

void MaterialControl::show() {
    const SceneDescription* const scene = edits_.wanted();
    if (scene == nullptr) {
        return;
    }
    const SampleMaterial& own = scene->sample.material;
    if (std::find(materials_.begin(), materials_.end(), own) == materials_.end()) {
        std::erase_if(materials_, [&own](const SampleMaterial& material) {
            return material.name == own.name && own.name.ends_with(kEditedSuffix);
        });
        materials_.push_back(own);
    }
    QStringList names;
    for (const SampleMaterial& material : materials_) {
        names.push_back(shownName(material));
    }
    ControlBar& controls = window_.controls();
    controls.setMaterials(names);
    controls.setMaterial(static_cast<int>(std::find(materials_.begin(), materials_.end(), own) -
                                          materials_.begin()));
}

}  // namespace asperity
