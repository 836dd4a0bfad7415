#include "core/scene/ModelTerm.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/TestScenes.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/panels/TradeOffChart.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
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
        window.menus().fidelity->trigger();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel()));
    }

    FidelityPanel& panel() { return window.fidelity(); }
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
        QTest::mouseClick(&chart->canvas(), Qt::LeftButton, {}, chart->placeOf(index));
        EXPECT_TRUE(changeEnds());
    }
    /// Ticks go on after what was done before.
    bool goesOn() {
        return eventually([this] { return session.run()->loop().snapshot().statistics.ticks > 5; });
    }
    const Scene& scene() { return session.run()->scene(); }
    bool isMeasuring() {
        return child<QPushButton>("measure")->text() != QStringLiteral("Measure");
    }
};

TEST_F(Fidelity, ATermOverruledIsOutAndTheRunGoesOn) {
    Settings turned = session.run()->settings();
    turned.forceGain = 250.0;
    session.run()->setSettings(turned);
    const double x = session.run()->basePosition().x();
    choose(ModelTerm::Friction, QStringLiteral("on"));
    EXPECT_TRUE(scene().model.friction);
    choose(ModelTerm::Friction, QStringLiteral("off"));
    EXPECT_FALSE(scene().model.friction);
    EXPECT_EQ(scene().description.choices.friction, false);
    EXPECT_EQ(choiceOf(ModelTerm::Friction)->currentText(), QStringLiteral("off"));
    EXPECT_EQ(session.run()->settings().forceGain, 250.0);
    EXPECT_TRUE(goesOn());
    EXPECT_NEAR(session.run()->basePosition().x(), x, 1e-12);
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
    const LiveRun* const run = session.run();
    pick(1);
    EXPECT_EQ(session.run(), run);
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
    window.menus().fidelity->trigger();
    EXPECT_FALSE(panel().isVisible());
    window.menus().fidelity->trigger();
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

}  // namespace
}  // namespace asperity::test
