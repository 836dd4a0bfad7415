#pragma once

#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"
#include "tests/support/Waits.h"
#include "ui/window/MainWindow.h"

#include <QMessageBox>
#include <QStatusBar>
#include <QtTest>

#include <gtest/gtest.h>

#include <string>

namespace asperity::test {

/// A window that is not shown and its run, without the session that connects all controls.
class ControlFixture : public ::testing::Test {
protected:
    /// A small scene whose sample is flat.
    void useFlatScene() {
        runs.use({.scene = buildScene(plainScene(), flatMap()),
                  .format = "made for the test",
                  .sha256 = "",
                  .notes = {}});
    }
    LiveRun& run() { return *runs.run(); }
    /// Waits for the end of the change under way.
    bool changeEnds() {
        return eventually([this] { return *edits.wanted() == run().scene().description; });
    }
    /// The short message of the bottom line.
    std::string told() { return window.statusBar()->currentMessage().toStdString(); }
    /// What must be read; closes it. Empty: nothing.
    std::string complaint() {
        auto* box = window.findChild<QMessageBox*>();
        const std::string text = box != nullptr ? box->text().toStdString() : std::string();
        delete box;
        return text;
    }

    ScratchFolder folder;
    MainWindow window;
    RunControl runs{window};
    SceneEdits edits{window, runs};
};

}  // namespace asperity::test
