#include "ui/widgets/NumberBox.h"

#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/Theme.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include <gtest/gtest.h>

#include <initializer_list>

namespace asperity {
namespace {

/// Boxes of users with a decimal comma and without one.
class NumberBoxTest : public ::testing::TestWithParam<QLocale::Language> {
protected:
    void SetUp() override {
        QLocale::setDefault(QLocale(GetParam()));
        box.setRange(0.0, 100.0);
        box.setSuffix(QStringLiteral(" %"));
        box.setValue(7.0);
        gain.setValue(1.0);
        for (QDoubleSpinBox* one :
             {static_cast<QDoubleSpinBox*>(&box), static_cast<QDoubleSpinBox*>(&gain)}) {
            one->show();
            ASSERT_TRUE(QTest::qWaitForWindowExposed(one));
        }
    }
    void TearDown() override {
        QToolTip::hideText();
        QLocale::setDefault(QLocale::c());
    }
    static void type(QDoubleSpinBox& into, const char* text) {
        into.setFocus();
        into.selectAll();
        QTest::keyClicks(&into, QString::fromUtf8(text));
    }
    static double entered(QDoubleSpinBox& into, const char* text) {
        type(into, text);
        QTest::keyClick(&into, Qt::Key_Return);
        return into.value();
    }
    [[nodiscard]] static bool hasComma() { return GetParam() == QLocale::German; }

    NumberBox box;
    GainSpinBox gain{1e-12, 1e12};
};

TEST_P(NumberBoxTest, TakesTheFormOfFilesAndShowsIt) {
    EXPECT_EQ(entered(box, "2.5"), 2.5);
    EXPECT_EQ(box.text(), QStringLiteral("2.5 %"));
    EXPECT_EQ(entered(box, "12.5%"), 12.5);
    EXPECT_EQ(entered(gain, "0.5"), 0.5);
    EXPECT_EQ(gain.text(), QStringLiteral("0.5"));
    EXPECT_EQ(entered(gain, "1.234"), 1.234);
    EXPECT_FALSE(QToolTip::isVisible());
}

TEST_P(NumberBoxTest, ACommaIsNeverLeftOut) {
    EXPECT_EQ(entered(gain, "0,5"), hasComma() ? 0.5 : 1.0);
    EXPECT_EQ(entered(box, "2,5"), hasComma() ? 2.5 : 7.0);
    EXPECT_EQ(QToolTip::isVisible(), !hasComma());
}

TEST_P(NumberBoxTest, RefusesTheRestVisibly) {
    QSignalSpy changed(&box, qOverload<double>(&QDoubleSpinBox::valueChanged));
    for (const char* text : {"oops", "1.000.000", "1,234,567", "101", "-1"}) {
        QToolTip::hideText();
        type(box, text);
        const auto* line = box.findChild<QLineEdit*>();
        EXPECT_EQ(line->palette().color(QPalette::Text).rgb(), theme::colors().fault) << text;
        QTest::keyClick(&box, Qt::Key_Return);
        EXPECT_EQ(box.value(), 7.0) << text;
        EXPECT_EQ(box.text(), QStringLiteral("7 %"));
        EXPECT_EQ(line->palette().color(QPalette::Text).rgb(), theme::colors().ink);
        EXPECT_TRUE(QToolTip::text().contains(QString::fromUtf8(text))) << text;
        EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("from 0 to 100")));
    }
    EXPECT_EQ(changed.count(), 0);
}

/// The tool tip is gone as soon as the focus moves.
TEST_P(NumberBoxTest, SaysARefusalToWhoListensAndIsMarkedUntilTheNextLetter) {
    QSignalSpy refused(&box, &NumberBox::refused);
    const auto* line = box.findChild<QLineEdit*>();
    const auto paper = [line] { return line->palette().color(QPalette::Base).rgb(); };
    type(box, "oops");
    EXPECT_EQ(refused.count(), 0) << "it may become a number";
    QTest::keyClick(&box, Qt::Key_Return);
    ASSERT_GE(refused.count(), 1);
    EXPECT_TRUE(refused.back()[0].toString().contains(QStringLiteral("“oops”")));
    EXPECT_NE(paper(), theme::colors().paper);
    box.clearFocus();  // what is selected hides it
    EXPECT_GT(test::pixelsLike(box.grab().toImage(), QColor(paper())), 100) << "it is seen";
    type(box, "8");
    EXPECT_EQ(paper(), theme::colors().paper);
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(box.value(), 8.0);
    type(box, std::string(500, 'x').c_str());
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_LT(refused.back()[0].toString().size(), 100) << "it has room in a line";
}

