#include "app/window/fidelity/FidelityPanel.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/OpenControl.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/window/WindowFixture.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QWindow>
#include <QtTest>

#include <filesystem>
#include <vector>

namespace asperity::test {
namespace {

/// Esc with a device that has motors, without one, and with one that is not there.
class Escape : public Window {
protected:
    bool forcesOn() { return stage.run()->settings().forcesOn; }
    QMenu& openedMenu() {
        QMenu& menu = *window.menuBar()->actions().front()->menu();
        menu.popup(window.mapToGlobal({10, 10}));
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&menu));
        return menu;
    }
    std::vector<QWidget*> tools() { return {window.findChild<FidelityPanel*>()}; }
    void openTools() {
        for (QWidget* tool : tools()) {
            tool->show();
            EXPECT_TRUE(QTest::qWaitForWindowExposed(tool));
        }
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
    for (QWidget* focus : {static_cast<QWidget*>(&window), static_cast<QWidget*>(&panels.view()),
                           child<QWidget>("forceGain")}) {
        focus->setFocus();
        QTest::keyClick(focus, Qt::Key_Escape);
        EXPECT_TRUE(forcesOn());
    }
    EXPECT_EQ(told(), "as it was");
    EXPECT_TRUE(window.menus().entry("forcesOff").shortcut().isEmpty());
    EXPECT_EQ(text("hint").find("Esc"), std::string::npos);
}

TEST_F(Escape, WithMotorsItIsTheEmergencyStopFromAnyFocusAndTheStatusLineSaysSo) {
    openFlatScene();
    choose("device", "Simulated device");
    EXPECT_EQ(window.menus().entry("forcesOff").shortcut(), QKeySequence(Qt::Key_Escape));
    EXPECT_NE(text("hint").find("Esc: forces off"), std::string::npos);
    window.findChild<FidelityPanel*>()->show();
    QWidget& menu = openedMenu();
    QWidget& box = openedMessage();
    for (QWidget* focus :
         {&menu, &box, static_cast<QWidget*>(&window), static_cast<QWidget*>(&panels.view()),
          child<QWidget>("forceGain"), static_cast<QWidget*>(window.findChild<FidelityPanel*>())}) {
        stage.runs().setForces(true);
        ASSERT_TRUE(forcesOn());
        QTest::keyClick(focus, Qt::Key_Escape);
        EXPECT_FALSE(forcesOn()) << focus->metaObject()->className();
        EXPECT_TRUE(told().starts_with("Forces are off")) << told();
    }
    choose("device", "Mouse and keyboard");
    EXPECT_TRUE(window.menus().entry("forcesOff").shortcut().isEmpty());
}

TEST_F(Escape, WithoutMotorsItClosesTheActiveToolWindowAndDoesNothingElse) {
    openFlatScene();
    window.tell(QStringLiteral("as it was"));
    for (QWidget* tool : tools()) {
        for (QWidget* focus : {tool, static_cast<QWidget*>(tool->findChild<QAbstractSpinBox*>())}) {
            openTools();
            QApplication::setActiveWindow(tool);
            focus->setFocus();
            QTest::keyClick(focus, Qt::Key_Escape);
            EXPECT_FALSE(tool->isVisible());
            for (QWidget* other : tools()) {
                EXPECT_TRUE(other == tool || other->isVisible());
            }
            EXPECT_TRUE(window.isVisible());
            EXPECT_TRUE(forcesOn());
        }
    }
    EXPECT_EQ(told(), "as it was");
    openTools();
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&panels.view(), Qt::Key_Escape);
    for (const QWidget* tool : tools()) {
        EXPECT_TRUE(tool->isVisible()) << "another window is active";
    }
}

TEST_F(Escape, ANumberHalfTypedDoesNotCountWhenItClosesTheWindow) {
    openFlatScene();
    const LiveRun* run = stage.run();
    openTools();
    QApplication::setActiveWindow(window.findChild<FidelityPanel*>());
    auto& box = *window.findChild<FidelityPanel*>()->findChild<QAbstractSpinBox*>(
        QStringLiteral("tolerance"));
    const QString before = box.text();
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("30"));
    QTest::keyClick(&box, Qt::Key_Escape);
    EXPECT_FALSE(window.findChild<FidelityPanel*>()->isVisible());
    EXPECT_EQ(stage.run(), run) << "the scene goes on";
    EXPECT_EQ(box.text(), before);
}

/// Side of a scan that is still being loaded when a test looks [pixel].
constexpr int kLongLoaded = 4096;

TEST_F(Escape, ClosingAToolWindowCancelsNoLoading) {
    openFlatScene();
    openTools();
    QSignalSpy canceled(&stage.get<SceneControl>(), &SceneControl::openCanceled);
    stage.get<SceneControl>().open(levelScan(folder, kLongLoaded));
    ASSERT_TRUE(eventually([this] { return window.menus().entry("cancelLoading").isEnabled(); }));
    QApplication::setActiveWindow(window.findChild<FidelityPanel*>());
    QTest::keyClick(window.findChild<FidelityPanel*>(), Qt::Key_Escape);
    EXPECT_FALSE(window.findChild<FidelityPanel*>()->isVisible());
    EXPECT_TRUE(window.menus().entry("cancelLoading").isEnabled());
    EXPECT_EQ(canceled.count(), 0);
}

