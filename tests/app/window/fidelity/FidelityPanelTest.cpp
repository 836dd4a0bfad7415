#include "app/window/fidelity/FidelityPanel.h"

#include "app/window/fidelity/TradeOffChart.h"
#include "core/Units.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/ShownText.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace asperity::test {
namespace {

TickResult result(ContactLaw law, double median, double error, bool onFront) {
    return {.options = {.law = law}, .median = median, .forceErrorRms = error, .onFront = onFront};
}

TradeOff study() {
    TradeOff study;
    study.reference.forceScale = 10.0_nN;
    study.ticks = {result(ContactLaw::Hertz, 2.0_us, 1.0_nN, true),
                   result(ContactLaw::Jkr, 4.0_us, 0.5_nN, false),
                   result(ContactLaw::Maugis, 3.0_us, 0.2_nN, true),
                   result(ContactLaw::Split, 3.5_us, 0.0, true)};
    return study;
}

int rowOf(ModelTerm term) {
    return static_cast<int>(std::ranges::find(kModelTerms, term) - kModelTerms.begin());
}

RequiredTerms needs() {
    RequiredTerms needs;
    for (const ModelTerm term : kModelTerms) {
        needs.terms.push_back({.term = term});
    }
    const auto need = [&needs](ModelTerm term) -> TermNeed& {
        return needs.terms[static_cast<std::size_t>(rowOf(term))];
    };
    need(ModelTerm::Friction) = {.term = ModelTerm::Friction,
                                 .on = false,
                                 .fact = TermFact{0.3, 2e6},
                                 .effect = 0.0123,
                                 .quantity = JudgedQuantity::PullOffForce,
                                 .time = 0.52_us};
    // What relaxes has no adhesion, and so no two works of it.
    need(ModelTerm::RetractWork).possible = false;
    need(ModelTerm::OutsideDisplacement).effect = 0.25;
    need(ModelTerm::OutsideDisplacement).time = 1.5_ms;
    needs.tolerance = 0.05;
    return needs;
}

RequiredTerms needsUnder(ContactLaw law) {
    RequiredTerms all = needs();
    all.model.law = law;
    return all;
}

class FidelityPanelTest : public ::testing::Test {
protected:
    void SetUp() override {
        panel.showModel(needsUnder(ContactLaw::Maugis), {}, 1e-3);
        panel.show();
        panel.findChild<QPushButton*>(QStringLiteral("fidelityDetails"))->click();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }

    QString cell(int row, int column) {
        return panel.findChild<TermTable*>()->item(row, column)->text();
    }
    QComboBox& choiceOf(ModelTerm term) {
        return *panel.findChild<QComboBox*>(QString::fromUtf8(nameOf(term)));
    }
    TradeOffChart& chart() { return *panel.findChild<TradeOffChart*>(); }
    QString key() { return textOf(panel, "chartKey"); }

