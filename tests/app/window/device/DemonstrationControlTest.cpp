#include "app/window/device/DemonstrationControl.h"

#include "app/window/live/ControlBar.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>

#include <gtest/gtest.h>

#include <functional>

namespace asperity::test {
namespace {

class DemonstrationControlTest : public ControlFixture {
protected:
    void SetUp() override { stage.play(); }
    TipRegion region() { return run().loop().snapshot().sample.output.region(); }
    bool comesTo(TipRegion wanted) {
        return eventually([this, wanted] { return region() == wanted; }, 30000);
    }
    std::string hint() { return window.findChild<QLabel*>("hint")->text().toStdString(); }

    DeviceControl& devices = stage.add<DeviceControl>();
    EngageControl& engaging = stage.add<EngageControl>();
    DemonstrationControl& demonstration = stage.add<DemonstrationControl>();
};

TEST_F(DemonstrationControlTest, ApproachesAndWithdrawsAgainAndAgainUntilAKeyTakesOver) {
    demonstration.beginWithNextRun();
    useFlatScene();
    EXPECT_TRUE(demonstration.isPlaying());
    EXPECT_NE(hint().find("Demonstration"), std::string::npos) << hint();
    for (int cycle = 0; cycle < 2; ++cycle) {
        ASSERT_TRUE(comesTo(TipRegion::Contact)) << cycle;
        ASSERT_TRUE(comesTo(TipRegion::Far)) << cycle;
    }
    ASSERT_TRUE(comesTo(TipRegion::Contact));
    QTest::keyClick(&panels.view(), Qt::Key_Space);
    EXPECT_FALSE(demonstration.isPlaying());
    EXPECT_EQ(hint().find("Demonstration"), std::string::npos) << hint();
}

TEST_F(DemonstrationControlTest, TheMouseTakesTheTipFromItsApproach) {
    demonstration.beginWithNextRun();
    useFlatScene();
    ASSERT_TRUE(eventually([this] { return engaging.isEngaging(); }, 30000));
    QTest::mouseClick(&panels.view(), Qt::LeftButton);
    EXPECT_FALSE(demonstration.isPlaying());
    EXPECT_FALSE(engaging.isEngaging());
    EXPECT_EQ(devices.approaching(), nullptr);
}

/// Qt makes no key press of a key that is a shortcut.
TEST_F(DemonstrationControlTest, AShortcutTakesOverToo) {
    demonstration.beginWithNextRun();
    useFlatScene();
    QKeyEvent offered(QEvent::ShortcutOverride, Qt::Key_Home, Qt::NoModifier);
    QApplication::sendEvent(&panels.view(), &offered);
    EXPECT_FALSE(demonstration.isPlaying());
}

TEST_F(DemonstrationControlTest, MovesNoDeviceThatRendersForces) {
    demonstration.beginWithNextRun();
    useFlatScene();
    devices.pilotDevice(journey(run().scene(), run().basePosition(), {0.0, 0.0}, 1.0));
    ASSERT_TRUE(run().device().specification().rendersForce());
    EXPECT_TRUE(eventually([this] { return !demonstration.isPlaying(); }));
}

TEST_F(DemonstrationControlTest, BeginsNeitherUnaskedNorWhereItIsOffNorTwice) {
    useFlatScene();
    EXPECT_FALSE(demonstration.isPlaying());
    window.menus().entry("demonstrationAtStart").setChecked(false);
    demonstration.beginWithNextRun();
    useFlatScene();
    EXPECT_FALSE(demonstration.isPlaying());
    window.menus().entry("demonstrationAtStart").setChecked(true);
    demonstration.beginWithNextRun();
    useFlatScene();
    EXPECT_TRUE(demonstration.isPlaying());
    useFlatScene();
    EXPECT_FALSE(demonstration.isPlaying()) << "another scene is the user's";
}

}  // namespace
}  // namespace asperity::test
