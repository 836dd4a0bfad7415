#include "app/session/ModelFitControl.h"

#include "app/session/RecordingControl.h"
#include "core/haptics/ScriptedDevice.h"
#include "tests/app/session/ControlFixture.h"

namespace asperity::test {
namespace {

class ModelFitControlTest : public ControlFixture {
protected:
    /// A flat sample, on which there is nothing to search.
    void usePending() {
        const Scene scene = buildScene(plainScene(), flatMap());
        runs.use({.scene = scene,
                  .format = "made for the test",
                  .sha256 = "",
                  .notes = {},
                  .provenance = {},
                  .needs = needsBeforeFit(scene.description)});
    }
    bool isPending() { return run().loaded().needs.pending; }
    /// Frames go by.
    bool fitEnds(int milliseconds = 20000) {
        return eventually(
            [this] {
                fits.advance();
                return !isPending();
            },
            milliseconds);
    }
    /// Long after the model is found.
    bool staysPending() { return !fitEnds(1000); }

    /// Brings the base to a height and holds it there.
    void holdAt(double height) {
        run().takeDevice([&] {
            const Vector3 here = run().basePosition();
            const DevicePath path{{0.0, here}, {0.1, Vector3(here.x(), here.y(), height)}};
            return std::make_unique<ScriptedDevice>(path, run().settings().positionGain,
                                                    run().devicePosition());
        });
    }

    RecordingControl recordings{window, runs};
    ModelFitControl fits{window, runs, recordings};
};

TEST_F(ModelFitControlTest, TheRunGoesOnWithWhatItsSceneRequires) {
    usePending();
    const LiveRun* const before = runs.run();
    const ForceModelOptions everything = run().scene().model;
    Scene same = run().scene();
    const SceneNeeds needs = fitModel(same);
    ASSERT_TRUE(fitEnds());
    EXPECT_EQ(runs.run(), before);
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(run().scene().model, needs.model);
    EXPECT_NE(run().scene().model, everything);
    EXPECT_EQ(run().loaded().needs.model, needs.model);
}

TEST_F(ModelFitControlTest, ATipThatFeelsTheSampleKeepsItsModel) {
    usePending();
    const double far = run().basePosition().z();
    holdAt(-2e-9);
    ASSERT_TRUE(eventually([this] { return !run().mayAdoptModel(); }));
    EXPECT_TRUE(staysPending());
    holdAt(far);
    EXPECT_TRUE(fitEnds());
}

TEST_F(ModelFitControlTest, ARecordingHasOneModel) {
    usePending();
    recordings.start({.folder = folder.path() / "run"});
    EXPECT_TRUE(staysPending());
    recordings.finish();
    EXPECT_TRUE(fitEnds());
}

/// The black box would begin anew, and nothing come of the wish.
TEST_F(ModelFitControlTest, TheLastSecondsAreSavedFirst) {
    QSignalSpy saved(&recordings, &RecordingControl::lastSecondsSaved);
    recordings.setFolder(folder.path() / "recordings");
    usePending();
    QTest::qWait(200);
    runs.fetch();
    run().blackBox().freeze();
    EXPECT_TRUE(staysPending());
    ASSERT_TRUE(eventually([&] {
        recordings.advance();
        return saved.count() == 1;
    }));
    EXPECT_TRUE(fitEnds());
}

TEST_F(ModelFitControlTest, WhoeverWorksWithTheSceneKeepsItsModel) {
    usePending();
    auto shared = run().shared();
    EXPECT_TRUE(staysPending());
    shared.reset();
    EXPECT_TRUE(fitEnds());
}

TEST_F(ModelFitControlTest, AnotherSceneHasItsOwn) {
    usePending();
    useFlatScene();  // its model is known
    const ForceModelOptions model = run().scene().model;
    QTest::qWait(1000);
    fits.advance();
    EXPECT_EQ(run().scene().model, model);
    usePending();
    EXPECT_TRUE(fitEnds());
}

}  // namespace
}  // namespace asperity::test
