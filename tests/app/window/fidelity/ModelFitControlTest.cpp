#include "app/window/fidelity/FidelityControl.h"
#include "app/window/recording/RecordingControl.h"
#include "core/haptics/DevicePath.h"
#include "tests/app/window/ControlFixture.h"

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace asperity::test {
namespace {

/// A device that is not there any more.
class PulledOut final : public HapticDevice {
public:
    explicit PulledOut(const Vector3& position) : position_(position) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double /*timeStep*/) noexcept override {
        return {.position = position_, .connected = false};
    }

private:
    Vector3 position_;
};

class ModelFitControlTest : public ControlFixture {
protected:
    void SetUp() override { recordings.setFolder(folder.path() / "recordings"); }
    /// A flat sample, on which there is nothing to search.
    void usePending(const SceneDescription& description = plainScene()) {
        const Scene scene = buildScene(description, flatMap());
        runs.use({.scene = scene,
                  .format = "made for the test",
                  .sha256 = "",
                  .notes = {},
                  .provenance = {},
                  .needs = needsBeforeFit(scene)});
    }
    bool isPending() { return run().loaded().needs.pending; }
    /// Waits until the model is found: then the run and who asks have the scene alone.
    bool isFound() {
        return eventually([this] { return run().shared().use_count() == 2; });
    }
    /// Frames go by.
    bool fitEnds(int milliseconds = 20000) {
        return eventually(
            [this] {
                fits.advance();
                return !isPending();
            },
            milliseconds);
    }
    /// After the model is found; frames go by at each of which it could be adopted.
    bool staysPending() { return !fitEnds(100); }

    /// Brings the base to a height and holds it there.
    void holdAt(double height) {
        run().takeDevice([&] {
            const Vector3 here = run().basePosition();
            const DevicePath path{{0.0, here}, {0.1, Vector3(here.x(), here.y(), height)}};
            return std::make_unique<ScriptedDevice>(path, run().settings().positionGain,
                                                    run().devicePosition());
        });
    }
    /// Loses the device, far from the sample. No frame goes by.
    void loseDevice() {
        run().takeDevice([&] { return std::make_unique<PulledOut>(run().devicePosition()); });
        while (run().loop().snapshot().sample.output.fault == Fault::None) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    RecordingControl& recordings = stage.add<RecordingControl>();
    ModelFitControl& fits = stage.add<ModelFitControl>();
};

TEST_F(ModelFitControlTest, TheRunGoesOnWithWhatItsSceneRequires) {
    usePending();
    const LiveRun* const before = runs.run();
    const ForceModelOptions everything = run().scene().model;
    Scene same = run().scene();
    const RequiredTerms needs = fitModel(same);
    ASSERT_TRUE(fitEnds());
    EXPECT_EQ(runs.run(), before);
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(run().scene().model, needs.model);
    EXPECT_NE(run().scene().model, everything);
    EXPECT_EQ(run().loaded().needs.model, needs.model);
}

TEST_F(ModelFitControlTest, ATipThatFeelsTheSampleKeepsItsModel) {
    usePending();
    ASSERT_TRUE(isFound());
    const double far = run().basePosition().z();
    holdAt(-2e-9);
    ASSERT_TRUE(eventually([this] { return !run().mayAdoptModel(); }));
    EXPECT_TRUE(staysPending());
    holdAt(far);
    EXPECT_TRUE(fitEnds());
}

TEST_F(ModelFitControlTest, ARecordingHasOneModel) {
    usePending();
    ASSERT_TRUE(isFound());
    recordings.start({.folder = folder.path() / "run"});
    EXPECT_TRUE(staysPending());
    recordings.finish();
    EXPECT_TRUE(fitEnds());
}

/// By what leaving each term out changes the result.
std::vector<double> effectsIn(const RequiredTerms& needs) {
    std::vector<double> effects;
    for (const TermNeed& need : needs.terms) {
        effects.push_back(need.effect);
    }
    return effects;
}

/// The terms were judged on curves to the setpoint: what is left out there may matter at another.
TEST_F(ModelFitControlTest, AnotherSetpointChoosesTheTermsAnew) {
    SceneDescription description = plainScene();
    description.sample.material.elastic.youngsModulus = 10e9;
    description.sample.material.workOfAdhesion = 0.02;
    description.setpoint = 1e-9;
    usePending(description);
    ASSERT_TRUE(fitEnds());
    const RequiredTerms before = run().loaded().needs;
    SceneDescription pressed = run().scene().description;
    pressed.setpoint = 500e-9;
    edits.change("Setpoint", pressed, "setpoint_n");
    const auto isJudged = [this] {
        fits.advance();
        return run().loaded().needs.setpoint == 500e-9;
    };
    ASSERT_TRUE(eventually(isJudged, 20000));
    Scene same = run().scene();
    const RequiredTerms needs = fitModel(same);
    EXPECT_EQ(run().scene().model, needs.model);
    EXPECT_EQ(effectsIn(run().loaded().needs), effectsIn(needs));
    EXPECT_NE(effectsIn(before), effectsIn(needs));
    EXPECT_TRUE(run().loop().running());
    edits.undo();
    EXPECT_TRUE(eventually([this] {
        fits.advance();
        return run().loaded().needs.setpoint == 1e-9;
    }));
    EXPECT_EQ(run().scene().model, before.model);
}

/// The black box would begin anew, and nothing come of the wish.
TEST_F(ModelFitControlTest, TheLastSecondsAreSavedFirst) {
    QSignalSpy saved(&recordings, &RecordingControl::lastSecondsSaved);
    usePending();
    ASSERT_TRUE(isFound());
    ASSERT_TRUE(eventually([this] {
        runs.fetch();
        return run().blackBox().samples().size() > 10;
    }));
    run().blackBox().freeze();
    EXPECT_TRUE(staysPending());
    ASSERT_TRUE(eventually([&] {
        recordings.advance();
        return saved.count() == 1;
    }));
    EXPECT_TRUE(fitEnds());
}

TEST_F(ModelFitControlTest, AFaultThatNoFrameHasSeenIsSavedFirst) {
    QSignalSpy saved(&recordings, &RecordingControl::lastSecondsSaved);
    usePending();
    ASSERT_TRUE(isFound());
    loseDevice();
    EXPECT_TRUE(staysPending());
    ASSERT_TRUE(eventually([&] {
        recordings.advance();
        return saved.count() == 1;
    }));
    EXPECT_TRUE(fitEnds());
}

/// The black box was empty until the frame after.
TEST_F(ModelFitControlTest, AFaultBeforeTheNextFrameIsSavedToo) {
    QSignalSpy saved(&recordings, &RecordingControl::lastSecondsSaved);
    usePending();
    ASSERT_TRUE(fitEnds());
    loseDevice();
    useFlatScene();
    EXPECT_EQ(saved.count(), 1) << told();
}

TEST_F(ModelFitControlTest, WhoeverWorksWithTheSceneKeepsItsModel) {
    usePending();
    ASSERT_TRUE(isFound());
    auto shared = run().shared();
    EXPECT_TRUE(staysPending());
    shared.reset();
    EXPECT_TRUE(fitEnds());
}

TEST_F(ModelFitControlTest, AnotherSceneHasItsOwn) {
    usePending();
    const std::weak_ptr<const LoadedScene> before = run().shared();
    useFlatScene();  // its model is known
    const ForceModelOptions model = run().scene().model;
    ASSERT_TRUE(eventually([&] { return before.expired(); })) << "the search has ended";
    QCoreApplication::processEvents();  // it answers at once, if it does
    fits.advance();
    EXPECT_EQ(run().scene().model, model);
    usePending();
    EXPECT_TRUE(fitEnds());
}

}  // namespace
}  // namespace asperity::test
