#include "app/window/live/OverviewPanel.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/SceneControl.h"
#include "core/Error.h"
#include "core/Units.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/Places.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>

namespace asperity::test {
namespace {

/// A device with motors at rest that can be pulled out.
class PulledDevice final : public HapticDevice {
public:
    explicit PulledDevice(const std::atomic<bool>& connected) : connected_(connected) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return {.maxForce = 5.0, .maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = 0.075};
    }
    DeviceState advance(double /*timeStep*/) noexcept override { return {.connected = connected_}; }

private:
    const std::atomic<bool>& connected_;
};

constexpr const char* kSimulated = "Simulated device";
constexpr const char* kMouse = "Mouse and keyboard";

/// The window with a device in its list that has motors.
class WindowWithDevice : public Window {
protected:
    void leadWithDevice() {
        openFlatScene();
        choose("device", kSimulated);
    }
    const Settings& knobs() { return stage.run()->settings(); }
    double deviceForce() { return stage.run()->loop().snapshot().sample.output.deviceForce.norm(); }
    /// How far the base moved in so many last ticks [m].
    double movedIn(std::size_t count) {
        stage.runs().fetch();
        const auto& ticks = stage.run()->blackBox().samples();
        return ticks.size() > count ? (ticks.back().output.base.position -
                                       ticks[ticks.size() - 1 - count].output.base.position)
                                          .norm()
                                    : std::numeric_limits<double>::infinity();
    }
    /// What must be read; closes it. Empty: nothing.
    std::string complaint() {
        auto* box = window.findChild<QMessageBox*>();
        const std::string text = box != nullptr ? box->text().toStdString() : std::string();
        delete box;
        return text;
    }
    std::string deviceShown() { return child<QComboBox>("device")->currentText().toStdString(); }
};

TEST_F(WindowWithDevice, IsCoupledAtAScaleThatHoldsAndTheUserIsToldWhatIsFelt) {
    leadWithDevice();
    EXPECT_EQ(deviceShown(), kSimulated);
    EXPECT_TRUE(knobs().coupling.couples());
    EXPECT_EQ(knobs().positionGain, 1e-6);
    EXPECT_EQ(knobs().forceGain, 1e8);
    EXPECT_EQ(child<QAbstractSpinBox>("forceGain")->text().toStdString(), "1e8");
    EXPECT_TRUE(told().starts_with("1 mm : 1 nm, 1 N : 10 nN; stiffness at the device ")) << told();
}

TEST_F(WindowWithDevice, FeelsTheSampleAndLetsGo) {
    leadWithDevice();
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    press(Qt::Key_PageDown);
    ASSERT_TRUE(eventually([this] { return inContact() && deviceForce() > 0.5; })) << state();
    release(Qt::Key_PageDown);
    ASSERT_TRUE(runsFor(0.5));
    // At rest the operator feels the force on the tip at the scale.
    const TickOutput& latest = stage.run()->loop().snapshot().sample.output;
    EXPECT_NEAR(latest.deviceForce.z(), 1e8 * latest.model.force.z(), 0.1) << state();
    press(Qt::Key_PageUp);
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
    release(Qt::Key_PageUp);
    EXPECT_EQ(stage.run()->loop().snapshot().sample.output.fault, Fault::None);
}

TEST_F(WindowWithDevice, TakesTheTipAndGivesItBackWithTheEarlierGainsAndNothingMoves) {
    // With noise in the signals the hand that feels them never rests: it moves by some 10 pm.
    SceneDescription quiet = plainScene();
    quiet.truth.signalNoise = 0.0;
    openFlatScene(quiet);
    turn("forceGain", "250");
    ASSERT_TRUE(runsFor(0.3));
    const Vector3 before = stage.run()->basePosition();
    choose("device", kSimulated);
    ASSERT_TRUE(runsFor(0.5));
    EXPECT_LT((stage.run()->basePosition() - before).norm(), 0.03_nm) << "an encoder's step";
    ASSERT_TRUE(eventually([this] { return movedIn(500) < 1e-4_nm; }))
        << "the simulated hand comes to rest";
    const Vector3 piloted = stage.run()->basePosition();
    choose("device", kMouse);
    ASSERT_TRUE(runsFor(0.5));
    EXPECT_EQ(knobs().forceGain, 250.0);
    EXPECT_EQ(knobs().positionGain, 1.0);
    EXPECT_FALSE(knobs().coupling.couples());
    EXPECT_LT((stage.run()->basePosition() - piloted).norm(), 1e-3_nm);
}

TEST_F(WindowWithDevice, RefusesAGainThatDoesNotHoldAndTheKnobGoesBack) {
    leadWithDevice();
    turn("forceGain", "1e9");
    EXPECT_EQ(knobs().forceGain, 1e8);
    EXPECT_EQ(child<QAbstractSpinBox>("forceGain")->text().toStdString(), "1e8");
    const std::string refusal = complaint();
    EXPECT_NE(refusal.find("reduce the force gain"), std::string::npos) << refusal;
    turn("positionGain", "1e-4");
    EXPECT_EQ(knobs().positionGain, 1e-6);
    EXPECT_NE(complaint().find("reduce the force gain or the position gain"), std::string::npos);
    turn("forceGain", "2e8");
    EXPECT_EQ(knobs().forceGain, 2e8);
    EXPECT_EQ(complaint(), "");
}

TEST_F(WindowWithDevice, GoesOnLeadingOverAnotherMaterialUnlessThatDoesNotHold) {
    leadWithDevice();
    turn("forceGain", "4e8");
    ASSERT_EQ(knobs().forceGain, 4e8);
    choose("material", "silicon oxide");  // pulls with 18 nN
    EXPECT_EQ(child<QComboBox>("material")->currentText().toStdString(), "polystyrene");
    const std::string refusal = complaint();
    EXPECT_NE(refusal.find("exceeds its force limit (3 N)"), std::string::npos) << refusal;
    choose("material", "silicone rubber");
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(child<QComboBox>("material")->currentText().toStdString(), "silicone rubber");
    EXPECT_EQ(deviceShown(), kSimulated);
    EXPECT_EQ(knobs().forceGain, 4e8);
    EXPECT_EQ(knobs().positionGain, 1e-6);
    EXPECT_TRUE(knobs().coupling.couples());
    EXPECT_TRUE(eventually([this] { return state() == "far"; })) << state();
    choose("device", kMouse);
    EXPECT_EQ(knobs().positionGain, 1.0);
    EXPECT_EQ(knobs().forceGain, 1.0);
}

TEST_F(WindowWithDevice, ALatchedFaultKeepsForcesOffOverAnotherMaterialToo) {
    openFlatScene();
    std::atomic<bool> connected{true};
    stage.run()->takeDevice([&] { return std::make_unique<PulledDevice>(connected); });
    connected = false;
    ASSERT_TRUE(eventually([this] { return state().starts_with("fault"); })) << state();
    choose("material", "silicone rubber");
    ASSERT_TRUE(eventually([this] { return state().find("forces off") != std::string::npos; }))
        << state();
    EXPECT_FALSE(knobs().forcesOn);
}

TEST_F(WindowWithDevice, ARecordingThatBeginsInContactTakesNoForceAway) {
    leadWithDevice();
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    press(Qt::Key_PageDown);
    ASSERT_TRUE(eventually([this] { return inContact() && deviceForce() > 0.5; })) << state();
    release(Qt::Key_PageDown);
    ASSERT_TRUE(runsFor(0.3));
    const double before = deviceForce();
    QTest::mouseClick(child<QPushButton>("record"), Qt::LeftButton);
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(runsFor(0.02));
        EXPECT_GT(deviceForce(), 0.7 * before);
    }
    QTest::mouseClick(child<QPushButton>("record"), Qt::LeftButton);
}

