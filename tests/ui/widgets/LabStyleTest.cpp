#include "ui/widgets/LabStyle.h"

#include "tests/support/PixelCount.h"
#include "ui/widgets/Theme.h"

#include <QCheckBox>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>
#include <QVariant>

#include <gtest/gtest.h>

#include <memory>

namespace asperity::test {
namespace {

/// Of a button's face, beside its words.
QColor faceOf(QWidget& button) {
    button.resize(120, 40);
    return button.grab().toImage().pixelColor(60, 5);
}

class LabStyleTest : public ::testing::TestWithParam<ThemeChoice> {
protected:
    void SetUp() override { theme::choose(GetParam()); }
    void TearDown() override { theme::choose(ThemeChoice::Desktop); }

    QPushButton button;
};

TEST_P(LabStyleTest, AButtonHasTheColorOfItsState) {
    EXPECT_EQ(faceOf(button), theme::colors().paper);
    button.setCheckable(true);
    button.setChecked(true);
    EXPECT_EQ(faceOf(button), theme::colors().wash);
    button.setDown(true);
    button.setChecked(false);
    EXPECT_EQ(faceOf(button), theme::colors().window);
}

TEST_P(LabStyleTest, APrimaryButtonIsFilledWithTheAccentWhileItIsEnabled) {
    button.setProperty("primary", true);
    EXPECT_EQ(faceOf(button), theme::colors().accent);
    button.setEnabled(false);
    EXPECT_EQ(faceOf(button), theme::colors().paper);
}

TEST_P(LabStyleTest, AHeadingIsWordsAlone) {
    QToolButton heading;
    heading.setText(QStringLiteral("Sample"));
    const QSize framed = heading.sizeHint();
    const int faint = pixelsLike(heading.grab().toImage(), theme::colors().faint);
    EXPECT_GT(faint, 20) << "a frame";
    heading.setProperty("heading", true);
    heading.setText(QStringLiteral("Sample "));  // measures itself anew
    heading.setText(QStringLiteral("Sample"));
    EXPECT_LT(heading.sizeHint().width(), framed.width());
    EXPECT_LT(pixelsLike(heading.grab().toImage(), theme::colors().faint), faint / 4);
}

/// In both themes the chosen tab is told from the others at a glance.
TEST_P(LabStyleTest, TheChosenTabHasALineInTheAccentsColor) {
    QTabBar tabs;
    tabs.addTab(QStringLiteral("vs. distance"));
    tabs.addTab(QStringLiteral("vs. time"));
    tabs.resize(tabs.sizeHint());
    tabs.grab();  // lays them out
    const auto lineOf = [&tabs](int tab) {
        const QImage drawn = tabs.grab().toImage();
        return pixelsLike(drawn.copy(tabs.tabRect(tab)), theme::colors().accent);
    };
    EXPECT_GE(lineOf(0), tabs.tabRect(0).width());
    EXPECT_EQ(lineOf(1), 0);
    tabs.setCurrentIndex(1);
    EXPECT_EQ(lineOf(0), 0);
    EXPECT_GE(lineOf(1), tabs.tabRect(1).width());
}

TEST_P(LabStyleTest, ACheckBoxHasAFrameAndATickThatStandOut) {
    QCheckBox box;
    const auto has = [&box](const QColor& color) {
        return pixelsLike(box.grab().toImage(), color);
    };
    EXPECT_GT(has(theme::colors().muted), 20) << "a frame";
    EXPECT_EQ(has(theme::colors().accent), 0);
    box.setChecked(true);
    EXPECT_GT(has(theme::colors().accent), 60);
    EXPECT_GT(has(theme::colors().onAccent), 3) << "a tick";
    box.setEnabled(false);
    EXPECT_EQ(has(theme::colors().accent), 0);
}

TEST_P(LabStyleTest, ButtonsAndMenusFollowAnotherTheme) {
    faceOf(button);
    QMenu menu;
    menu.addAction(QStringLiteral("Open"));
    menu.grab();
    theme::choose(GetParam() == ThemeChoice::Dark ? ThemeChoice::Light : ThemeChoice::Dark);
    EXPECT_EQ(faceOf(button), theme::colors().paper);
    EXPECT_EQ(menu.palette().color(QPalette::Highlight), theme::colors().wash);
    EXPECT_GT(pixelsLike(menu.grab().toImage(), theme::colors().paper), 200);
}

INSTANTIATE_TEST_SUITE_P(, LabStyleTest, ::testing::Values(ThemeChoice::Light, ThemeChoice::Dark),
                         [](const auto& theme) {
                             return theme.param == ThemeChoice::Dark ? "Dark" : "Light";
                         });

}  // namespace
}  // namespace asperity::test
