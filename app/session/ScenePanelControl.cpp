#include "app/session/ScenePanelControl.h"

#include "core/Error.h"
#include "core/scene/SceneFieldChange.h"
#include "core/words/FieldWords.h"
#include "ui/panels/ScenePanel.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

ScenePanelControl::ScenePanelControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window), runs_(runs), edits_(edits) {
    ScenePanel& panel = window.scenePanel();
    connect(&panel, &ScenePanel::valueEntered, this, &ScenePanelControl::enter);
    connect(&panel, &ScenePanel::levelingEntered, this, &ScenePanelControl::level);
    connect(&panel, &ScenePanel::openRequested, window.menus().open, &QAction::trigger);
    connect(&panel, &ScenePanel::fidelityRequested, window.menus().fidelity, &QAction::trigger);
    connect(&runs, &RunControl::begun, this, &ScenePanelControl::show);
    connect(&edits, &SceneEdits::changed, this, &ScenePanelControl::show);
}

void ScenePanelControl::enter(const SceneField& field, const SceneValue& value) {
    const SceneDescription* const now = edits_.wanted();
    if (now == nullptr) {
        return;
    }
    try {
        const SceneDescription next =
            withValue(*now, field, value, window_.scenePanel().calibration());
        edits_.change(QString::fromStdString(changeText(field, next)), next,
                      QString::fromStdString(nameOf(field)));
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        show();
    }
}

void ScenePanelControl::level(const LevelingSteps& steps,
                              const std::optional<LevelPoints>& places) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.sample.leveling = steps;
        next.sample.levelPoints = places;
        edits_.change(tr("Leveling: %1").arg(QString::fromStdString(textOf(steps))), next);
    }
}

void ScenePanelControl::show() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        QStringList channels;
        for (const std::string& name : runs_.run()->loaded().channels) {
            channels << QString::fromStdString(name);
        }
        const BSplineSurface& surface = runs_.run()->scene().surface;
        window_.scenePanel().setScanSize({surface.sizeX(), surface.sizeY()});
        window_.scenePanel().setChannels(channels);
        window_.scenePanel().showScene(*scene, defaultsOf(*scene));
    }
}

}  // namespace asperity
