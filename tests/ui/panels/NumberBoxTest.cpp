#include "ui/panels/NumberBox.h"

#include "tests/ui/panels/PanelSamples.h"
#include "ui/Theme.h"
#include "ui/panels/GainSpinBox.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include <gtest/gtest.h>

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
    EXPECT_EQ(box.text(), QStringLiteral("2.50 %"));
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
        EXPECT_EQ(line->palette().color(QPalette::Text).rgb(), theme::kFault) << text;
        QTest::keyClick(&box, Qt::Key_Return);
        EXPECT_EQ(box.value(), 7.0) << text;
        EXPECT_EQ(box.text(), QStringLiteral("7.00 %"));
        EXPECT_EQ(line->palette().color(QPalette::Text).rgb(), theme::kInk);
        EXPECT_TRUE(QToolTip::text().contains(QString::fromUtf8(text))) << text;
        EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("from 0 to 100")));
    }
    EXPECT_EQ(changed.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Languages, NumberBoxTest,
                         ::testing::Values(QLocale::C, QLocale::English, QLocale::German));

}  // namespace
}  // namespace asperity
