#include "app/window/device/DeviceControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/ControlBar.h"
#include "core/haptics/DevicePath.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAbstractSpinBox>
#include <QComboBox>

#include <cmath>

namespace asperity::test {
namespace {

class DeviceControlTest : public ControlFixture {
protected:
    QComboBox& list() { return *window.findChild<QComboBox*>("device"); }
    std::string shown() { return list().currentText().toStdString(); }
    void choose(const char* name) { Q_EMIT panels.controls().deviceChosen(list().findText(name)); }

    DeviceControl& devices = stage.add<DeviceControl>();
};

TEST_F(DeviceControlTest, OffersEveryDeviceInTheOrderOfTheList) {
    QStringList names;
    for (int i = 0; i < list().count(); ++i) {
        names << list().itemText(i);
    }
    EXPECT_EQ(names, (QStringList{"Mouse and keyboard", "Scripted path", "SpaceMouse",
                                  "Simulated device", "WoodenHaptics"}));
}

TEST_F(DeviceControlTest, ARunBeginsWithMouseAndKeyboard) {
    useFlatScene();
    EXPECT_EQ(shown(), "Mouse and keyboard");
    EXPECT_FALSE(run().settings().coupling.couples());
}

TEST_F(DeviceControlTest, ADeviceWithMotorsIsToldItsScaleAndTakenUpOverTheSceneChanged) {
    useFlatScene();
    choose("Simulated device");
    EXPECT_EQ(shown(), "Simulated device");
    EXPECT_TRUE(told().starts_with("1 mm : 1 nm")) << told();
    runs.turn([](Settings& settings) { settings.forceGain = 2e8; });
    runs.replace(withDescription(run().loaded(), run().scene().description));
    EXPECT_EQ(shown(), "Simulated device");
    EXPECT_EQ(run().settings().forceGain, 2e8);
    useFlatScene();
    EXPECT_EQ(shown(), "Mouse and keyboard") << "another scene begins anew";
}

/// Five notches in the view of a scan 60 mm wide pressed the tip with half a millinewton.
TEST_F(DeviceControlTest, TheWheelIsAsFineInAWideViewAsTheLeverNeeds) {
    useFlatScene();
    panels.view().setHalfWidth(1.0);
    ASSERT_GT(panels.view().halfWidth() / 400.0, 0.15e-9) << "a part of the view is coarser";
    const auto base = [this] { return run().basePosition().z(); };
    double height = 0.0;
    ASSERT_TRUE(eventually([&] {
        height = -run().loop().snapshot().sample.output.model.contact.indentation;
        return height > 5e-9;
    }));
    const double start = base();
    Q_EMIT panels.view().lifted(-12.0);
    const double lowered = liftedHeight(height, -12.0, 0.1e-9);
    EXPECT_TRUE(eventually([&] {
        devices.advance(0.01);
        return std::abs(base() - (start + lowered - height)) < 1e-11;
    })) << base() - start
        << " instead of " << lowered - height;
}

TEST_F(DeviceControlTest, AsksForAPathAndKeepsItsGain) {
    useFlatScene();
    QSignalSpy wanted(&devices, &DeviceControl::pathWanted);
    choose("Scripted path");
    EXPECT_EQ(wanted.count(), 1);
    const Vector3 here = run().basePosition();
    devices.follow({{0.0, here}, {1.0, here}});
    EXPECT_EQ(shown(), "Scripted path");
    const auto* gain = window.findChild<QAbstractSpinBox*>("positionGain");
    EXPECT_FALSE(gain->isEnabled());
    EXPECT_TRUE(gain->toolTip().startsWith("A path gives positions on the scan"));
    EXPECT_TRUE(window.findChild<QAbstractSpinBox*>("forceGain")->isEnabled());
    const double before = run().settings().positionGain;
    Q_EMIT panels.controls().knobTurned("position_gain", 4.0 * before);
    EXPECT_EQ(run().settings().positionGain, before);
    Q_EMIT panels.controls().knobTurned("force_gain", 125.0);
    EXPECT_EQ(run().settings().forceGain, 125.0);
    choose("Mouse and keyboard");
    EXPECT_TRUE(gain->isEnabled());
    EXPECT_FALSE(gain->toolTip().startsWith("A path")) << gain->toolTip().toStdString();
}

TEST_F(DeviceControlTest, SetsTheGuideThatIsChosen) {
    useFlatScene();
    window.menus().entry("guidePlane").trigger();
    EXPECT_EQ(run().settings().guide.kind, FixtureKind::Plane);
}

TEST_F(DeviceControlTest, SaysOnceWhatTheDeviceSays) {
    useFlatScene();
    choose("SpaceMouse");
    devices.advance(0.01);
    EXPECT_EQ(told(), "no SpaceMouse is plugged in");
    window.tell("something else");
    devices.advance(0.01);
    EXPECT_EQ(told(), "something else");
}

}  // namespace
}  // namespace asperity::test
