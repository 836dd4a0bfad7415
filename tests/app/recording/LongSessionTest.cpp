#include "app/loading/SceneLoader.h"
#include "app/recording/Recording.h"
#include "core/Units.h"
#include "core/haptics/DevicePath.h"
#include "core/io/scene/SceneFile.h"
#include "tests/app/ProgramRun.h"
#include "tests/core/haptics/governor/GuardedBench.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <map>

namespace asperity {
namespace {

constexpr double kSession = 60.0;  // [s]

/// The scene that ships with the program, under a coupled device: 1 mm is 1 nm, 1 N is 10 nN.
SceneDescription coupledScene() {
    SceneDescription scene = readScene(test::shippedScene("polystyrene"));
    scene.settings.positionGain = 1.0_nm / 1e-3;
    scene.settings.forceGain = 1.0 / 10.0_nN;
    scene.settings.coupling = {.stiffness = 600.0, .damping = 2.9, .proxyDamping = 3.0};
    return scene;
}

struct KnobTurn {
    double time = 0.0;  // [s]
    void (*turn)(Settings&);
};

constexpr KnobTurn kKnobs[] = {
    {6.0, [](Settings& knobs) { knobs.forceGain *= 1.7; }},
    {10.0, [](Settings& knobs) { knobs.positionGain *= 0.9; }},
    {14.0,
     [](Settings& knobs) {
         knobs.coupling = {400.0, 2.3, 3.1};
     }},
    {18.0, [](Settings& knobs) { knobs.positionControl = PositionControl::Tip; }},
    {26.0, [](Settings& knobs) { knobs.positionControl = PositionControl::Base; }},
    {30.0, [](Settings& knobs) { knobs.forcesOn = false; }},
    {32.0, [](Settings& knobs) { knobs.forcesOn = true; }},
    {36.0, [](Settings& knobs) { knobs.correctionBandwidth = 7.3; }},
    {42.0, [](Settings& knobs) { ++knobs.rearms; }},  // of the fault at 40 s
    {46.0, [](Settings& knobs) { knobs.coupling.stiffness = 0.0; }},
    {50.0, [](Settings& knobs) { knobs.coupling.stiffness = 347.3; }},
    {54.0, [](Settings& knobs) { knobs.forceGain /= 3.1; }},
};

void loseDeviceForAMoment(DeviceState& device, double time) {
    device.connected = time < 40.0 || time > 40.1;
}

/// A user at work: rasters in contact, turns knobs, loses the device and resets the fault.
class LongSession {
public:
    explicit LongSession(const LoadedScene& loaded)
        : path_(rasterPath(loaded.scene, {.duration = kSession, .indentation = 8.0_nm}))
        , bench_(loaded.scene, deviceAt(0.0)) {
        bench_.tamper = loseDeviceForAMoment;
    }

    TickSample step() {
        const double now = bench_.now();
        for (; next_ != std::end(kKnobs) && next_->time <= now; ++next_) {
            next_->turn(bench_.input.settings);
        }
        bench_.reachFor(deviceAt(now));
        return bench_.run(bench_.input.timeStep).front();
    }
    [[nodiscard]] double now() const { return bench_.now(); }
    [[nodiscard]] const TickMemory& memory() const { return bench_.memory; }

private:
    /// Where the path is at the scale that the session begins with [m].
    [[nodiscard]] Vector3 deviceAt(double time) const {
        return positionAt(path_, time) / (1.0_nm / 1e-3);
    }

    DevicePath path_;
    test::GuardedBench bench_;
    const KnobTurn* next_ = std::begin(kKnobs);
};

TEST(Recording, OfAMinuteWithTurnedKnobsAndAFaultReplaysToTheSameBits) {
    const test::ScratchFolder folder;
    const LoadedScene loaded = loadScene(folder.write("scene.toml", sceneText(coupledScene())), {});
    LongSession session(loaded);
    session.step();  // a recording begins in the middle of a run
    Recording recording({folder.path() / "run"}, loaded, session.memory(), 1e-3);
    long inContact = 0;
    std::map<ForceState, long> states;
    while (session.now() < kSession) {
        const TickSample sample = session.step();
        recording.take(sample);
        inContact += sample.output.model.contact.contactRadius > 0.0 ? 1 : 0;
        ++states[sample.output.forceState];
    }
    recording.finish();
    EXPECT_FALSE(recording.broken());
    EXPECT_GT(inContact, recording.ticks() / 2);
    EXPECT_GT(states[ForceState::On], recording.ticks() / 2);
    EXPECT_GT(states[ForceState::Fault], 1900);
    EXPECT_GT(states[ForceState::Off], 1900);

    const auto replay = test::runProgram("replay " + (folder.path() / "run").string() + " --out " +
                                         (folder.path() / "again").string());
    EXPECT_EQ(replay.exitCode, 0) << replay.output;
    const std::string ticks = std::to_string(recording.ticks());
    EXPECT_NE(replay.output.find("bit-identical: " + ticks), std::string::npos) << replay.output;
    EXPECT_GE(recording.ticks(), 59999);
}

}  // namespace
}  // namespace asperity
