#pragma once

#include "app/session/RunControl.h"
#include "core/scene/SceneParameter.h"

namespace asperity {

/// Changes tip, lever and material of the scene as the window's panel asks for.
class ParameterControl : public QObject {
    Q_OBJECT

public:
    ParameterControl(MainWindow& window, RunControl& runs);

private:
    void change(SceneParameter parameter, double value);
    void show();

    MainWindow& window_;
    RunControl& runs_;
};

}  // namespace asperity
