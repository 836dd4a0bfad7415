#include "ui/panels/ParameterPanel.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class ParameterPanelTest : public ::testing::Test {
protected:
    QAbstractSpinBox& box(const char* name) { return *panel.findChild<QAbstractSpinBox*>(name); }
    void enter(const char* name, const char* text) {
        box(name).selectAll();
        QTest::keyClicks(&box(name), QString::fromUtf8(text));
        QTest::keyClick(&box(name), Qt::Key_Return);
    }

    ParameterPanel panel;
};

TEST_F(ParameterPanelTest, ShowsASceneInTheUnitsOfALabAndEmitsNothing) {
    const QSignalSpy entered(&panel, &ParameterPanel::parameterEntered);
    panel.showScene(defaultScene());
    EXPECT_EQ(box("tipRadius").text(), "15");
    EXPECT_EQ(box("springConstant").text(), "14");
    EXPECT_EQ(box("youngsModulus").text(), "2");
    EXPECT_EQ(box("workOfAdhesion").text(), "66");
    EXPECT_EQ(box("hardness").text(), "0.3");
    EXPECT_TRUE(entered.isEmpty());
}

TEST_F(ParameterPanelTest, GivesWhatIsEnteredInSiUnits) {
    panel.showScene(defaultScene());
    SceneParameter parameter{};
    double value = 0.0;
    QObject::connect(&panel, &ParameterPanel::parameterEntered,
                     [&](SceneParameter which, double entered) {
                         parameter = which;
                         value = entered;
                     });
    enter("tipRadius", "30");
    EXPECT_EQ(parameter, SceneParameter::TipRadius);
    EXPECT_NEAR(value, 30e-9, 1e-20);
    enter("workOfAdhesion", "0");
    EXPECT_EQ(parameter, SceneParameter::WorkOfAdhesion);
    EXPECT_EQ(value, 0.0);
}

/// Some had "200.000000" beside "30".
TEST_F(ParameterPanelTest, ShowsWhatIsEnteredAsItWasTyped) {
    panel.showScene(defaultScene());
    for (const char* name :
         {"tipRadius", "springConstant", "youngsModulus", "workOfAdhesion", "hardness"}) {
        for (const char* text : {"30", "9", "200", "0.5", "12.345"}) {
            enter(name, text);
            EXPECT_EQ(box(name).text().toStdString(), text) << name;
        }
    }
}

TEST_F(ParameterPanelTest, SaysInALineOfItsOwnWhyANumberIsRefusedUntilTheNextLetter) {
    panel.showScene(defaultScene());
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    QApplication::setActiveWindow(&panel);
    const auto& line = *panel.findChild<QLabel*>("refusal");
    const int height = panel.height();
    for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Tab}) {
        box("hardness").setFocus();
        box("hardness").selectAll();
        QTest::keyClicks(&box("hardness"), "oops");
        EXPECT_EQ(line.text(), "");
        QTest::keyClick(&box("hardness"), end);
        EXPECT_TRUE(line.isVisible());
        EXPECT_TRUE(line.text().startsWith("“oops” is not taken")) << line.text().toStdString();
        QTest::qWait(20);
        EXPECT_LE(line.heightForWidth(line.width()), line.height()) << "all of it is in sight";
        box("tipRadius").setFocus();
        box("tipRadius").selectAll();
        QTest::keyClicks(&box("tipRadius"), "2");
        EXPECT_EQ(line.text(), "");
    }
    EXPECT_EQ(panel.height(), height);
}

}  // namespace
}  // namespace asperity