    FidelityPanel panel;
};

TEST_F(FidelityPanelTest, LeavesOutTermsThatFewSamplesHave) {
    const TermTable& table = *panel.findChild<TermTable*>();
    EXPECT_FALSE(table.isRowHidden(rowOf(ModelTerm::Relaxation)));
    RequiredTerms rigid = needsUnder(ContactLaw::Maugis);
    for (TermNeed& need : rigid.terms) {
        need.possible = need.term != ModelTerm::Relaxation && need.term != ModelTerm::FilmBase;
    }
    panel.showModel(rigid, {}, 1e-3);
    EXPECT_TRUE(table.isRowHidden(rowOf(ModelTerm::Relaxation)));
    EXPECT_FALSE(table.isRowHidden(rowOf(ModelTerm::FilmBase)));
    EXPECT_FALSE(table.isRowHidden(rowOf(ModelTerm::Drag)));
}

TEST_F(FidelityPanelTest, ShowsWhatEachTermIsWorth) {
    EXPECT_EQ(cell(rowOf(ModelTerm::Friction), 0), QStringLiteral("friction"));
    EXPECT_EQ(cell(rowOf(ModelTerm::Friction), 2), QStringLiteral("off"));
    EXPECT_EQ(cell(rowOf(ModelTerm::Friction), 3), QStringLiteral("1.2 %, pull-off force"));
    EXPECT_EQ(cell(rowOf(ModelTerm::Friction), 4), QStringLiteral("0.52 µs a tick"));
    EXPECT_EQ(cell(rowOf(ModelTerm::Friction), 5),
              QStringLiteral("friction coefficient 0.3, shear strength 2 MPa"));
    EXPECT_EQ(cell(rowOf(ModelTerm::OutsideDisplacement), 3),
              QStringLiteral("25 % of the indentation"));
    EXPECT_EQ(cell(rowOf(ModelTerm::OutsideDisplacement), 4), QStringLiteral("1.50 ms a patch"));
    EXPECT_EQ(cell(0, 3), QStringLiteral("–")) << "not measured";
}

TEST_F(FidelityPanelTest, BeginsWithOneSentenceAndShowsTheRestOnRequest) {
    RequiredTerms measured = needs();
    measured.measured = true;
    measured.wholeErrors[JudgedQuantity::PullOffForce] = 0.047;
    measured.modelTick = 8.0_us;
    panel.showModel(measured, {}, 1e-3);
    EXPECT_EQ(
        textOf(panel, "fidelityBrief").toStdString(),
        "All automatic: omitted terms change what you read by at most 4.7 %; a tick takes 8 of "
        "1000 µs.");
    panel.showModel(measured, {.law = ContactLaw::Jkr}, 1e-3);
    EXPECT_TRUE(textOf(panel, "fidelityBrief").startsWith(QStringLiteral("Partly set by hand: ")));
    EXPECT_TRUE(panel.findChild<TermTable*>()->isVisible());
    panel.findChild<QPushButton*>(QStringLiteral("fidelityDetails"))->click();
    EXPECT_FALSE(panel.findChild<TermTable*>()->isVisible());
    EXPECT_FALSE(chart().isVisible());
}

TEST_F(FidelityPanelTest, NamesTheErrorOfTheLaw) {
    RequiredTerms measured = needs();
    measured.measured = true;
    measured.lawErrors[JudgedQuantity::SnapInPosition] = 0.052;
    measured.lawMisses = {ModelTerm::SphereCorrection};
    panel.showModel(measured, {}, 1e-3);
    EXPECT_TRUE(textOf(panel, "fidelitySummary")
                    .contains(QStringLiteral("within 5.2 % (snap-in position)")));
    EXPECT_TRUE(textOf(panel, "fidelitySummary").contains(QStringLiteral("sphere correction")));
}

TEST(PercentText, HasTwoDigitsAndNoPowersOfTen) {
    EXPECT_EQ(percentText(0.0), QStringLiteral("0"));
    EXPECT_EQ(percentText(0.00123), QStringLiteral("0.12"));
    EXPECT_EQ(percentText(0.07), QStringLiteral("7.0"));
    EXPECT_EQ(percentText(0.0996), QStringLiteral("10"));
    EXPECT_EQ(percentText(2.95), QStringLiteral("295"));
}

TEST_F(FidelityPanelTest, EveryTermIsInSight) {
    panel.grab();
    EXPECT_LE(panel.height(), 760);
    const auto* table = panel.findChild<TermTable*>();
    EXPECT_LE(table->visualItemRect(table->item(rowOf(ModelTerm::OutsideDisplacement), 0)).bottom(),
              table->viewport()->height());
    for (int row = 0; row < table->rowCount(); ++row) {
        for (int column = 2; column < 5; ++column) {
            EXPECT_LE(table->fontMetrics().horizontalAdvance(cell(row, column)),
                      table->columnWidth(column));
        }
    }
}

TEST_F(FidelityPanelTest, AChoiceOfAPersonIsTold) {
    std::vector<std::pair<ModelTerm, std::optional<bool>>> told;
    QObject::connect(
        &panel, &FidelityPanel::termChosen, &panel,
        [&told](ModelTerm term, std::optional<bool> on) { told.emplace_back(term, on); });
    for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Down, Qt::Key_Home}) {
        QTest::keyClick(&choiceOf(ModelTerm::Friction), key);
    }
    ASSERT_EQ(told.size(), 3U);
    EXPECT_EQ(told[0], std::pair(ModelTerm::Friction, std::optional(true)));
    EXPECT_EQ(told[1], std::pair(ModelTerm::Friction, std::optional(false)));
    EXPECT_EQ(told[2], std::pair(ModelTerm::Friction, std::optional<bool>()));
}

