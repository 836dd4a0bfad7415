#include "app/runs/LiveRun.h"
#include "app/window/lab/LiveWindow.h"
#include "core/Units.h"
#include "tests/support/TestScenes.h"

#include <QApplication>
#include <QTimer>

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <memory>

namespace asperity::test {
namespace {

constexpr double kPositionGain = 1e-6;  // 1 mm : 1 nm
const Vector3 kHeld(64.0_nm, 64.0_nm, -2.0_nm);

/// So little force that it comes on at once.
SceneDescription feebleScene() {
    SceneDescription scene = plainScene();
    scene.settings.positionGain = kPositionGain;
    scene.settings.forceGain = 1e6;
    return scene;
}

/// A device with motors, held still with the tip a little in the sample. What it was told last
/// outlives it.
class MotorDevice final : public HapticDevice {
public:
    explicit MotorDevice(std::atomic<double>& newest) : newest_(newest) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return {.maxForce = 5.0, .maxStiffness = 800.0, .maxDamping = 8.0};
    }
    DeviceState advance(double /*timeStep*/) noexcept override {
        return {.position = kHeld / kPositionGain};
    }
    void setForce(const Vector3& force) noexcept override { newest_ = force.norm(); }

private:
    std::atomic<double>& newest_;  ///< [N]
};

/// Sends a signal as soon as the operator feels a force, and waits for what comes of it.
void sendWhenFelt(int signal, const std::atomic<double>& felt) {
    const QuitOnSignal quitOnSignal;
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, [&] {
        if (felt > 0.0) {
            poll.stop();
            std::raise(signal);
        }
    });
    poll.start(1);
    QApplication::exec();
}

TEST(ForcesEnd, WhenASignalEndsTheProgram) {
    for (const int signal : {SIGINT, SIGTERM}) {
        std::atomic<double> newest{0.0};
        {
            LoadedScene loaded{.scene = buildScene(feebleScene(), flatMap()),
                               .format = "made for the test",
                               .sha256 = "",
                               .notes = {}};
            LiveRun run(std::move(loaded), kHeld);
            run.takeDevice([&newest] { return std::make_unique<MotorDevice>(newest); });
            run.loop().start();
            sendWhenFelt(signal, newest);
            EXPECT_TRUE(run.loop().running());
        }
        EXPECT_EQ(newest, 0.0) << signal;
    }
}

}  // namespace
}  // namespace asperity::test
