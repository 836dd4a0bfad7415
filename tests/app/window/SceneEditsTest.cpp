#include "app/window/SceneEdits.h"

#include "app/loading/SceneLoader.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/support/Places.h"
#include "tests/support/StepsScan.h"

#include <cmath>

namespace asperity::test {
namespace {

const std::filesystem::path kGrating = test::dataFolder() / "samples/grating.gsf";

class SceneEditsTest : public ControlFixture {
protected:
    void open(const std::filesystem::path& file) {
        const int before = begun.count();
        scenes.open(file);
        ASSERT_TRUE(eventually([&] { return begun.count() == before + 1; }));
    }
    const SceneDescription& shown() { return run().scene().description; }
    void setTip(double radius) {
        SceneDescription next = *edits.wanted();
        next.tip.radius = radius;
        edits.change(QString("Tip radius: %1 nm").arg(std::round(1e9 * radius)), next, "radius_m");
    }
    void soften() {
        SampleMaterial softer = edits.wanted()->sample.material;
        softer.elastic.youngsModulus *= 0.5;
        edits.change("Softer", withMaterial(*edits.wanted(), softer));
    }
    void level(const LevelingSteps& steps) {
        SceneDescription next = *edits.wanted();
        next.sample.leveling = steps;
        edits.change("Leveling", next);
    }
    void mark(const char* name) {
        SceneDescription next = *edits.wanted();
        next.markers.push_back({.name = name, .x = 1e-9, .y = 2e-9});
        edits.change(QString("Marker: %1").arg(name), next);
    }
    double middleHeight() {
        const BSplineSurface& surface = run().scene().surface;
        return surface.at(0.5 * surface.sizeX(), 0.5 * surface.sizeY()).height;
    }

    SceneControl& scenes = stage.add<SceneControl>();
    QSignalSpy begun{&runs, &RunControl::begun};
    QSignalSpy changed{&edits, &SceneEdits::changed};
};

TEST_F(SceneEditsTest, AModelIsMadeWhileThePresentRunGoesOn) {
    useFlatScene();
    const LiveRun* const before = runs.run();
    setTip(30e-9);
    EXPECT_EQ(runs.run(), before);
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(edits.wanted()->tip.radius, 30e-9) << "what the next change starts from";
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().scene().belief.tipRadius(), 30e-9);
    EXPECT_TRUE(run().loop().running());
}

TEST_F(SceneEditsTest, UndoAndRedoGiveTheDescriptionsBackExactly) {
    useFlatScene();
    const SceneDescription first = shown();
    setTip(30e-9);
    ASSERT_TRUE(changeEnds());
    const SceneDescription second = shown();
    soften();
    ASSERT_TRUE(changeEnds());
    const SceneDescription third = shown();
    EXPECT_EQ(edits.undoName(), "Softer");
    EXPECT_EQ(edits.redoName(), "");
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown(), second);
    EXPECT_EQ(edits.undoName(), "Tip radius: 30 nm");
    EXPECT_EQ(edits.redoName(), "Softer");
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown(), first);
    EXPECT_EQ(run().scene().belief.tipRadius(), first.tip.radius);
    EXPECT_EQ(edits.undoName(), "");
    edits.undo();
    edits.redo();
    edits.redo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown(), third);
    edits.redo();
    EXPECT_EQ(shown(), third);
    EXPECT_EQ(complaint(), "");
}

TEST_F(SceneEditsTest, PlaceAndKnobsStayOverUndo) {
    open(kSteps);
    runs.turn([](Settings& settings) { settings.forceGain = 250.0; });
    const Vector2 position = run().basePosition().head<2>();
    level({LevelingStep::Plane, LevelingStep::Zero});
    ASSERT_TRUE(changeEnds());
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().settings().forceGain, 250.0);
    EXPECT_LT((run().basePosition().head<2>() - position).norm(), 1e-15);
}