TEST_F(FidelityPanelTest, WhatAProgramSetsIsShownAndNotTold) {
    bool told = false;
    QObject::connect(&panel, &FidelityPanel::termChosen, &panel, [&told] { told = true; });
    const QSignalSpy tolerance(&panel, &FidelityPanel::toleranceChosen);
    ModelChoices choices;
    choices.adhesion = true;
    choices.friction = false;
    RequiredTerms changed = needs();
    changed.tolerance = 0.1;
    panel.showModel(changed, choices, 1e-3);
    EXPECT_EQ(choiceOf(ModelTerm::Adhesion).currentText(), QStringLiteral("on"));
    EXPECT_EQ(choiceOf(ModelTerm::Friction).currentText(), QStringLiteral("off"));
    EXPECT_EQ(choiceOf(ModelTerm::Torsion).currentText(), QStringLiteral("auto"));
    EXPECT_EQ(panel.findChild<QDoubleSpinBox*>("tolerance")->value(), 10.0);
    EXPECT_FALSE(told);
    EXPECT_EQ(tolerance.count(), 0);
}

TEST_F(FidelityPanelTest, AGivenLawSaysItsTermsUntilAPersonDoes) {
    int told = 0;
    QObject::connect(&panel, &FidelityPanel::termChosen, &panel, [&told] { ++told; });
    ModelChoices choices;
    choices.law = ContactLaw::Jkr;
    panel.showModel(needs(), choices, 1e-3);
    for (const ModelTerm term : {ModelTerm::Adhesion, ModelTerm::VanDerWaalsTail,
                                 ModelTerm::SphereCorrection, ModelTerm::FilmBase}) {
        EXPECT_EQ(choiceOf(term).currentText(), QStringLiteral("set by the law"));
    }
    EXPECT_EQ(choiceOf(ModelTerm::Friction).currentText(), QStringLiteral("auto"));
    Q_EMIT choiceOf(ModelTerm::Adhesion).activated(0);
    EXPECT_EQ(told, 0) << "that is what the law says already";
    QTest::keyClick(&choiceOf(ModelTerm::Adhesion), Qt::Key_Down);
    EXPECT_EQ(told, 1);
    panel.showModel(needs(), {}, 1e-3);
    EXPECT_EQ(choiceOf(ModelTerm::Adhesion).currentText(), QStringLiteral("auto"));
}

/// Choosing it opened a box that refused it.
TEST_F(FidelityPanelTest, ATermThatCannotBeInCannotBeTurnedOnAndSaysWhy) {
    RequiredTerms noFilm = needs();
    noFilm.terms[static_cast<std::size_t>(ModelTerm::FilmBase)].possible = false;
    panel.showModel(noFilm, {}, 1e-3);
    const int on = choiceOf(ModelTerm::FilmBase).findText(QStringLiteral("on"));
    const auto isEnabled = [on](const QComboBox& combo) {
        return combo.model()->index(on, 0).flags().testFlag(Qt::ItemIsEnabled);
    };
    EXPECT_FALSE(isEnabled(choiceOf(ModelTerm::FilmBase)));
    EXPECT_EQ(choiceOf(ModelTerm::FilmBase).itemData(on, Qt::ToolTipRole).toString(),
              QStringLiteral("the sample is no film"));
    EXPECT_TRUE(isEnabled(choiceOf(ModelTerm::Friction)));
    panel.showModel(needs(), {}, 1e-3);
    EXPECT_TRUE(isEnabled(choiceOf(ModelTerm::FilmBase)));
}

