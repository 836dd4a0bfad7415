#include "app/window/fidelity/FidelityControl.h"
#include "app/window/fidelity/FidelityPanel.h"
#include "app/window/fidelity/TradeOffChart.h"
#include "core/scene/ModelTerm.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/TestScenes.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QtTest>

#include <optional>
#include <vector>

namespace asperity::test {
namespace {

TradeOff twoWays() {
    TradeOff study;
    study.reference.forceScale = 1e-8;
    study.ticks = {
        {.options = {.law = ContactLaw::Hertz, .closestPointSearch = SearchEffort::Local},
         .median = 2e-6,
         .forceErrorRms = 1e-9,
         .onFront = true},
        {.options = {.law = ContactLaw::Jkr,
                     .solver = SolverSetting::Table,
                     .closestPointSearch = SearchEffort::Global},
         .median = 4e-6,
         .forceErrorRms = 1e-10,
         .onFront = true}};
    return study;
}

class Fidelity : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        openFlatScene();
        window.menus().entry("fidelity").trigger();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel()));
        child<QPushButton>("fidelityDetails")->click();
    }

    FidelityPanel& panel() { return *window.findChild<FidelityPanel*>(); }
    QComboBox* choiceOf(ModelTerm term) { return child<QComboBox>(nameOf(term)); }
    void choose(ModelTerm term, const QString& choice) {
        QComboBox* combo = choiceOf(term);
        while (combo->currentText() != choice) {
            QTest::keyClick(combo, combo->currentIndex() < combo->findText(choice) ? Qt::Key_Down
                                                                                   : Qt::Key_Up);
        }
        EXPECT_TRUE(changeEnds());
    }
    void pick(int index) {
        auto* chart = panel().findChild<TradeOffChart*>();
        panel().grab();
        QTest::mouseClick(&chart->canvas(), Qt::LeftButton, {}, chart->positionOf(index));
        EXPECT_TRUE(changeEnds());
    }
    /// Ticks go on after what was done before.
    bool goesOn() {
        return eventually([this] { return stage.run()->loop().snapshot().statistics.ticks > 5; });
    }
    const Scene& scene() { return stage.run()->scene(); }
    bool isMeasuring() {
        return child<QPushButton>("measure")->text() != QStringLiteral("Measure");
    }
};

TEST_F(Fidelity, ATermOverruledIsOutAndTheRunGoesOn) {
    Settings turned = stage.run()->settings();
    turned.forceGain = 250.0;
    stage.run()->setSettings(turned);
    const double x = stage.run()->basePosition().x();
    choose(ModelTerm::Friction, QStringLiteral("on"));
    EXPECT_TRUE(scene().model.friction);
    choose(ModelTerm::Friction, QStringLiteral("off"));
    EXPECT_FALSE(scene().model.friction);
    EXPECT_EQ(scene().description.choices.friction, false);
    EXPECT_EQ(choiceOf(ModelTerm::Friction)->currentText(), QStringLiteral("off"));
    EXPECT_EQ(stage.run()->settings().forceGain, 250.0);
    EXPECT_TRUE(goesOn());
    EXPECT_NEAR(stage.run()->basePosition().x(), x, 1e-12);
    choose(ModelTerm::Friction, QStringLiteral("auto"));
    EXPECT_FALSE(scene().description.choices.friction.has_value());
}

TEST_F(Fidelity, ClosestPointsAndDeformationAreChosenByTheirTerms) {
    choose(ModelTerm::GlobalSearch, QStringLiteral("off"));
    EXPECT_EQ(scene().description.choices.closestPointSearch, SearchEffort::Local);
    choose(ModelTerm::OutsideDisplacement, QStringLiteral("off"));
    EXPECT_EQ(scene().model.deformation, DeformationModel::ContactRadius);
    EXPECT_EQ(choiceOf(ModelTerm::HalfSpaceSolve)->currentText(), QStringLiteral("off"))
        << "one choice for both";
    choose(ModelTerm::HalfSpaceSolve, QStringLiteral("auto"));
    EXPECT_FALSE(scene().description.choices.deformation.has_value());
    EXPECT_TRUE(goesOn());
}

TEST_F(Fidelity, AWayForTheTickIsPickedInTheChartAndTakenBack) {
    panel().showTradeOff(twoWays());
    pick(1);
    EXPECT_EQ(ofForce(scene().model), twoWays().ticks[1].options);
    EXPECT_TRUE(goesOn());
    EXPECT_EQ(panel().findChild<TradeOffChart*>()->current(), 1);
    EXPECT_EQ(choiceOf(ModelTerm::Adhesion)->currentText(), QStringLiteral("set by the law"));
    pick(0);
    EXPECT_EQ(scene().model.law, ContactLaw::Hertz);
    QTest::mouseClick(child<QPushButton>("allAutomatic"), Qt::LeftButton);
    ASSERT_TRUE(changeEnds());
    EXPECT_FALSE(scene().description.choices.law.has_value());
    EXPECT_FALSE(scene().description.choices.torsion.has_value());
    EXPECT_EQ(choiceOf(ModelTerm::Adhesion)->currentText(), QStringLiteral("auto"));
    EXPECT_TRUE(goesOn());
}

TEST_F(Fidelity, ATermOfTheLawFreesAPickedLaw) {
    panel().showTradeOff(twoWays());
    pick(0);
    ASSERT_EQ(scene().model.law, ContactLaw::Hertz);
    choose(ModelTerm::Adhesion, QStringLiteral("on"));
    EXPECT_FALSE(scene().description.choices.law.has_value());
    EXPECT_TRUE(has(scene().model, ModelTerm::Adhesion));
    EXPECT_TRUE(goesOn());
}

