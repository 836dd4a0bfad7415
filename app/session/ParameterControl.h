#pragma once

#include "app/session/SceneEdits.h"
#include "core/scene/SceneParameter.h"

namespace asperity {

/// Changes tip, lever and material of the scene as the window's panel asks for.
class ParameterControl : public QObject {
    Q_OBJECT

public:
    ParameterControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

private:
    void change(SceneParameter parameter, double value);
    void show();

    MainWindow& window_;
    SceneEdits& edits_;
};

}  // namespace asperity
