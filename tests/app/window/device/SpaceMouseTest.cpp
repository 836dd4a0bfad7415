#include "app/window/study/StudyControl.h"
#include "core/io/experiment/StudyFile.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/app/window/study/ShortStudy.h"
#include "tests/hardware/VirtualSpaceMouse.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QtTest>

namespace asperity::test {
namespace {

using Report = VirtualSpaceMouse::Report;

const Report kPressedDown = {1, 0, 0, 0, 0, 0x5E, 0x01, 0, 0, 0, 0, 0, 0};
const Report kPulledUp = {1, 0, 0, 0, 0, 0xA2, 0xFE, 0, 0, 0, 0, 0, 0};
const Report kAtRest = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

/// The window with the loop, and a SpaceMouse with its own thread: all that runs at once.
class WindowWithSpaceMouse : public Window {
protected:
    VirtualSpaceMouse device;
};

TEST_F(WindowWithSpaceMouse, BringsTheTipIntoContactAndBack) {
    openFlatScene();
    choose("device", "SpaceMouse");
    device.send({kPressedDown});
    ASSERT_TRUE(eventually([this] { return inContact() && number("forceZ") > 2e-9; })) << state();
    device.send({kPulledUp});
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    device.send({kAtRest});
}

TEST_F(WindowWithSpaceMouse, AnUnplugTakesTheForcesAwayUntilAPersonTakesItBack) {
    openFlatScene();
    choose("device", "SpaceMouse");
    device.send({kAtRest});
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    device.unplug();
    ASSERT_TRUE(eventually([this] { return state().starts_with("fault"); })) << state();
    EXPECT_NE(state().find("device not connected"), std::string::npos) << state();
    device.plug();
    ASSERT_TRUE(runsFor(1.5));
    EXPECT_TRUE(state().starts_with("fault")) << "latched";
    QTest::mouseClick(child<QPushButton>("rearm"), Qt::LeftButton);
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
    device.send({kPressedDown});
    EXPECT_TRUE(eventually([this] { return inContact(); })) << state();
}

TEST_F(WindowWithSpaceMouse, ItsTrialButtonBeginsAndEndsTrialsAndItStaysForTheNextOne) {
    const Report down = {3, 1, 0, 0, 0, 0, 0};
    const Report up = {3, 0, 0, 0, 0, 0, 0};
    openFlatScene();
    choose("device", "SpaceMouse");
    device.send({kAtRest});
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    Study study = shortStudy();
    study.scene.settings.trialButton = 0;
    window.menus().entry("study").trigger();
    stage.get<StudyControl>().choice().chooseStudy(writtenStudy(folder, study));
    stage.get<StudyControl>().choice().chooseFolder(folder.path() / "out");
    QTest::mouseClick(child<QPushButton>("startStudy"), Qt::LeftButton);
    auto* action = child<QPushButton>("trialAction");
    for (const char* const next : {"Begin", "Done", "Next", "Begin", "Done", "Next", "Leave"}) {
        ASSERT_TRUE(eventually([&] { return action->text().startsWith(next); }))
            << action->text().toStdString() << " in place of " << next;
        EXPECT_EQ(child<QComboBox>("device")->currentText(), QStringLiteral("SpaceMouse"));
        ASSERT_TRUE(eventually([this] { return state().ends_with("far"); })) << state();
        live(600);  // longer than a study takes no press: a press right after a change is for what
                    // was before
        const QString before = action->text();
        device.send({down});
        // Held until it is seen: on a busy machine a short press may come and go between two ticks.
        ASSERT_TRUE(eventually([&] {
            return action->text() != before || QLatin1String(next) == QLatin1String("Leave");
        })) << next
            << " does nothing";
        device.send({up});
        ASSERT_TRUE(runsFor(0.1));
    }
    EXPECT_EQ(readTrials(folder.path() / "out" / "trials.csv", study).size(), 2U);
}

}  // namespace
}  // namespace asperity::test
