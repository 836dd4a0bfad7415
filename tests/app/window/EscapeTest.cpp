#include "tests/app/window/WindowFixture.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/WindowMenus.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

#include <filesystem>

namespace asperity::test {
namespace {

/// Esc with a device that has motors, without one, and with one that is not there.
class Escape : public Window {
protected:
    bool forcesOn() { return session.run()->settings().forcesOn; }
    QMenu& openedMenu() {
        QMenu& menu = *window.menuBar()->actions().front()->menu();
        menu.popup(window.mapToGlobal({10, 10}));
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&menu));
        return menu;
    }
    QMessageBox& openedMessage() {
        window.complain(QStringLiteral("something to read"));
        auto* box = window.findChild<QMessageBox*>();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(box));
        return *box;
    }
};

TEST_F(Escape, WithoutMotorsItClosesWhatIsOpenAndDoesNothingElse) {
    openFlatScene();
    window.tell(QStringLiteral("as it was"));
    QMenu& menu = openedMenu();
    QTest::keyClick(&menu, Qt::Key_Escape);
    EXPECT_FALSE(menu.isVisible());
    QMessageBox& box = openedMessage();
    QTest::keyClick(&box, Qt::Key_Escape);
    EXPECT_FALSE(box.isVisible());
    for (QWidget* focus : {static_cast<QWidget*>(&window), static_cast<QWidget*>(&window.view()),
                           child<QWidget>("forceGain")}) {
        focus->setFocus();
        QTest::keyClick(focus, Qt::Key_Escape);
        EXPECT_TRUE(forcesOn());
    }
    EXPECT_EQ(told(), "as it was");
    EXPECT_TRUE(window.menus().forcesOff->shortcut().isEmpty());
    EXPECT_EQ(text("hint").find("Esc"), std::string::npos);
}

TEST_F(Escape, WithMotorsItIsTheEmergencyStopFromAnyFocusAndTheStatusLineSaysSo) {
    openFlatScene();
    choose("hand", "Simulated device");
    EXPECT_EQ(window.menus().forcesOff->shortcut(), QKeySequence(Qt::Key_Escape));
    EXPECT_NE(text("hint").find("Esc: forces off"), std::string::npos);
    window.fidelity().show();
    QWidget& menu = openedMenu();
    QWidget& box = openedMessage();
    for (QWidget* focus :
         {&menu, &box, static_cast<QWidget*>(&window), static_cast<QWidget*>(&window.view()),
          child<QWidget>("forceGain"), static_cast<QWidget*>(&window.fidelity())}) {
        session.runs().setForces(true);
        ASSERT_TRUE(forcesOn());
        QTest::keyClick(focus, Qt::Key_Escape);
        EXPECT_FALSE(forcesOn()) << focus->metaObject()->className();
        EXPECT_TRUE(told().starts_with("Forces are off")) << told();
    }
    choose("hand", "Mouse and keyboard");
    EXPECT_TRUE(window.menus().forcesOff->shortcut().isEmpty());
}

TEST_F(Escape, ADeviceThatIsNotThereLeavesNoFaultAndNoFiles) {
    openFlatScene();
    QSignalSpy saved(&session.recordings(), &RecordingControl::lastSecondsSaved);
    choose("hand", "SpaceMouse");
    ASSERT_TRUE(eventually([this] { return state().starts_with("fault"); })) << state();
    EXPECT_EQ(told(), "no SpaceMouse is plugged in");
    live(200);
    choose("hand", "Mouse and keyboard");
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
    live(200);
    EXPECT_TRUE(far()) << state();
    EXPECT_TRUE(forcesOn());
    EXPECT_EQ(saved.count(), 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "recordings"));
}

TEST_F(Escape, ADeviceThatIsNotThereTakesNoForcesFromTheNextScene) {
    openFlatScene();
    choose("hand", "SpaceMouse");
    ASSERT_TRUE(eventually([this] { return state().starts_with("fault"); })) << state();
    openFlatScene();
    EXPECT_TRUE(forcesOn());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "recordings"));
}

}  // namespace
}  // namespace asperity::test