TEST_F(FidelityPanelTest, WhatCannotBeMeasuredSaysWhy) {
    auto* measure = panel.findChild<QPushButton*>("measure");
    panel.refuseMeasuring(QStringLiteral("too large"));
    EXPECT_FALSE(measure->isEnabled());
    EXPECT_EQ(measure->toolTip(), QStringLiteral("too large"));
    panel.refuseMeasuring({});
    EXPECT_TRUE(measure->isEnabled());
}

TEST_F(FidelityPanelTest, TheToleranceIsToldAsAShare) {
    QSignalSpy chosen(&panel, &FidelityPanel::toleranceChosen);
    auto* box = panel.findChild<QDoubleSpinBox*>("tolerance");
    box->selectAll();
    QTest::keyClicks(box, "2");
    EXPECT_EQ(chosen.count(), 0) << "not before it is whole";
    QTest::keyClick(box, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_DOUBLE_EQ(chosen[0][0].toDouble(), 0.02);
}

TEST_F(FidelityPanelTest, AClickPicksTheNearestPoint) {
    panel.showTradeOff(study());
    panel.grab();
    std::vector<ForceModelOptions> picked;
    QObject::connect(&panel, &FidelityPanel::optionsPicked, &panel,
                     [&picked](const ForceModelOptions& options) { picked.push_back(options); });
    QTest::mouseClick(&chart().canvas(), Qt::LeftButton, {}, chart().positionOf(1) + QPoint(3, -3));
    ASSERT_EQ(picked.size(), 1U);
    EXPECT_EQ(picked[0].law, ContactLaw::Jkr);
    QTest::mouseClick(&chart().canvas(), Qt::LeftButton, {},
                      QPoint(chart().canvas().width() - 5, chart().canvas().height() - 5));
    EXPECT_EQ(picked.size(), 1U) << "no point is near";
}

TEST_F(FidelityPanelTest, TheFrontIsNumberedAndThePresentTickRinged) {
    panel.showTradeOff(study());
    EXPECT_EQ(chart().current(), 2);
    EXPECT_TRUE(key().contains(QStringLiteral("1</b></span>&nbsp; Hertz"))) << key().toStdString();
    EXPECT_TRUE(key().contains(QStringLiteral("2.00 µs, 1 nN (10 % of the force)")));
    EXPECT_TRUE(key().contains(QStringLiteral("3.50 µs, below 0.001 % of the force")));
    EXPECT_FALSE(key().contains(QStringLiteral("JKR"))) << "another is cheaper and nearer";
    panel.showModel(needsUnder(ContactLaw::Jkr), {}, 1e-3);
    EXPECT_EQ(chart().current(), 1);
    panel.showModel(needsUnder(ContactLaw::Sneddon), {}, 1e-3);
    EXPECT_EQ(chart().current(), -1) << "it was not measured";
}

TEST_F(FidelityPanelTest, SaysHowFarItMeasuresAndStops) {
    const QSignalSpy asked(&panel, &FidelityPanel::measureRequested);
    const QSignalSpy stopped(&panel, &FidelityPanel::stopRequested);
    auto* measure = panel.findChild<QPushButton*>("measure");
    EXPECT_TRUE(textOf(panel, "chartHint").contains("Measure"));
    QTest::mouseClick(measure, Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
    EXPECT_EQ(stopped.count(), 0);
    panel.setMeasuring(0.354);
    EXPECT_EQ(measure->text(), QStringLiteral("Stop (35 %)"));
    EXPECT_EQ(textOf(panel, "chartHint"), QStringLiteral("measuring…"));
    QTest::mouseClick(measure, Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
    EXPECT_EQ(stopped.count(), 1);
    panel.setMeasuring(std::nullopt);
    EXPECT_EQ(measure->text(), QStringLiteral("Measure"));
}

}  // namespace
}  // namespace asperity::test
