#pragma once

#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"
#include "core/scene/SceneFields.h"

#include <optional>

namespace asperity {

/// The page that shows all keys of the scene and changes them.
class ScenePanelControl : public QObject {
    Q_OBJECT

public:
    ScenePanelControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

private:
    void enter(const SceneField& field, const SceneValue& value);
    void level(const LevelingSteps& steps, const std::optional<LevelPoints>& places);
    void show();

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
};

}  // namespace asperity