TEST_F(Escape, PuttingAnEnlargedPanelBackCancelsNoLoading) {
    openFlatScene();
    window.layout().maximizer().toggle(*window.cards().front());
    stage.get<SceneControl>().open(levelScan(folder, kLongLoaded));
    ASSERT_TRUE(eventually([this] { return window.menus().entry("cancelLoading").isEnabled(); }));
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_FALSE(window.isPanelEnlarged());
    EXPECT_TRUE(window.menus().entry("cancelLoading").isEnabled());
}

TEST_F(Escape, WithMotorsItStopsTheForcesFromAToolWindowWhichStaysOpen) {
    openFlatScene();
    choose("device", "Simulated device");
    openTools();
    for (QWidget* tool : tools()) {
        stage.runs().setForces(true);
        QApplication::setActiveWindow(tool);
        QTest::keyClick(tool->findChild<QAbstractSpinBox*>(), Qt::Key_Escape);
        EXPECT_FALSE(forcesOn());
        EXPECT_TRUE(tool->isVisible());
    }
}

TEST_F(Escape, ADeviceThatIsNotThereLeavesNoFaultAndNoFiles) {
    openFlatScene();
    QSignalSpy saved(&stage.get<RecordingControl>(), &RecordingControl::lastSecondsSaved);
    choose("device", "SpaceMouse");
    ASSERT_TRUE(eventually([this] { return state().starts_with("fault"); })) << state();
    EXPECT_EQ(told(), "no SpaceMouse is plugged in");
    ASSERT_TRUE(runsFor(0.2));
    choose("device", "Mouse and keyboard");
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
    ASSERT_TRUE(runsFor(0.2));
    EXPECT_TRUE(far()) << state();
    EXPECT_TRUE(forcesOn());
    EXPECT_EQ(saved.count(), 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "recordings"));
}

TEST_F(Escape, ADeviceThatIsNotThereTakesNoForcesFromTheNextScene) {
    openFlatScene();
    choose("device", "SpaceMouse");
    ASSERT_TRUE(eventually([this] { return state().starts_with("fault"); })) << state();
    openFlatScene();
    EXPECT_TRUE(forcesOn());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "recordings"));
}

/// An open list has Esc for itself: no dialog closes, no tool ends, no page is restored.
TEST_F(Escape, ClosesAnOpenListAndNothingElse) {
    openFlatScene();
    window.menus().entry("profile").trigger();
    ASSERT_NE(panels.overview().map().activeTool(), nullptr);
    window.menus().entry("open").trigger();
    ASSERT_NE(stage.get<OpenControl>().dialog(), nullptr);
    QDialog& dialog = *stage.get<OpenControl>().dialog();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    std::vector<QComboBox*> lists;
    for (QComboBox* list : dialog.findChildren<QComboBox*>()) {
        if (list->isVisible() && list->isEnabled() && list->count() > 1) {
            lists.push_back(list);
        }
    }
    ASSERT_FALSE(lists.empty());
    for (QComboBox* list : lists) {
        list->showPopup();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(list->view()->window()));
        QTest::keyClick(dialog.windowHandle(), Qt::Key_Escape);  // as the desktop sends it
        EXPECT_FALSE(list->view()->isVisible()) << list->objectName().toStdString();
        EXPECT_TRUE(dialog.isVisible()) << list->objectName().toStdString();
    }
    dialog.reject();
    auto* material = child<QComboBox>("material");
    const auto closeMaterials = [&] {
        material->showPopup();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(material->view()->window()));
        QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
        EXPECT_FALSE(material->view()->isVisible());
    };
    closeMaterials();
    EXPECT_NE(panels.overview().map().activeTool(), nullptr) << "the tool goes on";
    window.layout().maximizer().toggle(*window.cards().front());
    closeMaterials();
    EXPECT_TRUE(window.isPanelEnlarged());
    QApplication::setActiveWindow(&window);
    QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
    EXPECT_FALSE(window.isPanelEnlarged()) << "no list is open";
}

TEST_F(Escape, EndsTheTypingInAListAndNoTool) {
    openFlatScene();
    auto* list = new QListWidget;
    list->addItem(QStringLiteral("a name"));
    list->item(0)->setFlags(list->item(0)->flags() | Qt::ItemIsEditable);
    window.addTool(list, QStringLiteral("List"));
    window.menus().entry("profile").trigger();
    window.showTool(list);
    QApplication::setActiveWindow(&window);
    list->setFocus();
    list->editItem(list->item(0));
    auto* line = list->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    ASSERT_TRUE(line->hasFocus());
    QTest::keyClick(line, Qt::Key_Escape);
    EXPECT_NE(panels.overview().map().activeTool(), nullptr);
    EXPECT_TRUE(eventually([list] { return list->findChild<QLineEdit*>() == nullptr; }));
    QTest::keyClick(list, Qt::Key_Escape);
    EXPECT_EQ(panels.overview().map().activeTool(), nullptr) << "nothing else is open";
}

}  // namespace
}  // namespace asperity::test