/// The same coordinates are another position on the sample there.
TEST_F(SceneEditsTest, OnAnotherPartOfTheScanTheTipBeginsAnew) {
    open(kSteps);
    SceneDescription next = *edits.wanted();
    next.sample.crop = PixelRectangle{.column = 0, .row = 0, .columns = 64, .rows = 48};
    edits.change("Part", next);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().scene().surface.grid().columns, 64);
    const Vector3 start = startPosition(run().scene());
    EXPECT_LT((run().basePosition().head<2>() - start.head<2>()).norm(), 1e-15);
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_FALSE(shown().sample.crop);
}

TEST_F(SceneEditsTest, LevelingComesAnewFromTheFile) {
    open(kSteps);
    const double before = middleHeight();
    level({LevelingStep::Plane, LevelingStep::Zero});
    ASSERT_TRUE(changeEnds());
    EXPECT_GT(middleHeight(), before + 1e-12);
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(middleHeight(), before);
    EXPECT_EQ(edits.redoName(), "Leveling");
}

TEST_F(SceneEditsTest, WhatActsOnNothingIsTakenOverWithoutAnotherRun) {
    useFlatScene();
    const LiveRun* const before = runs.run();
    mark("grain");
    EXPECT_EQ(shown().markers.size(), 1U);
    SceneDescription next = *edits.wanted();
    next.setpoint = 3e-9;
    edits.change("Setpoint: 3 nN", next);
    EXPECT_EQ(shown().setpoint, 3e-9);
    edits.undo();
    edits.undo();
    EXPECT_TRUE(shown().markers.empty());
    EXPECT_EQ(runs.run(), before);
    edits.redo();
    EXPECT_EQ(shown().markers.front().name, "grain");
}

TEST_F(SceneEditsTest, ChangesOfOneNumberInARowAreOneStep) {
    useFlatScene();
    const SceneDescription first = shown();
    for (const double radius : {20e-9, 30e-9, 40e-9}) {
        setTip(radius);
        if (radius == 30e-9) {
            ASSERT_TRUE(changeEnds());
        }
    }
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(edits.undoName(), "Tip radius: 40 nm");
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown(), first);
    EXPECT_EQ(edits.undoName(), "");
    setTip(20e-9);
    soften();
    setTip(30e-9);
    ASSERT_TRUE(changeEnds());
    edits.undo();
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown().tip.radius, 20e-9) << "another change stands between";
}

TEST_F(SceneEditsTest, ANumberThatIsBackWhereItWasLeavesNoStep) {
    useFlatScene();
    const double radius = shown().tip.radius;
    setTip(20e-9);
    ASSERT_TRUE(changeEnds());
    setTip(radius);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(edits.undoName(), "");
}

TEST_F(SceneEditsTest, UndoTakesBackWhatIsStillUnderWay) {
    useFlatScene();
    const LiveRun* const before = runs.run();
    const SceneDescription first = shown();
    setTip(20e-9);
    soften();
    EXPECT_EQ(edits.undoName(), "Softer");
    edits.undo();
    EXPECT_EQ(edits.undoName(), "Tip radius: 20 nm");
    edits.undo();
    EXPECT_EQ(*edits.wanted(), first);
    QTest::qWait(1500);  // longer than a change takes
    EXPECT_EQ(runs.run(), before) << "nothing came of it";
    EXPECT_EQ(edits.undoName(), "");
}

TEST_F(SceneEditsTest, WhatNoSceneCanHaveIsRefusedAndLeavesNoStep) {
    useFlatScene();
    const LiveRun* const before = runs.run();
    changed.clear();
    setTip(-1.0);
    EXPECT_NE(complaint().find("radius_m"), std::string::npos);
    EXPECT_EQ(changed.count(), 1) << "panels show what is";
    EXPECT_EQ(edits.wanted()->tip.radius, 15e-9);
    EXPECT_EQ(runs.run(), before);
    EXPECT_EQ(edits.undoName(), "");
}

