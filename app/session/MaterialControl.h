#pragma once

#include "app/session/LibraryControl.h"

namespace asperity {

/// The materials that a sample can be, in the bar above the views and in the scene panel.
class MaterialControl : public LibraryControl {
public:
    MaterialControl(MainWindow& window, RunControl& runs, SceneEdits& edits);
};

}  // namespace asperity
