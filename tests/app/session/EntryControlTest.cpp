#include "app/session/EntryControl.h"

#include "tests/app/session/ControlFixture.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

#include <limits>
#include <vector>

namespace asperity::test {
namespace {

class EntryControlTest : public ControlFixture {
protected:
    WindowMenus& menus() { return window.menus(); }
    std::vector<QAction*> thoseOfARun() {
        return {menus().record,         menus().saveLastSeconds, menus().startPause,
                menus().followPathFile, menus().followRecording, menus().tipControl,
                menus().clutch,         menus().exportView};
    }

    DeviceControl devices{window, runs};
    EntryControl entries{window, runs, devices, edits};
};

TEST_F(EntryControlTest, WithoutASceneEntriesOfARunSayThatItNeedsOne) {
    for (const QAction* const entry : thoseOfARun()) {
        EXPECT_FALSE(entry->isEnabled()) << entry->text().toStdString();
        EXPECT_EQ(entry->toolTip(), "Open a scan or a scene first");
    }
    EXPECT_TRUE(menus().open->isEnabled());
    useFlatScene();
    entries.show();
    for (const QAction* const entry : thoseOfARun()) {
        EXPECT_TRUE(entry->isEnabled()) << entry->text().toStdString();
        EXPECT_NE(entry->toolTip(), "Open a scan or a scene first");
    }
}

TEST_F(EntryControlTest, AFaultThatIsNotThereCannotBeReset) {
    useFlatScene();
    entries.show();
    EXPECT_FALSE(menus().resetFault->isEnabled());
    EXPECT_EQ(menus().resetFault->toolTip(), "There is no fault to reset");
    const Vector3 here = run().basePosition();
    const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    devices.follow({{0.0, here}, {0.1, nowhere}});
    EXPECT_TRUE(eventually([this] {
        runs.fetch();
        entries.show();
        return menus().resetFault->isEnabled();
    }));
}

TEST_F(EntryControlTest, AWindowThatIsLockedStaysSo) {
    window.lock();
    useFlatScene();
    entries.show();
    for (const QAction* const entry : thoseOfARun()) {
        EXPECT_FALSE(entry->isEnabled()) << entry->text().toStdString();
    }
}

}  // namespace
}  // namespace asperity::test
