#include "app/window/scene/LevelingEditor.h"

#include "ui/widgets/NumberBox.h"

#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <gtest/gtest.h>

#include <string>

namespace asperity::test {
namespace {

class LevelingEditorTest : public ::testing::Test {
protected:
    LevelingEditorTest() { editor.setScanSize({2e-6, 1e-6}); }

    QListWidget& list() { return *editor.findChild<QListWidget*>("levelingSteps"); }
    void press(const char* name) {
        auto* button = editor.findChild<QToolButton*>(QString::fromUtf8(name));
        ASSERT_TRUE(button->isEnabled()) << name;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    bool canPress(const char* name) {
        return editor.findChild<QToolButton*>(QString::fromUtf8(name))->isEnabled();
    }
    QAction* entry(LevelingStep step) {
        for (QAction* each : editor.findChild<QToolButton*>("addLevelingStep")->menu()->actions()) {
            if (each->data().toInt() == static_cast<int>(step)) {
                return each;
            }
        }
        return nullptr;
    }
    NumberBox& box(const char* name) { return *editor.findChild<NumberBox*>(name); }
    std::string text() { return textOf(editor.steps()); }

    LevelingEditor editor;
    QSignalSpy edited{&editor, &LevelingEditor::edited};
};

TEST_F(LevelingEditorTest, ShowsTheStepsInTheirOrder) {
    editor.setLeveling({LevelingStep::Plane, LevelingStep::Rows}, std::nullopt);
    ASSERT_EQ(list().count(), 2);
    EXPECT_EQ(list().item(0)->text(), "plane");
    EXPECT_EQ(list().item(1)->text(), "median of each row");
    EXPECT_EQ(edited.count(), 0) << "the user has done nothing";
}

TEST_F(LevelingEditorTest, OffersEveryStepWithWhatItDoes) {
    for (const LevelingStep step : kValues<LevelingStep>) {
        ASSERT_NE(entry(step), nullptr) << keyOf(step);
        EXPECT_FALSE(entry(step)->toolTip().isEmpty()) << keyOf(step);
        entry(step)->trigger();
        EXPECT_EQ(editor.steps().back(), step);
    }
    EXPECT_EQ(edited.count(), static_cast<int>(kValues<LevelingStep>.size()));
}

TEST_F(LevelingEditorTest, RemovesAndMovesTheOneThatIsChosen) {
    editor.setLeveling({LevelingStep::Plane, LevelingStep::Scars, LevelingStep::Zero}, {});
    EXPECT_FALSE(canPress("removeLevelingStep"));
    list().setCurrentRow(1);
    press("raiseLevelingStep");
    EXPECT_EQ(text(), "scars, plane, zero");
    EXPECT_FALSE(canPress("raiseLevelingStep")) << "it is the first";
    press("lowerLevelingStep");
    press("lowerLevelingStep");
    EXPECT_EQ(text(), "plane, zero, scars");
    EXPECT_FALSE(canPress("lowerLevelingStep")) << "it is the last";
    press("removeLevelingStep");
    press("removeLevelingStep");
    EXPECT_EQ(text(), "plane");
    press("removeLevelingStep");
    EXPECT_EQ(text(), "none");
    EXPECT_FALSE(canPress("removeLevelingStep"));
    EXPECT_EQ(edited.count(), 6);
}

TEST_F(LevelingEditorTest, ThreePointBeginsWithPlacesOnTheScan) {
    editor.show();
    EXPECT_FALSE(box("levelPlace0x").isVisible());
    entry(LevelingStep::ThreePoint)->trigger();
    ASSERT_TRUE(editor.points());
    EXPECT_EQ(refusalOf(*editor.points()), "");
    for (const Vector2& point : *editor.points()) {
        EXPECT_TRUE(point.x() > 0.0 && point.x() < 2e-6 && point.y() > 0.0 && point.y() < 1e-6);
    }
    EXPECT_TRUE(box("levelPlace0x").isVisible());
    box("levelPlace2y").setValue(0.25);
    EXPECT_NEAR(editor.points()->at(2).y(), 0.25e-6, 1e-15);
    EXPECT_EQ(edited.count(), 2);
}

TEST_F(LevelingEditorTest, PlacesOnOneLineAreNotTaken) {
    const LevelPoints positions{Vector2(0.0, 0.0), Vector2(1e-6, 0.0), Vector2(0.0, 1e-6)};
    editor.setLeveling({LevelingStep::ThreePoint}, positions);
    box("levelPlace2y").setValue(0.0);
    EXPECT_EQ(editor.points(), positions);
    EXPECT_EQ(box("levelPlace2y").value(), 1.0);
    EXPECT_EQ(edited.count(), 0);
}

TEST_F(LevelingEditorTest, WithoutASizeThereAreNoPlaces) {
    editor.setScanSize({});
    EXPECT_FALSE(entry(LevelingStep::ThreePoint)->isEnabled());
    EXPECT_TRUE(entry(LevelingStep::Plane)->isEnabled());
}

}  // namespace
}  // namespace asperity::test
