#pragma once

#include "app/program/LoadedScene.h"
#include "tests/support/TestScenes.h"

namespace asperity::test {

/// A scene that can be recorded, made without a loader.
[[nodiscard]] inline LoadedScene hillyScene() {
    SceneDescription description = plainScene();
    description.sample.file = "hills.gsf";  // a scene file names one; nothing reads it
    return {.scene = buildScene(description, hillyMap())};
}

}  // namespace asperity::test