TEST_P(NumberBoxTest, AllBoxesHaveTheShortestTextThatKeepsWhatIsTyped) {
    box.setSuffix({});
    box.setDecimals(6);
    box.setRange(0.0, 1e9);
    for (NumberBox* one : {&box, static_cast<NumberBox*>(&gain)}) {
        for (const char* text : {"200", "9", "0.3", "14", "1000", "1.2345", "12345", "123.456",
                                 "1e4", "1e8", "1.5e6", "0.001", "5e-5"}) {
            (void)entered(*one, text);
            EXPECT_EQ(one->text(), QString::fromUtf8(text));
        }
        one->setValue(15e-9 / 1e-9);  // 15.000000000000002
        EXPECT_EQ(one->text(), QStringLiteral("15"));
        (void)entered(*one, "0.50");
        EXPECT_EQ(one->text(), QStringLiteral("0.5"));
    }
}

TEST_P(NumberBoxTest, WhatIsTypedCanBeDiscarded) {
    QSignalSpy changed(&box, qOverload<double>(&QDoubleSpinBox::valueChanged));
    type(box, "8");
    box.discardTyped();
    EXPECT_EQ(box.text(), QStringLiteral("7 %"));
    box.hide();
    EXPECT_EQ(changed.count(), 0);
}

class DisabledBoxTest : public ::testing::TestWithParam<ThemeChoice> {
protected:
    void SetUp() override { theme::choose(GetParam()); }
    void TearDown() override { theme::choose(ThemeChoice::Light); }

    static void expectMutedWhileDisabled(QDoubleSpinBox& box) {
        box.resize(200, box.sizeHint().height());
        box.setValue(8.888);
        box.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
        box.clearFocus();
        // A color is that of letters where some of their pixels have it.
        const auto letters = [&box](const QColor& color) {
            QLineEdit& line = *box.findChild<QLineEdit*>();
            return test::pixelsLike(line.grab().toImage(), color);
        };
        const QColor ink = theme::colors().ink;
        EXPECT_GT(letters(ink), 3);
        for (int times = 0; times < 2; ++times) {
            box.setEnabled(false);
            EXPECT_EQ(letters(ink), 0);
            EXPECT_GT(letters(theme::colors().muted), 3);
            box.setValue(8.889);  // colors the text anew
            EXPECT_EQ(letters(ink), 0);
            box.setEnabled(true);
            EXPECT_GT(letters(ink), 3);
            theme::choose(theme::isDark() ? ThemeChoice::Light : ThemeChoice::Dark);
            theme::choose(GetParam());
        }
        box.hide();
    }
};

TEST_P(DisabledBoxTest, IsMuted) {
    NumberBox number;
    GainSpinBox gain(1e-3, 1e3);
    LengthBox length;
    QDoubleSpinBox plain;
    plain.setDecimals(3);
    number.setDecimals(3);
    for (QDoubleSpinBox* box :
         std::initializer_list<QDoubleSpinBox*>{&number, &gain, &length, &plain}) {
        expectMutedWhileDisabled(*box);
    }
}

INSTANTIATE_TEST_SUITE_P(Themes, DisabledBoxTest,
                         ::testing::Values(ThemeChoice::Light, ThemeChoice::Dark));

INSTANTIATE_TEST_SUITE_P(Languages, NumberBoxTest,
                         ::testing::Values(QLocale::C, QLocale::English, QLocale::German));

}  // namespace
}  // namespace asperity