TEST_F(WindowWithDevice, ARecordingHoldsTheEnergyAtTheDevice) {
    leadWithDevice();
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    QSignalSpy finished(&stage.get<RecordingControl>(), &RecordingControl::finished);
    auto* record = child<QPushButton>("record");
    QTest::mouseClick(record, Qt::LeftButton);
    press(Qt::Key_PageDown);
    ASSERT_TRUE(eventually([this] { return inContact() && deviceForce() > 0.5; })) << state();
    release(Qt::Key_PageDown);
    QTest::mouseClick(record, Qt::LeftButton);
    ASSERT_EQ(finished.count(), 1);
    const std::filesystem::path recording = finished[0][0].toString().toStdString();
    const CsvTable energy = readCsv(recording / "energy_log.csv");
    const CsvTable forces = readCsv(recording / "force_log.csv");
    ASSERT_EQ(energy.numbers("time_s"), forces.numbers("time_s"));
    EXPECT_GT(energy.numbers("energy_j").back(), 0.0) << "drag and the sample take energy";
    // The force of 1 ms delay and the tick's own: F^2 / (2 Kc).
    const double force = forces.number(forces.rows() - 3, "device_fz_n");
    const double spring = force * force / (2.0 * knobs().coupling.stiffness);
    EXPECT_NEAR(energy.numbers("spring_j").back(), spring, 0.01 * spring);

    choose("device", kMouse);
    QTest::mouseClick(record, Qt::LeftButton);
    ASSERT_TRUE(runsFor(0.1));
    QTest::mouseClick(record, Qt::LeftButton);
    ASSERT_EQ(finished.count(), 2);
    const std::filesystem::path other = finished[1][0].toString().toStdString();
    EXPECT_TRUE(std::filesystem::exists(other / "force_log.csv"));
    EXPECT_FALSE(std::filesystem::exists(other / "energy_log.csv"));
}

