#include "app/session/ParameterControl.h"

#include "app/session/MaterialControl.h"
#include "tests/app/session/ControlFixture.h"
#include "ui/panels/ParameterPanel.h"

#include <QAbstractSpinBox>
#include <QComboBox>

namespace asperity::test {
namespace {

class ParameterControlTest : public ControlFixture {
protected:
    void enter(SceneParameter parameter, double value) {
        Q_EMIT window.parameters().parameterEntered(parameter, value);
    }
    const SceneDescription& description() { return run().scene().description; }
    std::string shown(const char* box) {
        return window.parameters().findChild<QAbstractSpinBox*>(box)->text().toStdString();
    }

    MaterialControl materials{window, runs, edits};
    ParameterControl parameters{window, runs, edits};
};

TEST_F(ParameterControlTest, ARunBeginsAnewAboveTheSamePlaceWithTheNewValue) {
    useFlatScene();
    EXPECT_EQ(shown("tipRadius"), "15");
    const Vector3 before = run().basePosition();
    enter(SceneParameter::TipRadius, 30e-9);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().scene().belief.contact.pair().tipRadius, 30e-9);
    EXPECT_EQ(shown("tipRadius"), "30");
    EXPECT_LT((run().basePosition() - before).head<2>().norm(), 1e-15);
    EXPECT_TRUE(run().loop().running());
    enter(SceneParameter::SpringConstant, 2.0);
    ASSERT_TRUE(changeEnds());
    EXPECT_NEAR(run().scene().belief.cantilever.stiffness(), 2.0, 1e-12);
}

TEST_F(ParameterControlTest, ListsAChangedMaterialOnce) {
    useFlatScene();
    enter(SceneParameter::YoungsModulus, 3e9);
    enter(SceneParameter::Hardness, 1e9);
    ASSERT_TRUE(changeEnds());
    const auto& list = *window.findChild<QComboBox*>("material");
    EXPECT_EQ(list.currentText(), "polystyrene (edited)");
    int edited = 0;
    for (int i = 0; i < list.count(); ++i) {
        edited += list.itemText(i).endsWith("(edited)") ? 1 : 0;
    }
    EXPECT_EQ(edited, 1);
}

TEST_F(ParameterControlTest, WhatNoSceneCanHaveIsRefusedAndTheRunGoesOn) {
    useFlatScene();
    enter(SceneParameter::TipRadius, -1.0);
    EXPECT_NE(complaint().find("radius_m"), std::string::npos);
    EXPECT_EQ(shown("tipRadius"), "15");
    EXPECT_TRUE(run().loop().running());
}

TEST_F(ParameterControlTest, WithoutARunNothingHappens) {
    enter(SceneParameter::TipRadius, 30e-9);
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
