#include "ui/plot/CopyablePlot.h"

#include "app/window/fidelity/TradeOffChart.h"
#include "tests/support/Waits.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/plot/CurvePlot.h"
#include "ui/plot/ForceDistancePlot.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QMimeData>
#include <QWindow>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

const QMimeData& clipboard() { return *QApplication::clipboard()->mimeData(); }

void trigger(QWidget& plot, const char* action) {
    auto* found = plot.findChild<QAction*>(QString::fromUtf8(action));
    ASSERT_NE(found, nullptr) << action;
    EXPECT_TRUE(plot.actions().contains(found)) << "it is in the context menu";
    found->trigger();
}

TEST(CopyablePlot, CurvesCopyTheirTimesAndValuesInSiUnits) {
    CurvePlot plot({.title = QStringLiteral("Force"),
                    .unit = QStringLiteral("N"),
                    .smallest = 1e-9,
                    .curves = {{QStringLiteral("Fx"), 0}, {QStringLiteral("Fz"), 0}}});
    plot.take(0.5, {1e-9, 5e-9});
    plot.take(1.0, {2e-9, -5e-9});
    trigger(plot, "copyData");
    EXPECT_EQ(clipboard().text(), QStringLiteral("time [s]\tFx [N]\ttime [s]\tFz [N]\n"
                                                 "0.5\t1e-09\t0.5\t5e-09\n"
                                                 "1\t2e-09\t1\t-5e-09\n"));
    EXPECT_FALSE(clipboard().hasImage());
}

TEST(CopyablePlot, ThePictureIsThatOnTheScreen) {
    CurvePlot plot({.title = QStringLiteral("Force"),
                    .unit = QStringLiteral("N"),
                    .curves = {{QStringLiteral("Fz"), 0}}});
    plot.resize(300, 200);
    trigger(plot, "copyPicture");
    const QImage picture = qvariant_cast<QImage>(clipboard().imageData());
    EXPECT_EQ(picture.size(), QSize(300, 200));
    EXPECT_GT(picture.width() * picture.height(),
              test::pixelsLike(picture, picture.pixelColor(1, 1)))
        << "it is not empty";
    EXPECT_FALSE(clipboard().hasText());
}

TEST(CopyablePlot, CopyOffersBothAndEachPartOfAPlotFindsIt) {
    CurvePlot plot({.title = QStringLiteral("Force"),
                    .unit = QStringLiteral("N"),
                    .curves = {{QStringLiteral("Fz"), 0}}});
    plot.resize(300, 200);
    plot.take(0.5, {1e-9});
    QWidget other;
    EXPECT_EQ(CopyablePlot::of(&other), nullptr);
    EXPECT_EQ(CopyablePlot::of(nullptr), nullptr);
    for (QWidget* part : plot.findChildren<QWidget*>()) {
        ASSERT_NE(CopyablePlot::of(part), nullptr);
        EXPECT_EQ(&CopyablePlot::of(part)->plot(), &plot);
    }
    CopyablePlot::of(&plot)->copy();
    EXPECT_TRUE(clipboard().hasImage());
    EXPECT_EQ(clipboard().text(), QStringLiteral("time [s]\tFz [N]\n0.5\t1e-09\n"));
}

TEST(CopyablePlot, ForceDistanceCurvesCopyBothBranchesOfEachCycle) {
    ForceDistancePlot plot;
    plot.setCycles({{.approach = {{4e-9, 0.0}, {1e-9, -1e-9}}, .retract = {{2e-9, -3e-9}}}},
                   {-1e-9, 5e-9});
    EXPECT_EQ(CopyablePlot::of(&plot)->data(),
              QStringLiteral("distance, approach 1 [m]\tforce, approach 1 [N]\t"
                             "distance, retract 1 [m]\tforce, retract 1 [N]\n"
                             "4e-09\t0\t2e-09\t-3e-09\n"
                             "1e-09\t-1e-09\t\t\n"));
}

TEST(CopyablePlot, TheTradeOffChartCopiesNamesTimesAndErrors) {
    TradeOffChart chart;
    chart.setPoints({{{.time = 2e-6, .error = 1e-12, .name = QStringLiteral("jkr")}}, 1e-9}, {});
    EXPECT_EQ(CopyablePlot::of(&chart)->data(),
              QStringLiteral("configuration\tmedian of a tick [s]\trms force error [N]\n"
                             "jkr\t2e-06\t1e-12\n"));
}

/// Presses the right button on a plot, moves it by so many pixels and lets it go.
void rightDrag(QWidget& plot, int moved) {
    const QPoint position(20, 20);
    const QPoint end = position + QPoint(moved, 0);
    QWindow* const window = plot.windowHandle();
    QTest::mousePress(window, Qt::RightButton, Qt::NoModifier, position);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << "it may become a drag";
    QTest::mouseRelease(window, Qt::RightButton, Qt::NoModifier, end);
}

TEST(CopyablePlot, ARightClickOpensItsMenuAndARightDragDoesNot) {
    QWidget drawing;
    const CopyablePlot plot(drawing);
    drawing.resize(200, 100);
    drawing.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&drawing));
    const auto menu = [] { return QApplication::activePopupWidget(); };
    rightDrag(drawing, 0);
    ASSERT_TRUE(test::eventually([&] { return menu() != nullptr; }));
    menu()->close();
    rightDrag(drawing, 60);
    QTest::qWait(50);  // longer than a menu takes
    EXPECT_EQ(menu(), nullptr);
    QTest::mouseClick(drawing.windowHandle(), Qt::LeftButton, Qt::NoModifier, {20, 20});
    QTest::qWait(50);  // likewise
    EXPECT_EQ(menu(), nullptr);
}

TEST(CopyablePlot, APlotWithoutNumbersOffersItsPictureOnly) {
    QWidget drawing;
    const CopyablePlot plot(drawing);
    EXPECT_EQ(drawing.actions().size(), 1);
    EXPECT_EQ(plot.data(), QString());
    plot.copy();
    EXPECT_FALSE(clipboard().hasText());
}

}  // namespace
}  // namespace asperity