TEST_F(WindowWithDevice, ARecordingReplaysToTheSameBits) {
    stage.get<SceneControl>().open(test::dataFolder() / "samples/particles.gsf");
    ASSERT_TRUE(eventually([this] { return stage.run() != nullptr && far(); }));
    choose("device", kSimulated);
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    QSignalSpy finished(&stage.get<RecordingControl>(), &RecordingControl::finished);
    QTest::mouseClick(child<QPushButton>("record"), Qt::LeftButton);
    press(Qt::Key_PageDown);
    ASSERT_TRUE(eventually([this] { return inContact(); })) << state();
    release(Qt::Key_PageDown);
    QTest::mouseClick(child<QPushButton>("record"), Qt::LeftButton);
    ASSERT_EQ(finished.count(), 1);
    const ProgramRun replay = runProgram("replay '" + finished[0][0].toString().toStdString() +
                                         "' --out '" + (folder.path() / "again").string() + "'");
    EXPECT_NE(replay.output.find("bit-identical"), std::string::npos) << replay.output;
}

/// A handle that shakes at 60 Hz as soon as it is told to; its force is 5.5 ms late.
class ShakenDevice final : public HapticDevice {
public:
    explicit ShakenDevice(const std::atomic<bool>& shaken) : shaken_(shaken) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return {.maxForce = 5.0, .maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = 0.075};
    }
    [[nodiscard]] double delay() const noexcept override { return 5.5e-3; }
    DeviceState advance(double timeStep) noexcept override {
        time_ += shaken_ ? timeStep : 0.0;
        return {.position = {2e-3 * std::sin(2.0 * std::numbers::pi * 60.0 * time_), 0.0, 0.0}};
    }

private:
    const std::atomic<bool>& shaken_;
    double time_ = 0.0;  ///< since it is shaken [s]
};

