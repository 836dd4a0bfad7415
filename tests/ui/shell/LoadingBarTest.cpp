#include "tests/ui/widgets/PanelSamples.h"
#include "ui/shell/WorkInBackground.h"

#include <QProgressBar>
#include <QPushButton>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LoadingBar, SaysWhatIsLoadedAndHowFarItIs) {
    LoadingBar bar;
    auto* line = bar.findChild<QProgressBar*>(QStringLiteral("loadingBar"));
    bar.begin(QStringLiteral("Loading wafer.gwy …"));
    bar.setFraction(0.425);
    EXPECT_EQ(test::textOf(bar, "loadingWords"), QStringLiteral("Loading wafer.gwy …"));
    EXPECT_EQ(line->text(), QStringLiteral("42%"));
    bar.setFraction(0.999);
    EXPECT_EQ(line->text(), QStringLiteral("99%")) << "whole only at the end";
    bar.begin(QStringLiteral("Loading steps.gsf …"));
    EXPECT_EQ(line->text(), QStringLiteral("0%"));
}

TEST(LoadingBar, ALongNameDoesNotWidenTheWindow) {
    LoadingBar bar;
    bar.begin(QStringLiteral("Loading %1.gsf …").arg(QString(200, 'w')));
    EXPECT_LT(bar.minimumSizeHint().width(), 600);
    EXPECT_TRUE(test::textOf(bar, "loadingWords").startsWith(QStringLiteral("Loading ww")));
}

TEST(LoadingBar, AsksForTheEnd) {
    LoadingBar bar;
    QSignalSpy asked(&bar, &LoadingBar::cancelRequested);
    QTest::mouseClick(bar.findChild<QPushButton*>(QStringLiteral("cancelLoading")), Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
}

}  // namespace
}  // namespace asperity
