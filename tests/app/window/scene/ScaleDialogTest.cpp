#include "app/window/scene/ScaleControl.h"
#include "ui/widgets/NumberBox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

constexpr int kColumns = 40;
constexpr int kRows = 20;

class ScaleDialogTest : public ::testing::Test {
protected:
    void open(bool size, bool height, bool mask = false) {
        dialog = std::make_unique<ScaleDialog>(QStringLiteral("<b>scan</b>.txt"),
                                               ScaleGap{.channel = "matrix",
                                                        .columns = kColumns,
                                                        .rows = kRows,
                                                        .size = size,
                                                        .height = height,
                                                        .mask = mask},
                                               nullptr);
        QObject::connect(dialog.get(), &ScaleDialog::given,
                         [this](const GivenScale& scale) { given.push_back(scale); });
        dialog->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog.get()));
        QApplication::setActiveWindow(dialog.get());
    }
    LengthBox& box(const char* name) { return *dialog->findChild<LengthBox*>(name); }
    void type(const char* name, const char* text) {
        box(name).setFocus();
        box(name).selectAll();
        QTest::keyClicks(&box(name), QString::fromUtf8(text));
    }
    void choose(const char* list, const char* unit) {
        dialog->findChild<QComboBox*>(list)->setCurrentText(QString::fromUtf8(unit));
    }
    QPushButton& ok() {
        return *dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }
    QCheckBox& square() { return *dialog->findChild<QCheckBox*>("squarePixels"); }
    std::string label(const char* name) {
        return dialog->findChild<QLabel*>(name)->text().toStdString();
    }

    std::unique_ptr<ScaleDialog> dialog;
    std::vector<GivenScale> given;
};

TEST_F(ScaleDialogTest, AssumesNothing) {
    open(true, true);
    for (const char* name : {"sizeX", "sizeY", "heightPerValue"}) {
        EXPECT_EQ(box(name).text().trimmed(), "") << name;
    }
    EXPECT_EQ(dialog->scale(), GivenScale{});
    EXPECT_FALSE(ok().isEnabled());
    QTest::keyClick(&box("sizeX"), Qt::Key_Return);
    EXPECT_TRUE(given.empty());
    EXPECT_TRUE(dialog->isVisible());
}

TEST_F(ScaleDialogTest, SaysWhichFileAndWhatIsMissing) {
    const auto texts = [this] {
        std::string all;
        for (const QLabel* text : dialog->findChildren<QLabel*>()) {
            EXPECT_EQ(text->textFormat(), Qt::PlainText) << "a name may look like markup";
            all += text->text().toStdString() + "\n";
        }
        return all;
    };
    open(true, true);
    EXPECT_NE(texts().find("<b>scan</b>.txt"), std::string::npos);
    EXPECT_NE(texts().find("neither the size of the scan nor the unit"), std::string::npos);
    EXPECT_NE(texts().find("Channel “matrix”, 40 × 20 pixels"), std::string::npos);
    open(true, false);
    EXPECT_NE(texts().find("does not hold the size of the scan."), std::string::npos);
    open(false, true);
    EXPECT_EQ(texts().find("This is a mask"), std::string::npos);
    open(false, true, true);
    EXPECT_NE(texts().find("This is a mask, not heights. The file does not hold the unit"),
              std::string::npos);
}

TEST_F(ScaleDialogTest, ALongNameMakesItNoWider) {
    open(true, true);
    const int width = dialog->width();
    const std::string longName(300, 'n');
    ScaleDialog other(QString::fromStdString(longName), {.channel = longName, .size = true},
                      nullptr);
    other.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
    EXPECT_LE(other.width(), width);
}

TEST_F(ScaleDialogTest, AsksForNoMoreThanWhatIsMissing) {
    open(true, false);
    EXPECT_FALSE(box("heightPerValue").isVisible());
    type("sizeX", "5");
    EXPECT_TRUE(ok().isEnabled());
    EXPECT_FALSE(dialog->scale().hasHeight());
    open(false, true);
    EXPECT_FALSE(box("sizeX").isVisible());
    EXPECT_FALSE(square().isVisible());
    type("heightPerValue", "2.5");
    choose("heightUnit", "pm");
    EXPECT_TRUE(ok().isEnabled());
    EXPECT_EQ(dialog->scale(), (GivenScale{.heightPerValue = 2.5 * 1e-12}));
}

