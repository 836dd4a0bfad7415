#include "ui/panels/ParameterPanel.h"

#include <QAbstractSpinBox>
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
    EXPECT_EQ(box("workOfAdhesion").text().toDouble(), 66.0);
    EXPECT_EQ(box("hardness").text().toDouble(), 0.3);
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

}  // namespace
}  // namespace asperity
