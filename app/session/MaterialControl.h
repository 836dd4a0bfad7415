#pragma once

#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"

#include <vector>

namespace asperity {

/// The list of materials of the window, and which of them the sample is.
class MaterialControl : public QObject {
    Q_OBJECT

public:
    MaterialControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

private:
    void readMaterials();
    void choose(int index);
    void show();

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    std::vector<SampleMaterial> materials_;
};

}  // namespace asperity
