#include "app/window/curve/MeasuredCurveControl.h"

#include "tests/app/window/ControlFixture.h"
#include "tests/support/ReferenceTable.h"

#include <QSignalSpy>

namespace asperity::test {
namespace {

class MeasuredCurveControlTest : public ControlFixture {
protected:
    MeasuredCurveControlTest() { useFlatScene(); }

    CyclePanel& panel{*window.findChild<CyclePanel*>()};
    MeasuredCurveControl& curves = stage.add<MeasuredCurveControl>();
};

/// A contact of 1 N/m, 50 nm deep, on a way of 500 nm.
std::string springTable() {
    std::string text = "Z (nm),Force (nN)\n";
    for (int i = 0; i <= 500; ++i) {
        text += std::to_string(i) + "," + std::to_string(i < 450 ? 0 : i - 450) + "\n";
    }
    for (int i = 500; i >= 0; --i) {
        text += std::to_string(i) + "," +
                std::to_string(i >= 450  ? i - 450
                               : i > 440 ? i - 450
                                         : 0) +
                "\n";
    }
    return text;
}

TEST_F(MeasuredCurveControlTest, DrawsACurveWithItsContactAtZero) {
    QSignalSpy loaded(&curves, &MeasuredCurveControl::loaded);
    curves.load(folder.write("spring.csv", springTable()));
    ASSERT_TRUE(eventually([&] { return loaded.count() == 1; })) << complaint();
    ASSERT_TRUE(panel.measured());
    EXPECT_EQ(panel.measured()->name, QStringLiteral("spring.csv"));
    EXPECT_TRUE(panel.measured()->details.contains(QStringLiteral("Baseline taken off")));
    const QVector<QPointF>& approach = panel.measured()->approach.overBase;
    EXPECT_NEAR(approach.back().x(), -50e-9, 1e-9);
    EXPECT_NEAR(approach.back().y(), 50e-9, 0.2e-9);
    EXPECT_LT(approach.size(), 1000);
    EXPECT_GT(panel.measured()->contact.high, 9e-9) << "the pull-off is in sight";
    EXPECT_LT(panel.measured()->contact.high, 100e-9) << "but not all of the way to it";
}

TEST_F(MeasuredCurveControlTest, SaysWhyAFileIsNone) {
    curves.load(folder.write("scan.csv", "1,2,3\n4,5,6\n"));
    std::string said;
    EXPECT_TRUE(eventually([&] {
        said = complaint();
        return !said.empty();
    }));
    EXPECT_NE(said.find("no line names a distance and a force"), std::string::npos) << said;
    EXPECT_FALSE(panel.measured());
}

TEST_F(MeasuredCurveControlTest, DrawsARealCurveInFewPoints) {
    ASPERITY_NEEDS_SHARED_DATA();
    QSignalSpy loaded(&curves, &MeasuredCurveControl::loaded);
    curves.load(sharedData("curves/csv/flipsign_jpk.csv"));
    ASSERT_TRUE(eventually([&] { return loaded.count() == 1; })) << complaint();
    EXPECT_LT(panel.measured()->approach.overSeparation.size(), 3000);
    EXPECT_GT(panel.measured()->approach.overSeparation.size(), 100);
    EXPECT_FALSE(panel.measured()->retract.overBase.isEmpty());
}

}  // namespace
}  // namespace asperity::test
