#pragma once

#include "app/window/Stage.h"
#include "app/window/lab/Features.h"
#include "app/window/live/LivePanels.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"
#include "tests/support/Waits.h"
#include "ui/shell/MainWindow.h"

#include <QString>
#include <QWidget>

#include <gtest/gtest.h>

#include <string>

namespace asperity::test {

/// A file of level heights, side x side pixels of 1 nm.
[[nodiscard]] std::filesystem::path levelScan(ScratchFolder& folder, int side);

/// A main window with its features.
struct WholeWindow {
    /// @param framePeriod from one frame to the next [ms]
    explicit WholeWindow(int framePeriod) {
        addFeatures(stage);
        stage.play(framePeriod);
    }

    MainWindow window;
    LivePanels panels{window};
    Stage stage{window, panels};
};

/// The real window with its features, on a display. Tests act by mouse and key events, and read
/// what the window shows.
class Window : public ::testing::Test {
protected:
    /// Lets the window live for a while, where nothing tells what it does.
    static void live(int milliseconds);
    /// Waits until two frames have shown ticks that were made meanwhile; the loop is running.
    [[nodiscard]] bool framesPass();
    /// Waits until the loop has run for so long, by the time of its ticks, and frames have shown
    /// it; the loop is running. [s]
    [[nodiscard]] bool runsFor(double seconds);
    /// Waits until the base of the tip has not moved for 0.2 s of ticks; the loop is running.
    [[nodiscard]] bool baseRests();

    void SetUp() override;

    /// Opens a small scene whose sample is flat and waits until it runs.
    void openFlatScene(const SceneDescription& description = plainScene());

    template <typename Widget>
    Widget* child(const char* name) {
        auto* found = window.findChild<Widget*>(QString::fromUtf8(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    /// What a label shows.
    std::string text(const char* label);
    /// The number a label shows, in SI units; NaN when it shows none.
    double number(const char* label);
    /// What the window says of the tip, faults and forces.
    std::string state() { return text("state"); }
    [[nodiscard]] bool inContact() { return state().starts_with("in contact"); }
    [[nodiscard]] bool far() { return state().starts_with("far"); }

    /// Chooses an entry of a list of the control bar.
    void choose(const char* list, const QString& entry);
    /// Waits for the end of the change of scene under way.
    bool changeEnds();
    /// Types a number into a knob of the control bar.
    void turn(const char* knob, const QString& number);
    /// The short message of the bottom line.
    std::string told();

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void release(Qt::Key key);
    void drag(const QPoint& from, const QPoint& to);
    void turnWheel(int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

    ScratchFolder folder;
    /// Drawing takes most of a window's processor time: fewer frames than a user's leave it to the
    /// other tests [ms].
    static constexpr int kFramePeriod = 100;

    WholeWindow whole{kFramePeriod};
    MainWindow& window = whole.window;
    LivePanels& panels = whole.panels;
    Stage& stage = whole.stage;

private:
    /// Of the latest tick [s].
    double tickTime();
};

}  // namespace asperity::test
