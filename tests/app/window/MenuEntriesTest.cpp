#include "app/window/device/PathControl.h"
#include "tests/app/window/WindowFixture.h"
#include "ui/shell/Menus.h"

#include <QAction>

#include <limits>
#include <vector>

namespace asperity::test {
namespace {

class MenuEntries : public Window {
protected:
    Menus& menus() { return window.menus(); }
    std::vector<QAction*> thoseOfARun() {
        return {&menus().entry("record"),          &menus().entry("saveLastSeconds"),
                &menus().entry("startPause"),      &menus().entry("followPathFile"),
                &menus().entry("followRecording"), &menus().entry("tipControl"),
                &menus().entry("clutch"),          &menus().entry("exportView")};
    }
};

TEST_F(MenuEntries, WithoutASceneEntriesOfARunSayThatItNeedsOne) {
    for (const QAction* const entry : thoseOfARun()) {
        EXPECT_FALSE(entry->isEnabled()) << entry->text().toStdString();
        EXPECT_EQ(entry->toolTip(), "Open a scan or a scene first");
    }
    EXPECT_TRUE(menus().entry("open").isEnabled());
    openFlatScene();
    menus().refresh();
    for (const QAction* const entry : thoseOfARun()) {
        EXPECT_TRUE(entry->isEnabled()) << entry->text().toStdString();
        EXPECT_NE(entry->toolTip(), "Open a scan or a scene first");
    }
}

TEST_F(MenuEntries, AFaultThatIsNotThereCannotBeReset) {
    openFlatScene();
    menus().refresh();
    EXPECT_FALSE(menus().entry("resetFault").isEnabled());
    EXPECT_EQ(menus().entry("resetFault").toolTip(), "There is no fault to reset");
    const Vector3 here = stage.run()->basePosition();
    const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    stage.get<PathControl>().follow({{0.0, here}, {0.1, nowhere}});
    EXPECT_TRUE(eventually([this] {
        menus().refresh();
        return menus().entry("resetFault").isEnabled();
    }));
}

TEST_F(MenuEntries, AWindowThatIsLockedStaysSo) {
    panels.lock();
    window.lock();
    openFlatScene();
    menus().refresh();
    for (const QAction* const entry : thoseOfARun()) {
        EXPECT_FALSE(entry->isEnabled()) << entry->text().toStdString();
    }
}

}  // namespace
}  // namespace asperity::test
