#include "app/window/export/ExportControl.h"
#include "app/window/live/ForcePanel.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCursor>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QtTest>

namespace asperity::test {
namespace {

class ClipboardControlTest : public ControlFixture {
protected:
    void SetUp() override { QApplication::clipboard()->setText(QStringLiteral("nothing")); }
    void showWindow() {
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        QApplication::setActiveWindow(&window);
    }
    static QImage picture() {
        return qvariant_cast<QImage>(QApplication::clipboard()->mimeData()->imageData());
    }

    ViewControl& views = stage.add<ViewControl>();
    ClipboardControl& clipboard = stage.add<ClipboardControl>();
};

TEST_F(ClipboardControlTest, CtrlCCopiesTheViewWhereItHasTheFocus) {
    useFlatScene();
    showWindow();
    panels.view().setFocus();
    QTest::keyClick(&panels.view(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(picture().size(), panels.view().size());
    EXPECT_EQ(told(), "The view is on the clipboard");
}

TEST_F(ClipboardControlTest, NumberFieldsKeepTheirOwnCtrlC) {
    useFlatScene();
    showWindow();
    auto* box = window.findChild<QAbstractSpinBox*>(QStringLiteral("setpoint"));
    box->setFocus();
    box->selectAll();
    QTest::keyClick(box, Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith(QLatin1Char('5')))
        << QApplication::clipboard()->text().toStdString();
    EXPECT_TRUE(picture().isNull());
}

TEST_F(ClipboardControlTest, CopiesTheWindow) {
    showWindow();
    window.menus().entry("copyWindow").trigger();
    EXPECT_EQ(picture().size(), window.size());
}

TEST_F(ClipboardControlTest, CopiesThePlotUnderThePointer) {
    useFlatScene();
    showWindow();
    QWidget& map = *window.findChild<QWidget*>(QStringLiteral("overviewMap"));
    QCursor::setPos(window.mapToGlobal({2, 2}));
    window.menus().entry("copyPlot").trigger();
    EXPECT_TRUE(picture().isNull());
    EXPECT_TRUE(QString::fromStdString(told()).startsWith(QStringLiteral("Which plot?"))) << told();
    QCursor::setPos(map.mapToGlobal(map.rect().center()));
    window.menus().entry("copyPlot").trigger();
    EXPECT_EQ(picture().size(), map.size());
}

/// Each number that a panel shows is among them, with all its digits.
TEST_F(ClipboardControlTest, CopiesAllNumbersShown) {
    useFlatScene();
    runs.pause();
    runs.fetch();
    views.show(0.0);
    views.show(0.025);
    window.menus().entry("copyNumbers").trigger();
    const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    EXPECT_EQ(
        lines.front(),
        QStringLiteral("name\tvalue\tstandard deviation by noise\tby model and calibration\tunit"));
    std::map<QString, QStringList> rows;
    for (const QString& line : lines) {
        rows[line.section('\t', 0, 0)] = line.split('\t');
    }
    const TickOutput& output = runs.shown().sample.output;
    EXPECT_EQ(rows[QStringLiteral("tip z")].value(1).toDouble(), output.tip.z());
    EXPECT_EQ(rows[QStringLiteral("Fz")].value(1).toDouble(), output.estimate.force.z());
    EXPECT_EQ(rows[QStringLiteral("Fz")].value(2).toDouble(),
              std::sqrt(output.estimate.covariance(2, 2)));
    for (const char* name :
         {"Fx", "Fy", "|F|", "tip x", "tip y", "gap", "contact radius", "bending", "torsion",
          "deflection z", "deflection sideways", "loop rate", "ticks"}) {
        EXPECT_EQ(rows[QString::fromUtf8(name)].size(), 5) << name;
    }
    EXPECT_EQ(rows[QStringLiteral("gap")].value(4), QStringLiteral("m"));
}

}  // namespace
}  // namespace asperity::test
