#include "app/window/scene/ScenePanel.h"

#include "app/window/scene/LevelingEditor.h"
#include "app/window/scene/LibraryControl.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity {
namespace {

struct Entry {
    std::string name;
    SceneValue value;
};

class ScenePanelTest : public ::testing::Test {
protected:
    ScenePanelTest() {
        QObject::connect(&panel, &ScenePanel::valueEntered,
                         [this](const SceneField& field, const SceneValue& value) {
                             entered.push_back({nameOf(field), value});
                         });
    }

    template <class Widget>
    Widget& control(const std::string& name) {
        auto* found = panel.findChild<Widget*>(QString::fromStdString(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void show(const SceneDescription& scene) { panel.showScene(scene, defaultsOf(scene)); }
    void type(const std::string& name, const char* text) {
        auto& box = control<QWidget>(name);
        QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&box, QString::fromUtf8(text));
        QTest::keyClick(&box, Qt::Key_Return);
    }
    std::string number(const std::string& name) {
        return control<QAbstractSpinBox>(name).text().toStdString();
    }
    bool canReset(const std::string& name) {
        return !control<QToolButton>(name + ".reset").isHidden();
    }

    ScenePanel panel;
    std::vector<Entry> entered;
};

TEST_F(ScenePanelTest, EveryKeyHasAControlWithAToolTip) {
    show(defaultScene());
    for (const SceneField& field : sceneFields()) {
        if (field.input == SceneInput::Positions) {
            EXPECT_NE(panel.findChild<QAbstractSpinBox*>("levelPlace2y"), nullptr);
            continue;  // they are entered with the steps
        }
        EXPECT_FALSE(control<QWidget>(nameOf(field)).toolTip().isEmpty()) << nameOf(field);
        EXPECT_FALSE(control<QWidget>(nameOf(field) + ".reset").toolTip().isEmpty());
    }
    EXPECT_TRUE(entered.empty());
}

TEST_F(ScenePanelTest, ShowsASceneInTheUnitsOfALab) {
    show(defaultScene());
    EXPECT_EQ(number("tip.radius_m"), "15");
    EXPECT_EQ(number("probe.stiffness_n_m"), "14");
    EXPECT_EQ(number("sample.youngs_modulus_pa"), "2");
    EXPECT_EQ(number("sample.work_of_adhesion_j_m2"), "66");
    EXPECT_EQ(number("sample.hardness_pa"), "0.3");
    EXPECT_EQ(number("probe.length_m"), "150");
    EXPECT_EQ(number("approach.setpoint_n"), "5");
    EXPECT_EQ(control<QComboBox>("physics.law").currentText(), "automatic");
    EXPECT_EQ(control<LevelingEditor>("sample.level").steps(), LevelingSteps{LevelingStep::Plane});
    EXPECT_FALSE(control<QCheckBox>("sample.erode").isChecked());
    EXPECT_TRUE(entered.empty());
}

TEST_F(ScenePanelTest, GivesWhatIsEnteredInSiUnits) {
    SceneDescription scene = defaultScene();
    scene.sample.imagingTipRadius = 1e-8;
    show(scene);
    type("tip.radius_m", "30");
    type("sample.work_of_adhesion_j_m2", "0");
    type("sample.crop_px", "2, 3, 20, 10");
    control<QCheckBox>("sample.erode").click();
    auto& law = control<QComboBox>("physics.law");
    Q_EMIT law.activated(law.findText("JKR"));
    ASSERT_EQ(entered.size(), 5U);
    EXPECT_EQ(entered[0].name, "tip.radius_m");
    EXPECT_EQ(std::get<double>(entered[0].value), 30e-9);
    EXPECT_EQ(std::get<double>(entered[1].value), 0.0);
    EXPECT_EQ(std::get<std::string>(entered[2].value), "2, 3, 20, 10");
    EXPECT_EQ(std::get<bool>(entered[3].value), true);
    EXPECT_EQ(std::get<std::string>(entered[4].value), "jkr");
}

/// Some had "200.000000" beside "30".
TEST_F(ScenePanelTest, ShowsWhatIsEnteredAsItWasTyped) {
    show(defaultScene());
    for (const char* name : {"tip.radius_m", "probe.stiffness_n_m", "sample.youngs_modulus_pa",
                             "sample.work_of_adhesion_j_m2", "sample.hardness_pa"}) {
        for (const char* text : {"30", "9", "50", "0.5", "12.345"}) {
            type(name, text);
            EXPECT_EQ(number(name), text) << name;
        }
    }
}

TEST_F(ScenePanelTest, ADefaultIsMutedAndWhatIsSetGoesBackToIt) {
    SceneDescription scene = defaultScene();
    show(scene);
    EXPECT_FALSE(canReset("tip.radius_m"));
    const auto color = [this] {
        return control<QAbstractSpinBox>("tip.radius_m")
            .findChild<QLineEdit*>()
            ->palette()
            .color(QPalette::Text);
    };
    const QColor muted = color();
    scene.tip.radius = 30e-9;
    show(scene);
    EXPECT_TRUE(canReset("tip.radius_m"));
    EXPECT_NE(color(), muted);
    control<QToolButton>("tip.radius_m.reset").click();
    ASSERT_EQ(entered.size(), 1U);
    EXPECT_EQ(std::get<double>(entered[0].value), 15e-9);
}

TEST_F(ScenePanelTest, WhatIsNoValueIsRefusedInWords) {
    show(defaultScene());
    const QSignalSpy refused(&panel, &ScenePanel::refused);
    type("sample.crop_px", "half");
    ASSERT_EQ(refused.count(), 1);
    EXPECT_TRUE(refused[0][0].toString().startsWith("“half” is not valid: it must be four"));
    EXPECT_EQ(control<QLineEdit>("sample.crop_px").text(), "");
    auto& box = control<NumberBox>("tip.radius_m");
    const QSignalSpy numbers(&box, &NumberBox::refused);
    type("tip.radius_m", "-3");
    EXPECT_EQ(numbers.count(), 1);
    EXPECT_TRUE(entered.empty());
}

TEST_F(ScenePanelTest, StepsOfLevelingAreAddedAndGoBackToTheDefault) {
    show(defaultScene());
    LevelingSteps steps;
    QObject::connect(&panel, &ScenePanel::levelingEntered,
                     [&](const LevelingSteps& now,
                         const std::optional<LevelPoints>& /*positions*/) { steps = now; });
    control<QToolButton>("addLevelingStep").menu()->actions().last()->trigger();
    EXPECT_EQ(steps, (LevelingSteps{LevelingStep::Plane, LevelingStep::Zero}));
    SceneDescription scene = defaultScene();
    scene.sample.leveling = steps;
    show(scene);
    control<QToolButton>("sample.level.reset").click();
    EXPECT_EQ(steps, LevelingSteps{LevelingStep::Plane});
    EXPECT_TRUE(entered.empty());
}

TEST_F(ScenePanelTest, KeysThatMeanNothingSayWhy) {
    SceneDescription scene = defaultScene();
    show(scene);
    EXPECT_FALSE(control<QWidget>("sample.shape_radius_m").isEnabledTo(&panel));
    EXPECT_EQ(control<QWidget>("sample.shape_radius_m").toolTip(),
              "The sample is a scan, no shape");
    scene.sample.shape = ShapeDescription{};
    show(scene);
    EXPECT_TRUE(control<QWidget>("sample.shape_radius_m").isEnabledTo(&panel));
    EXPECT_FALSE(control<QWidget>("sample.level").isEnabledTo(&panel));
}

TEST_F(ScenePanelTest, OffersTheChannelsOfTheFile) {
    panel.setChannels({"Height", "Phase"});
    SceneDescription scene = defaultScene();
    scene.sample.channel = "Phase";
    show(scene);
    auto& channel = control<QComboBox>("sample.channel");
    EXPECT_EQ(channel.currentText(), "Phase");
    Q_EMIT channel.activated(0);
    ASSERT_EQ(entered.size(), 1U);
    EXPECT_EQ(std::get<std::string>(entered[0].value), "Height");
}

TEST_F(ScenePanelTest, SectionsFold) {
    show(defaultScene());
    auto& tip = control<Section>("sectionTip");
    EXPECT_FALSE(tip.isFolded());
    auto& truth = control<Section>("sectionTruth");
    EXPECT_TRUE(truth.isFolded());
    truth.findChild<QToolButton*>("sectionHeading")->click();
    EXPECT_FALSE(truth.isFolded());
    EXPECT_FALSE(control<QWidget>("truth.temperature_k").isHidden());
}

TEST_F(ScenePanelTest, ALibraryOffersToRenameAndDeleteOnlyWhatIsTheUsers) {
    show(defaultScene());
    LibraryBar& bar = panel.materials();
    const QSignalSpy saved(&bar, &LibraryBar::saveRequested);
    const QSignalSpy deleted(&bar, &LibraryBar::deleteRequested);
    bar.setEntries({"polystyrene", "mine (own)"}, {"from a table", ""});
    bar.setCurrent(0);
    EXPECT_FALSE(control<QToolButton>("deleteMaterial").isEnabledTo(&bar));
    control<QToolButton>("saveMaterial").click();
    EXPECT_EQ(saved.count(), 1);
    bar.setCurrent(1);
    bar.setOwn(true);
    control<QToolButton>("deleteMaterial").click();
    EXPECT_EQ(deleted.count(), 1);
    EXPECT_EQ(control<QComboBox>("materialLibrary").itemData(0, Qt::ToolTipRole), "from a table");
}

TEST_F(ScenePanelTest, LeadsToTheCostsOfTheTerms) {
    show(defaultScene());
    const QSignalSpy wanted(&panel, &ScenePanel::fidelityRequested);
    control<QPushButton>("showFidelity").click();
    EXPECT_EQ(wanted.count(), 1);
}

/// It showed 0 µm for a scan of 10 µm.
TEST_F(ScenePanelTest, AWidthThatIsTheFilesSaysWhichOneThatIs) {
    panel.setScanSize({10e-6, 5e-6});
    SceneDescription scene = defaultScene();
    show(scene);
    EXPECT_EQ(number("sample.size_x_m"), "10 (file)");
    EXPECT_EQ(number("sample.size_y_m"), "5 (file)");
    type("sample.size_x_m", "20");
    ASSERT_EQ(entered.size(), 1U);
    EXPECT_DOUBLE_EQ(std::get<double>(entered[0].value), 20e-6);
    scene.sample.scale.sizeX = 20e-6;
    show(scene);
    EXPECT_EQ(number("sample.size_x_m"), "20");
    scene.sample.scale.sizeX = 0.0;
    scene.sample.crop = PixelRectangle{0, 0, 8, 8};
    show(scene);
    EXPECT_EQ(number("sample.size_x_m"), "as in the file") << "the part is smaller";
}

}  // namespace
}  // namespace asperity
