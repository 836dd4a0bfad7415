// What the Hand menu does: clutch, guides; and the edge of a device's workspace.

#include "tests/app/window/WindowFixture.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

namespace asperity::test {
namespace {

class DeviceMenu : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        openFlatScene();
    }
    void leadWithDevice() {
        choose("hand", "Simulated device");
        ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    }
    WindowMenus& menus() { return window.menus(); }
    Vector3 base() { return session.run()->basePosition(); }
    Vector3 device() { return session.run()->devicePosition(); }
    Vector3 deviceForce() { return session.run()->loop().snapshot().sample.output.deviceForce; }
    /// By the entry's name, as a user would.
    void chooseGuide(const QString& name) {
        for (QAction* const action : window.menuBar()->findChildren<QAction*>()) {
            if (action->text().remove('&') == name) {
                action->trigger();
                return;
            }
        }
        FAIL() << name.toStdString();
    }
};

TEST_F(DeviceMenu, AClutchLetsTheDeviceMoveAndTheTipStay) {
    leadWithDevice();
    menus().clutch->trigger();
    ASSERT_TRUE(eventually([this] { return state().starts_with("clutch"); })) << state();
    const Vector3 tip = base();
    const Vector3 before = device();
    press(Qt::Key_Right);
    ASSERT_TRUE(eventually([&] { return (device() - before).norm() > 5e-3; }));
    release(Qt::Key_Right);
    live(300);
    EXPECT_LT((base() - tip).norm(), 0.05e-9);
    menus().clutch->trigger();
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << "comes on anew: " << state();
    EXPECT_LT((base() - tip).norm(), 0.05e-9) << "an encoder's step or two";
}

TEST_F(DeviceMenu, AGuideHoldsTheTipBack) {
    leadWithDevice();
    const double height = base().z();
    chooseGuide("Level plane through the tip");
    live(700);
    press(Qt::Key_PageUp);
    ASSERT_TRUE(eventually([this] { return deviceForce().z() < -0.3; })) << deviceForce().z();
    release(Qt::Key_PageUp);
    live(500);
    // The guide's 200 N/m and the grip's 150 N/m part the way; without a guide the tip rises with
    // the device.
    const double asked = -deviceForce().z() / 200.0 * 1e-6;
    EXPECT_NEAR(base().z() - height, asked, 0.3 * asked);
    chooseGuide("None");
    EXPECT_TRUE(eventually([this] { return deviceForce().norm() < 0.05; })) << deviceForce().norm();
}

TEST_F(DeviceMenu, SaysWhatAGuideNeeds) {
    chooseGuide("Point where the tip is");
    EXPECT_TRUE(told().starts_with("A guide pulls at a hand with a coupling")) << told();
}

TEST_F(DeviceMenu, TheEdgeOfTheWorkspaceIsFeltAndToldAndAClutchLeadsOn) {
    leadWithDevice();
    press(Qt::Key_Right, Qt::ControlModifier);
    ASSERT_TRUE(eventually([this] {
        return state().find("edge of the workspace: clutch (C)") != std::string::npos;
    })) << state();
    live(500);
    release(Qt::Key_Right);
    const double edge = device().norm();
    EXPECT_GT(edge, 0.09);
    EXPECT_LT(edge, 0.1);
    const Vector3 tip = base();
    menus().clutch->trigger();
    press(Qt::Key_Left, Qt::ControlModifier);
    ASSERT_TRUE(eventually([this] { return device().norm() < 0.05; }));
    release(Qt::Key_Left);
    live(300);
    menus().clutch->trigger();
    live(300);
    EXPECT_LT((base() - tip).norm(), 0.2e-9);
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_TRUE(eventually([&] { return (base() - tip).norm() > 10e-9; }));
    release(Qt::Key_Right);
}

}  // namespace
}  // namespace asperity::test
