// What the Device menu does: clutch, guides; and the edge of a device's workspace.

#include "tests/app/window/WindowFixture.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

#include <algorithm>

namespace asperity::test {
namespace {

class DeviceMenu : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        openFlatScene();
    }
    void leadWithDevice() {
        choose("device", "Simulated device");
        ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    }
    Menus& menus() { return window.menus(); }
    Vector3 base() { return stage.run()->basePosition(); }
    Vector3 device() { return stage.run()->devicePosition(); }
    Vector3 deviceForce() { return stage.run()->loop().snapshot().sample.output.deviceForce; }
    /// By its name, as a user finds it.
    QAction& entry(const QString& name) {
        const auto actions = window.menuBar()->findChildren<QAction*>();
        const auto found = std::ranges::find_if(
            actions, [&](QAction* action) { return action->text().remove('&') == name; });
        EXPECT_NE(found, actions.end()) << name.toStdString();
        return **found;
    }
    void chooseGuide(const QString& name) { entry(name).trigger(); }
};

TEST_F(DeviceMenu, AClutchLetsTheDeviceMoveAndTheTipStay) {
    leadWithDevice();
    menus().entry("clutch").trigger();
    ASSERT_TRUE(eventually([this] { return state().starts_with("clutch"); })) << state();
    const Vector3 tip = base();
    const Vector3 before = device();
    press(Qt::Key_Right);
    ASSERT_TRUE(eventually([&] { return (device() - before).norm() > 5e-3; }));
    release(Qt::Key_Right);
    ASSERT_TRUE(runsFor(0.3));
    EXPECT_LT((base() - tip).norm(), 0.05e-9);
    menus().entry("clutch").trigger();
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << "comes on anew: " << state();
    EXPECT_LT((base() - tip).norm(), 0.05e-9) << "an encoder's step or two";
}

TEST_F(DeviceMenu, AGuideHoldsTheTipBack) {
    leadWithDevice();
    const double height = base().z();
    chooseGuide("Horizontal plane through the tip");
    ASSERT_TRUE(runsFor(0.7));
    press(Qt::Key_PageUp);
    ASSERT_TRUE(eventually([this] { return deviceForce().z() < -0.3; })) << deviceForce().z();
    release(Qt::Key_PageUp);
    ASSERT_TRUE(runsFor(0.5));
    // The guide's 200 N/m and the grip's 150 N/m part the way; without a guide the tip rises with
    // the device.
    const double asked = -deviceForce().z() / 200.0 * 1e-6;
    EXPECT_NEAR(base().z() - height, asked, 0.3 * asked);
    chooseGuide("None");
    EXPECT_TRUE(eventually([this] { return deviceForce().norm() < 0.05; })) << deviceForce().norm();
}

/// They could be chosen and did nothing.
TEST_F(DeviceMenu, EntriesThatADeviceCannotServeAreDisabledAndSayWhy) {
    const QAction& guide = entry("Point at the tip");
    EXPECT_FALSE(guide.isEnabled());
    EXPECT_TRUE(guide.toolTip().startsWith("A guide needs a coupling"));
    EXPECT_TRUE(entry("None").isEnabled());
    for (const QAction* const action :
         {&menus().entry("calibrate"), &menus().entry("followsView")}) {
        EXPECT_FALSE(action->isEnabled()) << action->text().toStdString();
    }
    EXPECT_TRUE(
        menus().entry("followsView").toolTip().startsWith("Mouse and keyboard follow the view"));
    leadWithDevice();
    EXPECT_TRUE(eventually([&] { return guide.isEnabled(); }));
    EXPECT_FALSE(guide.toolTip().startsWith("A guide needs"));
    EXPECT_FALSE(menus().entry("calibrate").isEnabled()) << "it counts from no rest pose";
}

TEST_F(DeviceMenu, TheEdgeOfTheWorkspaceIsFeltAndToldAndAClutchLeadsOn) {
    leadWithDevice();
    press(Qt::Key_Right, Qt::ControlModifier);
    ASSERT_TRUE(eventually([this] {
        return state().find("edge of the workspace: clutch (C)") != std::string::npos;
    })) << state();
    ASSERT_TRUE(runsFor(0.5));
    release(Qt::Key_Right);
    const double edge = device().norm();
    EXPECT_GT(edge, 0.09);
    EXPECT_LT(edge, 0.1);
    const Vector3 tip = base();
    menus().entry("clutch").trigger();
    press(Qt::Key_Left, Qt::ControlModifier);
    ASSERT_TRUE(eventually([this] { return device().norm() < 0.05; }));
    release(Qt::Key_Left);
    ASSERT_TRUE(runsFor(0.3));
    menus().entry("clutch").trigger();
    ASSERT_TRUE(runsFor(0.3));
    EXPECT_LT((base() - tip).norm(), 0.2e-9);
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_TRUE(eventually([&] { return (base() - tip).norm() > 10e-9; }));
    release(Qt::Key_Right);
}

}  // namespace
}  // namespace asperity::test