TEST_F(WindowWithDevice, ThePersonIsToldWhenTheDeviceIsGivenEnergy) {
    std::atomic<bool> shaken{false};
    openFlatScene();
    stage.run()->takeDevice([&shaken] { return std::make_unique<ShakenDevice>(shaken); });
    ASSERT_TRUE(eventually([this] { return state() == "far"; })) << state();
    EXPECT_EQ(text("flags").find("begins to oscillate"), std::string::npos);
    shaken = true;
    EXPECT_TRUE(eventually([this] {
        return text("flags").find("begins to oscillate") != std::string::npos;
    })) << stage.run()->energy().observer()->energy();
    stage.run()->takeDevice([] { return std::make_unique<PointerDevice>(Vector3::Zero()); });
}

/// A device with motors at rest whose delay is what a test says.
class LateDevice final : public HapticDevice {
public:
    explicit LateDevice(const std::atomic<double>& delay) : delay_(delay) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return {.maxForce = 5.0, .maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = 0.075};
    }
    [[nodiscard]] double delay() const noexcept override { return delay_; }
    DeviceState advance(double /*timeStep*/) noexcept override { return {}; }

private:
    const std::atomic<double>& delay_;  ///< [s]
};

TEST_F(WindowWithDevice, TheCouplingFollowsTheDelayAndWithoutOneTheForcesGoOff) {
    std::atomic<double> delay{1.0_ms};
    openFlatScene();
    stage.run()->takeDevice([&delay] { return std::make_unique<LateDevice>(delay); });
    const double stiffness = knobs().coupling.stiffness;
    delay = 5.0_ms;
    ASSERT_TRUE(eventually([&] { return knobs().coupling.stiffness < 0.8 * stiffness; }));
    EXPECT_TRUE(knobs().forcesOn);
    delay = 9.0_ms;
    ASSERT_TRUE(eventually([this] { return !knobs().forcesOn; }));
    const std::string reason = complaint();
    EXPECT_TRUE(reason.starts_with("Forces are off: the haptic device holds no coupling"))
        << reason;
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    EXPECT_FALSE(knobs().forcesOn);
    EXPECT_FALSE(child<QPushButton>("forces")->isChecked());
    EXPECT_NE(complaint().find("no coupling"), std::string::npos);
    delay = 2.0_ms;
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    EXPECT_TRUE(knobs().forcesOn);
    stage.run()->takeDevice([] { return std::make_unique<PointerDevice>(Vector3::Zero()); });
}

TEST_F(WindowWithDevice, ADeviceThatNoScaleHoldsIsRefusedAndTheMouseStays) {
    std::atomic<double> delay{20.0_ms};
    openFlatScene();
    EXPECT_THROW(stage.run()->takeDevice([&delay] { return std::make_unique<LateDevice>(delay); }),
                 Error);
    EXPECT_FALSE(knobs().coupling.couples());
    const double start = stage.run()->basePosition().x();
    press(Qt::Key_Right);
    EXPECT_TRUE(
        eventually([&] { return std::abs(stage.run()->basePosition().x() - start) > 1e-9; }));
    release(Qt::Key_Right);
}

TEST_F(WindowWithDevice, ADeviceTakenBehindTheSessionIsNotPilotedByTheMouse) {
    openFlatScene();
    const Vector3 here = stage.run()->devicePosition();
    stage.run()->takeDevice([&here] { return std::make_unique<PointerDevice>(here); });
    const Vector3 before = stage.run()->basePosition();
    press(Qt::Key_Right);
    ASSERT_TRUE(runsFor(0.3));
    release(Qt::Key_Right);
    EXPECT_LT((stage.run()->basePosition() - before).norm(), 1e-15);
    std::atomic<double> delay{0.0};
    stage.run()->takeDevice([&delay] { return std::make_unique<LateDevice>(delay); });
    const Vector2 position(90e-9, 40e-9);
    Q_EMIT panels.overview().positionChosen(position.x(), position.y());
    EXPECT_TRUE(eventually([&] {
        return (stage.run()->basePosition().head<2>() - position).norm() < 0.05e-9;
    })) << "the mouse takes the tip first";
    EXPECT_EQ(deviceShown(), kMouse);
}

}  // namespace
}  // namespace asperity::test