TEST_F(SceneEditsTest, AChangeThatFailsOnTheWayLeavesSceneAndHistory) {
    const std::filesystem::path file = folder.file("steps.gsf");
    std::filesystem::copy_file(kSteps, file);
    open(file);
    setTip(20e-9);
    ASSERT_TRUE(changeEnds());
    const SceneDescription before = shown();
    std::filesystem::remove(file);
    level({});
    ASSERT_TRUE(eventually([this] { return *edits.wanted() == shown(); }));
    EXPECT_NE(complaint().find("steps.gsf"), std::string::npos);
    EXPECT_EQ(shown(), before);
    EXPECT_EQ(edits.undoName(), "Tip radius: 20 nm");
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown().tip.radius, 15e-9) << "needs no file";
}

TEST_F(SceneEditsTest, AnotherScanIsAStepAndUndoOpensTheOneBefore) {
    open(kSteps);
    EXPECT_EQ(edits.undoName(), "") << "there was none before";
    setTip(20e-9);
    ASSERT_TRUE(changeEnds());
    const SceneDescription before = shown();
    open(kGrating);
    EXPECT_EQ(edits.undoName(), "Open grating.gsf");
    const SceneDescription other = shown();
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown(), before);
    EXPECT_TRUE(window.windowTitle().startsWith("steps.gsf"));
    edits.redo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown(), other);
    edits.undo();
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown().tip.radius, 15e-9) << "two steps at once";
}

TEST_F(SceneEditsTest, TheTipComesBackToWhereItWasOnAScanBefore) {
    open(kSteps);
    const Vector2 start = run().basePosition().head<2>();
    const Vector2 position = 0.25 * Vector2(run().scene().surface.sizeX(), 0.0) + 0.5 * start;
    runs.replace(withDescription(run().loaded(), shown()), position);
    const Vector2 before = run().basePosition().head<2>();
    open(kGrating);
    runs.turn([](Settings& settings) { settings.forceGain = 100.0; });
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_LT((run().basePosition().head<2>() - before).norm(), 1e-15);
    EXPECT_EQ(run().settings().forceGain, 100.0) << "knobs stay as they are";
}

TEST_F(SceneEditsTest, UndoWhileAFileIsLoadedCancelsThat) {
    open(kSteps);
    setTip(20e-9);
    ASSERT_TRUE(changeEnds());
    begun.clear();
    scenes.open(kGrating);
    setTip(30e-9);
    EXPECT_NE(told().find("is being loaded"), std::string::npos);
    EXPECT_EQ(edits.undoName(), "Open grating.gsf");
    edits.undo();
    QTest::qWait(500);  // longer than the file takes
    EXPECT_EQ(begun.count(), 0);
    EXPECT_EQ(edits.undoName(), "Tip radius: 20 nm");
}

TEST_F(SceneEditsTest, CancelLeavesTheSceneAsItWas) {
    useFlatScene();
    const LiveRun* const before = runs.run();
    setTip(20e-9);
    edits.cancel();
    EXPECT_EQ(edits.wanted()->tip.radius, 15e-9);
    QTest::qWait(1500);  // longer than a change takes
    EXPECT_EQ(runs.run(), before);
    EXPECT_EQ(edits.undoName(), "");
    edits.cancel();
    EXPECT_EQ(complaint(), "");
}

TEST_F(SceneEditsTest, ASceneFromElsewhereHasNoHistory) {
    useFlatScene();
    mark("grain");
    setTip(20e-9);
    useFlatScene();
    EXPECT_EQ(edits.undoName(), "");
    EXPECT_EQ(edits.wanted()->tip.radius, 15e-9);
    edits.undo();
    edits.redo();
    QTest::qWait(1000);  // longer than a change takes
    EXPECT_EQ(shown().tip.radius, 15e-9);
}

TEST_F(SceneEditsTest, WithoutASceneNothingHappens) {
    EXPECT_EQ(edits.wanted(), nullptr);
    edits.change("Nothing", defaultScene());
    edits.undo();
    edits.redo();
    edits.cancel();
    EXPECT_EQ(runs.run(), nullptr);
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
