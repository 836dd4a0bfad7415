
#include "app/window/scene/ScenePanel.h"
#include "tests/app/window/ControlFixture.h"

#include <QAbstractSpinBox>
#include <QLineEdit>

namespace asperity::test {
namespace {

class ScenePanelControlTest : public ControlFixture {
protected:
    void enter(const std::string& name, const SceneValue& value) {
        for (const SceneField& field : sceneFields()) {
            if (nameOf(field) == name) {
                Q_EMIT window.findChild<ScenePanel*>()->valueEntered(field, value);
            }
        }
    }
    std::string shown(const char* key) {
        return window.findChild<ScenePanel*>()
            ->findChild<QAbstractSpinBox*>(key)
            ->text()
            .toStdString();
    }

    ScenePanelControl& control = stage.add<ScenePanelControl>();
};

TEST_F(ScenePanelControlTest, AValueBecomesTheScenesAndAStepOfTheHistory) {
    useFlatScene();
    EXPECT_EQ(shown("tip.radius_m"), "15");
    const Vector3 before = run().basePosition();
    enter("tip.radius_m", 30e-9);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().scene().belief.tipRadius(), 30e-9);
    EXPECT_EQ(shown("tip.radius_m"), "30");
    EXPECT_LT((run().basePosition() - before).head<2>().norm(), 1e-15);
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(edits.undoName(), "Tip radius: 30 nm");
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown("tip.radius_m"), "15");
}

TEST_F(ScenePanelControlTest, WhatNoSceneCanHaveIsRefusedAndTheOldValueIsBack) {
    useFlatScene();
    enter("probe.set_back_m", 9e-3);
    EXPECT_NE(complaint(), "");
    EXPECT_EQ(shown("probe.set_back_m"), "0");
    EXPECT_EQ(edits.undoName(), "");
    enter("physics.meniscus_tension_n_m", 0.072);
    EXPECT_NE(complaint().find("meniscus"), std::string::npos);
    EXPECT_EQ(shown("physics.meniscus_tension_n_m"), "0");
}

TEST_F(ScenePanelControlTest, WithoutARunNothingHappens) {
    enter("tip.radius_m", 30e-9);
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
