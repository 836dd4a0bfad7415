#include "app/window/live/EngageBar.h"

#include <QAbstractSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class EngageBarTest : public ::testing::Test {
protected:
    QPushButton& button(const char* name) { return *bar.findChild<QPushButton*>(name); }
    QAbstractSpinBox& box() { return *bar.findChild<QAbstractSpinBox*>("setpoint"); }

    EngageBar bar;
};

TEST_F(EngageBarTest, ShowsTheSetpointInNanonewtonsAndTakesAnother) {
    EXPECT_DOUBLE_EQ(bar.setpoint(), 5e-9);
    bar.setSetpoint(0.2e-9);
    EXPECT_EQ(box().text().toStdString(), "0.2");
    box().selectAll();
    QTest::keyClicks(&box(), "12.5");
    QSignalSpy entered(&bar, &EngageBar::setpointEntered);
    QTest::keyClick(&box(), Qt::Key_Return);
    EXPECT_EQ(entered.count(), 1);
    EXPECT_DOUBLE_EQ(bar.setpoint(), 12.5e-9);
}

TEST_F(EngageBarTest, TheSetpointSaysThatItIsOfTheBendingAndNotFzOfThePanel) {
    EXPECT_TRUE(box().toolTip().startsWith(QStringLiteral("Deflection force")));
    EXPECT_TRUE(box().toolTip().contains(QStringLiteral("Fz in the panel is another number")));
}

TEST_F(EngageBarTest, ButtonsSayWhatWasChosen) {
    QSignalSpy engage(&bar, &EngageBar::engageChosen);
    QSignalSpy withdraw(&bar, &EngageBar::withdrawChosen);
    button("engage").click();
    EXPECT_EQ(engage.count(), 1);
    button("withdraw").click();
    EXPECT_EQ(withdraw.count(), 1);
}

TEST_F(EngageBarTest, SaysWhyItCannotEngage) {
    bar.setRefusals(QStringLiteral("why not"), {});
    EXPECT_FALSE(button("engage").isEnabled());
    EXPECT_EQ(button("engage").toolTip(), "why not");
    EXPECT_TRUE(button("withdraw").isEnabled());
    bar.setRefusals({}, QStringLiteral("nor this"));
    EXPECT_FALSE(button("withdraw").isEnabled());
    EXPECT_EQ(button("withdraw").toolTip(), "nor this");
    EXPECT_TRUE(button("engage").isEnabled());
    EXPECT_NE(button("engage").toolTip(), "why not");
}

}  // namespace
}  // namespace asperity
