#include "app/window/map/ForceMapPage.h"
#include "core/Units.h"
#include "ui/widgets/NumberBox.h"

#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// A form of a scan of 500 nm x 250 nm.
struct ForceMapFormTest : ::testing::Test {
    ForceMapFormTest() { form.setScan({500e-9, 250e-9}); }

    template <typename Widget>
    Widget& part(const char* name) {
        return *form.findChild<Widget*>(QString::fromLatin1(name));
    }
    /// As a user does, without leaving the box.
    void type(const char* name, const QString& number) {
        auto& line = *part<QAbstractSpinBox>(name).findChild<QLineEdit*>();
        line.setText(number);
        line.setModified(true);
    }
    void typeRegion(const char* left, const char* right, const char* bottom, const char* top) {
        type("mapLeft", QString::fromLatin1(left));
        type("mapRight", QString::fromLatin1(right));
        type("mapBottom", QString::fromLatin1(bottom));
        type("mapTop", QString::fromLatin1(top));
        form.takeTyped();
    }

    ForceMapForm form;
};

TEST_F(ForceMapFormTest, AsksForTheWholeScanFirst) {
    const MapRequest request = form.request();
    EXPECT_EQ(request.mode, MapMode::Approach);
    EXPECT_FALSE(request.region) << "so that nanometers round nothing";
    EXPECT_EQ(request.grid, (MapGrid{64, 32})) << "square pixels";
    EXPECT_FALSE(request.setpoint) << "the scene's";
    EXPECT_FALSE(request.truth);
    EXPECT_EQ(part<NumberBox>("mapRight").value(), 500.0);
    EXPECT_TRUE(form.rectangle().isEmpty());
}

/// To the bit: what is typed is what `asperity map --region` takes of the same digits.
TEST_F(ForceMapFormTest, TypedSidesAreExact) {
    QSignalSpy changed(&form, &ForceMapForm::changed);
    typeRegion("20.3", "110.7", "33.1", "90");
    EXPECT_GT(changed.count(), 0);
    EXPECT_EQ(form.request().region, (MapRegion{20.3e-9, 33.1e-9, 110.7e-9, 90e-9}));
    EXPECT_EQ(part<QComboBox>("mapArea").currentText(), QStringLiteral("rectangle"));
    EXPECT_EQ(form.request().grid->columns, 64);
    typeRegion("0", "500", "0", "250");
    EXPECT_EQ(form.request().region, (MapRegion{0.0, 0.0, 500e-9, 250e-9}));
}

TEST_F(ForceMapFormTest, TheRestIsTakenAsTyped) {
    type("mapColumns", QStringLiteral("12"));
    type("mapRows", QStringLiteral("7"));
    type("mapSetpoint", QStringLiteral("2.5"));
    form.takeTyped();
    part<QComboBox>("mapMode").setCurrentIndex(1);
    part<QComboBox>("mapInstrument").setCurrentIndex(1);
    const MapRequest request = form.request();
    EXPECT_EQ(request.grid, (MapGrid{12, 7}));
    EXPECT_EQ(request.setpoint, 2.5e-9);
    EXPECT_EQ(request.mode, MapMode::Contact);
    EXPECT_TRUE(request.truth);
    form.setSetpoint(9e-9);
    EXPECT_EQ(form.request().setpoint, 2.5e-9) << "one's own stays";
    form.setView({QPointF(), QSizeF(10e-9, 10e-9)});
    EXPECT_EQ(form.request().grid, (MapGrid{12, 7})) << "likewise";
}

TEST_F(ForceMapFormTest, TheSetpointIsTheScenesUntilOneIsTyped) {
    form.setSetpoint(9e-9);
    EXPECT_EQ(part<NumberBox>("mapSetpoint").value(), 9.0);
    EXPECT_FALSE(form.request().setpoint);
}

TEST_F(ForceMapFormTest, ThePartInViewEndsAtTheScan) {
    form.setView(QRectF(QPointF(-50e-9, 100e-9), QPointF(200e-9, 400e-9)));
    EXPECT_FALSE(form.request().region);
    part<QComboBox>("mapArea").setCurrentIndex(1);
    const MapRegion region = *form.request().region;
    EXPECT_EQ(region.left, 0.0);
    EXPECT_NEAR(region.right, 200e-9, 1e-20);
    EXPECT_EQ(region.bottom, 100e-9);
    EXPECT_EQ(region.top, 250e-9);
    form.setView(QRectF(QPointF(10e-9, 10e-9), QPointF(20e-9, 20e-9)));
    EXPECT_EQ(form.request().region->left, 10e-9) << "it follows the view";
}

TEST_F(ForceMapFormTest, ARectangleThatIsChosenIsToBeDrawn) {
    part<QComboBox>("mapArea").setCurrentIndex(2);
    EXPECT_TRUE(part<QToolButton>("drawMapRegion").isChecked());
    EXPECT_TRUE(form.rectangle().isEmpty())
        << "a drag begins one, and moves none as large as the scan";
}

TEST_F(ForceMapFormTest, DrawingChoosesARectangle) {
    QSignalSpy drawing(&form, &ForceMapForm::drawingChosen);
    part<QToolButton>("drawMapRegion").click();
    ASSERT_EQ(drawing.count(), 1);
    EXPECT_EQ(part<QComboBox>("mapArea").currentText(), QStringLiteral("rectangle"));
    form.setRectangle(QRectF(QPointF(20e-9, 30e-9), QPointF(60e-9, 50e-9)));
    EXPECT_EQ(form.request().region->left, 20e-9);
    EXPECT_EQ(form.request().region->bottom, 30e-9);
    EXPECT_NEAR(form.request().region->top, 50e-9, 1e-20);
    EXPECT_EQ(form.request().grid, (MapGrid{64, 32}));
    EXPECT_EQ(part<NumberBox>("mapLeft").value(), 20.0);
    part<QComboBox>("mapArea").setCurrentIndex(0);
    EXPECT_FALSE(part<QToolButton>("drawMapRegion").isChecked());
}

}  // namespace
}  // namespace asperity
