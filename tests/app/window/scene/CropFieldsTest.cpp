#include "app/window/scene/CropFields.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QtTest>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

class CropFieldsTest : public ::testing::Test {
protected:
    CropFieldsTest() {
        fields.showScan({400, 200}, {4e-6, 2e-6}, {});
        QObject::connect(&fields, &CropFields::cropEntered,
                         [this](const auto& crop) { entered.push_back(crop); });
    }
    QSpinBox& box(const char* name) { return *fields.findChild<QSpinBox*>(name); }
    QPushButton& whole() { return *fields.findChild<QPushButton*>("cropWhole"); }
    void beginToType() {
        fields.show();
        QApplication::setActiveWindow(&fields);
        box("cropColumns").setFocus();
        box("cropColumns").selectAll();
    }
    QString extent() { return fields.findChild<QLabel*>("cropExtent")->text(); }

    CropFields fields;
    std::vector<std::optional<PixelRectangle>> entered;
};

TEST_F(CropFieldsTest, ShowAllOfTheScanWhereThereIsNoPart) {
    EXPECT_EQ(box("cropColumn").value(), 0);
    EXPECT_EQ(box("cropColumns").value(), 400);
    EXPECT_EQ(box("cropRows").value(), 200);
    EXPECT_EQ(extent(), "4 µm × 2 µm");
    EXPECT_FALSE(whole().isEnabled());
    EXPECT_TRUE(entered.empty());
}

TEST_F(CropFieldsTest, ANumberIsAPart) {
    box("cropColumns").setValue(100);
    ASSERT_EQ(entered.size(), 1U);
    EXPECT_EQ(entered[0], (PixelRectangle{0, 0, 100, 200}));
    EXPECT_EQ(extent(), "1 µm × 2 µm");
    box("cropColumn").setValue(350);
    EXPECT_EQ(entered[1], (PixelRectangle{350, 0, 50, 200})) << "cut at the edge of the scan";
    EXPECT_EQ(box("cropColumns").value(), 50);
    QTest::mouseClick(&whole(), Qt::LeftButton);
    EXPECT_EQ(entered.back(), std::nullopt);
    EXPECT_EQ(box("cropColumns").value(), 400);
}

TEST_F(CropFieldsTest, WithoutASizeThereIsNoExtent) {
    fields.showScan({400, 200}, {}, {});
    EXPECT_EQ(extent(), "");
}

/// A preview of an earlier choice may come between two digits.
TEST_F(CropFieldsTest, WhatIsBeingTypedStaysWhenAPreviewComes) {
    beginToType();
    QTest::keyClicks(&box("cropColumns"), "1");
    fields.showScan({400, 200}, {4e-6, 2e-6},
                    PixelRectangle{.column = 50, .row = 0, .columns = 350, .rows = 200});
    EXPECT_EQ(box("cropColumn").value(), 50);
    EXPECT_TRUE(entered.empty());
    QTest::keyClicks(&box("cropColumns"), "00");
    QTest::keyClick(&box("cropColumns"), Qt::Key_Return);
    ASSERT_EQ(entered.size(), 1U);
    EXPECT_EQ(entered[0], (PixelRectangle{50, 0, 100, 200}));
}

TEST_F(CropFieldsTest, APartDrawnElsewhereCountsNotWhatIsBeingTyped) {
    beginToType();
    QTest::keyClicks(&box("cropColumns"), "1");
    fields.setCrop(PixelRectangle{.column = 50, .row = 0, .columns = 70, .rows = 200});
    EXPECT_EQ(box("cropColumns").value(), 70);
    EXPECT_EQ(box("cropColumns").text(), "70");
}

TEST_F(CropFieldsTest, WhatReachesBeyondTheScanIsCutOnceItIsEntered) {
    fields.setCrop(PixelRectangle{.column = 150, .row = 0, .columns = 100, .rows = 200});
    beginToType();
    QTest::keyClicks(&box("cropColumns"), "399");
    QTest::keyClick(&box("cropColumns"), Qt::Key_Return);
    EXPECT_EQ(box("cropColumns").value(), 250);
}

}  // namespace
}  // namespace asperity::test
