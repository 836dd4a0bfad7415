#pragma once

#include "app/session/LibraryControl.h"

namespace asperity {

/// The cantilevers with their calibration that a scene can have, in the scene panel.
class ProbeControl : public LibraryControl {
public:
    ProbeControl(MainWindow& window, RunControl& runs, SceneEdits& edits);
};

}  // namespace asperity