TEST_F(Fidelity, AModelThatCannotBeIsRefusedAndTheSceneStays) {
    TradeOff study = twoWays();
    study.ticks[1].options.law = ContactLaw::HertzFilm;  // the sample has no film
    panel().showTradeOff(study);
    const LiveRun* const run = stage.run();
    pick(1);
    EXPECT_EQ(stage.run(), run);
    EXPECT_NE(window.findChild<QWidget*>("qt_msgbox_label"), nullptr);
    EXPECT_FALSE(scene().description.choices.law.has_value());
}

TEST_F(Fidelity, AllAutomaticResetsTheTolerance) {
    auto* tolerance = child<QDoubleSpinBox>("tolerance");
    tolerance->setValue(20.0);
    ASSERT_TRUE(changeEnds());
    ASSERT_DOUBLE_EQ(scene().description.tolerance, 0.2);
    QTest::mouseClick(child<QPushButton>("allAutomatic"), Qt::LeftButton);
    ASSERT_TRUE(changeEnds());
    EXPECT_DOUBLE_EQ(scene().description.tolerance, 0.05);
    EXPECT_EQ(tolerance->value(), 5.0);
}

TEST_F(Fidelity, TheKeyThatOpensItClosesIt) {
    window.menus().entry("fidelity").trigger();
    EXPECT_FALSE(panel().isVisible());
    window.menus().entry("fidelity").trigger();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel()));
    QApplication::setActiveWindow(&panel());
    QTest::keyClick(&panel(), Qt::Key_F6);
    EXPECT_FALSE(panel().isVisible()) << "while it has the focus, too";
}

TEST_F(Fidelity, MeasuresBesideTheRun) {
    QTest::mouseClick(child<QPushButton>("measure"), Qt::LeftButton);
    EXPECT_TRUE(isMeasuring());
    EXPECT_TRUE(eventually([this] { return panel().tradeOff().has_value(); }, 120000));
    EXPECT_FALSE(isMeasuring());
    EXPECT_GT(panel().tradeOff()->ticks.size(), 4U);
    EXPECT_GE(panel().findChild<TradeOffChart*>()->current(), 0);
}

TEST_F(Fidelity, WhatWasMeasuredOfASceneBeforeIsDropped) {
    QTest::mouseClick(child<QPushButton>("measure"), Qt::LeftButton);
    openFlatScene();
    EXPECT_TRUE(eventually([this] { return !isMeasuring(); }, 120000));
    EXPECT_FALSE(panel().tradeOff().has_value());
}

TEST_F(Fidelity, AMeasurementCanBeStopped) {
    QTest::mouseClick(child<QPushButton>("measure"), Qt::LeftButton);
    EXPECT_TRUE(eventually(
        [this] { return child<QPushButton>("measure")->text() != QStringLiteral("Stop (0 %)"); },
        120000))
        << "says how far it is";
    ASSERT_TRUE(isMeasuring());
    QTest::mouseClick(child<QPushButton>("measure"), Qt::LeftButton);
    EXPECT_TRUE(eventually([this] { return !isMeasuring(); }, 10000));
    EXPECT_FALSE(panel().tradeOff().has_value());
}

TEST_F(Fidelity, AScanTooLargeToBeCopiedIsNotMeasured) {
    constexpr int kSide = 2049;
    const HeightMap wide{.columns = kSide,
                         .rows = kSide,
                         .pitchX = 1e-9,
                         .pitchY = 1e-9,
                         .heights = std::vector<double>(std::size_t{kSide} * kSide, 0.0)};
    EXPECT_FALSE(canBeStudied(buildScene(plainScene(), wide)));
    EXPECT_TRUE(canBeStudied(scene()));
}

TEST_F(Window, FidelityOpensBesideItAndStaysWhereItIsPut) {
    window.resize(900, 658);
    FidelityPanel& fidelity = *window.findChild<FidelityPanel*>();
    window.menus().entry("fidelity").trigger();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&fidelity));
    const QRect screen = window.screen()->availableGeometry();
    EXPECT_TRUE(screen.contains(fidelity.geometry()));
    EXPECT_GT(fidelity.pos().x(), window.pos().x());
    fidelity.move(40, 60);
    fidelity.hide();
    window.menus().entry("fidelity").trigger();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&fidelity));
    EXPECT_EQ(fidelity.pos(), QPoint(40, 60));
}

TEST_F(Window, FidelityFitsASmallScreen) {
    FidelityPanel& fidelity = *window.findChild<FidelityPanel*>();
    child<QPushButton>("fidelityDetails")->click();
    EXPECT_LE(fidelity.minimumSizeHint().width(), 1012);
    EXPECT_LE(fidelity.minimumSizeHint().height(), 658);
}

TEST_F(Window, WindowsOfTheirOwnSayARefusalThemselves) {
    window.resize(1280, 800);
    QWidget* tool = window.findChild<FidelityPanel*>();
    tool->show();
    child<QPushButton>("fidelityDetails")->click();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(tool));
    QApplication::setActiveWindow(tool);
    auto& box = *tool->findChild<QAbstractSpinBox*>();
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("oops"));
    QTest::keyClick(&box, Qt::Key_Tab);
    const auto& line = *tool->findChild<QLabel*>(QStringLiteral("refusal"));
    EXPECT_TRUE(line.text().startsWith("“oops” is not valid")) << line.text().toStdString();
    EXPECT_TRUE(window.statusBar()->currentMessage().isEmpty());
}

}  // namespace
}  // namespace asperity::test