TEST_F(ScaleDialogTest, GivesWhatIsTypedInItsUnit) {
    open(true, true);
    type("sizeX", "400");
    choose("sizeUnit", "nm");
    EXPECT_FALSE(ok().isEnabled());
    type("heightPerValue", "0.5");
    EXPECT_TRUE(ok().isEnabled()) << "before the field is left";
    QTest::mouseClick(&ok(), Qt::LeftButton);
    ASSERT_EQ(given.size(), 1U);
    EXPECT_EQ(given[0], (GivenScale{400e-9, 200e-9, 0.5e-9}));
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(ScaleDialogTest, OneSideFollowsFromTheOtherWhilePixelsAreSquare) {
    open(true, false);
    EXPECT_TRUE(square().isChecked());
    type("sizeX", "5");
    EXPECT_EQ(box("sizeY").value(), 2.5);
    EXPECT_EQ(label("pixelSize"), "Pixel: 125 nm × 125 nm");
    type("sizeY", "4");
    EXPECT_EQ(box("sizeX").value(), 8.0);
    square().setChecked(false);
    type("sizeY", "1");
    EXPECT_EQ(box("sizeX").value(), 8.0);
    EXPECT_EQ(label("pixelSize"), "Pixel: 200 nm × 50 nm");
    square().setChecked(true);
    EXPECT_EQ(box("sizeY").value(), 4.0);
}

TEST_F(ScaleDialogTest, ARefusedNumberIsMarkedAndSaidUntilAnotherIsTyped) {
    open(true, false);
    for (const char* text : {"0", "-5", "5x", "nan", "1.000,5", "1e20"}) {
        type("sizeX", text);
        EXPECT_FALSE(ok().isEnabled()) << text;
        QTest::keyClick(&box("sizeX"), Qt::Key_Tab);
        EXPECT_FALSE(ok().isEnabled()) << text;
        EXPECT_TRUE(box("sizeX").isBlank()) << text;
        EXPECT_NE(label("refusal").find(std::string("“") + text + "” is not valid"),
                  std::string::npos)
            << label("refusal");
    }
    type("sizeX", "8");
    QTest::keyClick(&box("sizeX"), Qt::Key_Tab);
    type("sizeX", "5x");
    QTest::keyClick(&box("sizeX"), Qt::Key_Return);
    EXPECT_FALSE(ok().isEnabled()) << "nor is the number before taken";
    EXPECT_TRUE(box("sizeX").isBlank());
    type("sizeX", "5");
    EXPECT_EQ(label("refusal"), "");
    EXPECT_TRUE(ok().isEnabled());
    EXPECT_TRUE(given.empty());
}

TEST_F(ScaleDialogTest, TakesTheDecimalCommaOfALanguageThatHasIt) {
    QLocale::setDefault(QLocale(QLocale::German));
    open(true, false);
    type("sizeX", "0,5");
    EXPECT_EQ(box("sizeX").value(), 0.5);
    type("sizeX", "0.25");
    EXPECT_EQ(box("sizeX").value(), 0.25);
    QLocale::setDefault(QLocale::c());
}

TEST_F(ScaleDialogTest, CancelAndEscGiveNothing) {
    for (const bool byEsc : {false, true}) {
        open(true, false);
        QSignalSpy rejected(dialog.get(), &QDialog::rejected);
        type("sizeX", "5");
        if (byEsc) {
            QTest::keyClick(dialog.get(), Qt::Key_Escape);
        } else {
            QTest::mouseClick(
                dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                Qt::LeftButton);
        }
        EXPECT_EQ(rejected.count(), 1);
        EXPECT_TRUE(given.empty());
    }
}

TEST_F(ScaleDialogTest, SuggestsWhatWasGivenInAFittingUnit) {
    open(true, true);
    dialog->suggest({5e-6, 2.5e-6, 1.25e-10});
    EXPECT_EQ(box("sizeX").text(), "5");
    EXPECT_EQ(box("sizeY").text(), "2.5");
    EXPECT_EQ(dialog->findChild<QComboBox*>("sizeUnit")->currentText(), "µm");
    EXPECT_EQ(box("heightPerValue").text(), "1.25");
    EXPECT_EQ(dialog->findChild<QComboBox*>("heightUnit")->currentText(), "Å");
    EXPECT_TRUE(square().isChecked());
    EXPECT_TRUE(ok().isEnabled());
    dialog->suggest({5e-6, 5e-6, 0.0});
    EXPECT_FALSE(square().isChecked());
    EXPECT_EQ(box("sizeY").text(), "5");
    EXPECT_EQ(box("sizeX").text(), "5");
}

TEST_F(ScaleDialogTest, StepsBeginAtOne) {
    open(true, false);
    QTest::keyClick(&box("sizeX"), Qt::Key_Up);
    EXPECT_EQ(box("sizeX").value(), 1.0);
    QTest::keyClick(&box("sizeX"), Qt::Key_Up);
    EXPECT_EQ(box("sizeX").value(), 2.0);
}

}  // namespace
}  // namespace asperity::test
