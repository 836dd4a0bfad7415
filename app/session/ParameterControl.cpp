#include "app/session/ParameterControl.h"

#include "core/Error.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SceneTruth.h"
#include "ui/panels/ParameterPanel.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

namespace {

/// Before the run ends for it. @throw Error where no scene can be made of the description
void requireScene(const SceneDescription& scene) {
    checkScene(scene);
    static_cast<void>(believedSystem(scene, usualModel(scene)));
    static_cast<void>(truthOf(scene));
}

}  // namespace

ParameterControl::ParameterControl(MainWindow& window, RunControl& runs)
    : window_(window), runs_(runs) {
    connect(&window.parameters(), &ParameterPanel::parameterEntered, this,
            &ParameterControl::change);
    connect(&runs, &RunControl::begun, this, &ParameterControl::show);
}

void ParameterControl::change(SceneParameter parameter, double value) {
    if (runs_.run() == nullptr) {
        return;
    }
    const SceneDescription changed =
        withParameter(runs_.run()->scene().description, parameter, value);
    try {
        requireScene(changed);
        runs_.run()->requireHolding(changed);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        show();
        return;
    }
    runs_.rebuild(
        [&changed](LoadedScene scene) { return withDescription(std::move(scene), changed); });
}

void ParameterControl::show() { window_.parameters().showScene(runs_.run()->scene().description); }

}  // namespace asperity
