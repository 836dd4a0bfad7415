#pragma once

#include "app/window/Stage.h"
#include "app/window/live/LivePanels.h"
#include "tests/app/window/HostStandIn.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"
#include "tests/support/Waits.h"

#include <QtTest>

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace asperity::test {

/// A stage whose window is a stand-in, without features: a test adds those that it needs.
class ControlFixture : public ::testing::Test {
protected:
    /// A small scene whose sample is flat.
    void useFlatScene() {
        runs.use({.scene = buildScene(plainScene(), flatMap()),
                  .format = "made for the test",
                  .sha256 = "",
                  .notes = {}});
    }
    /// Shows a recording, by its first tick: a scan of half the size.
    void showRecordingOfOtherScan(const SceneDescription& description = plainScene()) {
        HeightMap other = flatMap();
        other.pitchX *= 0.5;
        other.pitchY *= 0.5;
        runs.showRecording(
            std::make_shared<const LoadedScene>(LoadedScene{.scene = buildScene(description, other),
                                                            .format = "made for the test",
                                                            .sha256 = "",
                                                            .notes = {}}),
            folder.file("recording"), TickSample());
    }
    LiveRun& run() { return *runs.run(); }
    /// Waits for the end of the change under way.
    bool changeEnds() {
        return eventually([this] { return *edits.wanted() == run().scene().description; });
    }
    /// The short message of the bottom line.
    std::string told() { return window.told().toStdString(); }
    /// What must be read; forgets it. Empty: nothing.
    std::string complaint() { return window.takeComplaint().toStdString(); }

    ScratchFolder folder;
    HostStandIn window;
    LivePanels panels{window};
    Stage stage{window, panels};
    RunControl& runs = stage.runs();
    SceneEdits& edits = stage.edits();
};

}  // namespace asperity::test
