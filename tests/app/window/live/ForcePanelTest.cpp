#include "app/window/live/ForcePanel.h"

#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/ReadingBudget.h"

#include <QApplication>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

TickSample indented() {
    TickSample sample = test::tickWithForce(1.0, Vector3(1.5e-9, -2.25e-9, 12.3e-9));
    sample.output.estimate.covariance.diagonal() << 0.01e-18, 0.04e-18, 0.09e-18;
    sample.output.tip = Vector3(1.23456e-6, 0.5e-6, 34.56e-9);
    sample.output.model.contact.indentation = 1.63e-9;
    sample.output.model.contact.branch = ContactBranch::Bonded;
    sample.output.model.contact.contactRadius = 5.79e-9;
    return sample;
}

const CurvePlot& plotOf(const ForcePanel& panel, const char* name) {
    return *panel.findChild<CurvePlot*>(QString::fromUtf8(name));
}

TEST(ForcePanel, ShowsForcesWithTheirStandardDeviations) {
    ForcePanel panel;
    panel.show(test::snapshotOf(indented()));
    EXPECT_EQ(test::textOf(panel, "forceX"), QStringLiteral("1.50 nN"));
    EXPECT_EQ(test::textOf(panel, "forceY"), QStringLiteral("-2.25 nN"));
    EXPECT_EQ(test::textOf(panel, "forceZ"), QStringLiteral("12.3 nN"));
    EXPECT_EQ(test::textOf(panel, "forceMagnitude"), QStringLiteral("12.6 nN"));
    EXPECT_EQ(test::textOf(panel, "forceXSigma"), QStringLiteral("± 0.10"));
    EXPECT_EQ(test::textOf(panel, "forceYSigma"), QStringLiteral("± 0.20"));
    EXPECT_EQ(test::textOf(panel, "forceZSigma"), QStringLiteral("± 0.30"));
}

TEST(ForcePanel, ShowsPlaceIndentationAndContactRadius) {
    ForcePanel panel;
    panel.show(test::snapshotOf(indented()));
    EXPECT_EQ(test::textOf(panel, "tipX"), QStringLiteral("1.2346 µm"));
    EXPECT_EQ(test::textOf(panel, "tipY"), QStringLiteral("0.5000 µm")) << "one unit for x and y";
    EXPECT_EQ(test::textOf(panel, "tipZ"), QStringLiteral("34.56 nm"));
    EXPECT_EQ(test::textOf(panel, "distanceName"), QStringLiteral("indentation"));
    EXPECT_EQ(test::textOf(panel, "distance"), QStringLiteral("1.63 nm"));
    EXPECT_EQ(test::textOf(panel, "contactRadius"), QStringLiteral("5.79 nm"));
    panel.show(test::snapshotOf(test::tickWithForce(2.0, Vector3::Zero())));
    EXPECT_EQ(test::textOf(panel, "contactRadius"), QStringLiteral("0 nm"));
}

TEST(ForcePanel, TheDistanceIsPositiveUnderAClearName) {
    ForcePanel panel;
    TickSample sample = indented();
    ContactState& contact = sample.output.model.contact;
    const auto shown = [&] {
        panel.show(test::snapshotOf(sample));
        return test::textOf(panel, "distanceName") + QLatin1Char(' ') +
               test::textOf(panel, "distance");
    };
    contact.indentation = -0.5e-9;
    EXPECT_EQ(shown(), QStringLiteral("neck height 0.50 nm")) << "pulled up, still in contact";
    contact.cohesiveRadius = 2e-9;
    contact.contactRadius = 0.0;
    EXPECT_EQ(shown(), QStringLiteral("gap 0.50 nm")) << "bonded across a gap";
    contact = {.indentation = -7e-9};
    EXPECT_EQ(shown(), QStringLiteral("gap 7.00 nm"));
}

TEST(ForcePanel, TheUnitIsThatOfTheLargestForceOrOfItsUncertainty) {
    ForcePanel panel;
    TickSample sample = test::tickWithForce(0.0, Vector3(0.0, 0.0, 20e-12));
    panel.show(test::snapshotOf(sample));
    EXPECT_EQ(test::textOf(panel, "forceZ"), QStringLiteral("20.0 pN"));
    sample.output.estimate.covariance(2, 2) = 4e-18;
    panel.show(test::snapshotOf(sample));
    EXPECT_EQ(test::textOf(panel, "forceZ"), QStringLiteral("0.02 nN"));
    EXPECT_EQ(test::textOf(panel, "forceZSigma"), QStringLiteral("± 2.00"));
}

const QLabel& labelOf(const ForcePanel& panel, const char* name) {
    return *panel.findChild<QLabel*>(QString::fromUtf8(name));
}

/// The panel has one deviation, the tool tip both, and what makes up most of the second.
TEST(ForcePanel, SaysNoiseAndModelApartInItsToolTips) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    ForcePanel panel;
    panel.begin(scene);
    TickSample sample = indented();
    panel.show(test::snapshotOf(sample));
    // 12.3 nN, of which 10 % by k and 3 % by InvOLS, and noise of 0.3 nN.
    EXPECT_EQ(test::textOf(panel, "forceZSigma"), QStringLiteral("± 1.32"));
    EXPECT_TRUE(panel.details(&labelOf(panel, "forceZ"))
                    .startsWith(QStringLiteral("Fz: 12.3 nN ± 0.3 (noise) ± 1.3 (k)\n")))
        << panel.details(&labelOf(panel, "forceZ")).toStdString();
    EXPECT_TRUE(panel.details(&labelOf(panel, "forceMagnitude"))
                    .startsWith(QStringLiteral("|F|: 12.6 nN ± 0.3 (noise) ± 1.3 (k)\n")));
    EXPECT_EQ(panel.details(&labelOf(panel, "tipX")), QString()) << "it has no deviation";
    const ShownNumbers numbers = panel.numbers(test::snapshotOf(sample));
    EXPECT_NEAR(numbers.at(2).modelSigma.value_or(0.0), 12.3e-9 * std::hypot(0.1, 0.03), 1e-15);
    panel.clear();
    EXPECT_EQ(panel.details(&labelOf(panel, "forceZ")), QString());
}

TEST(ForcePanel, SaysWhatIsOpenInTheIndentation) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    ForcePanel panel;
    panel.begin(scene);
    TickSample sample = indented();
    const BaseMotion tip{.position = Vector3(64.0_nm, 64.0_nm, -0.5_nm)};
    sample.output.model = heldTip(scene.believedSurface(), scene.belief, tip, {});
    panel.show(test::snapshotOf(sample));
    const QString text = panel.details(&labelOf(panel, "distance"));
    for (const char* part :
         {"indentation: ", "contact radius: ", "contact stiffness: ", "modulus"}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << " in " << text.toStdString();
    }
    const TipState& pressed = sample.output.model;
    const LandmarkBudgets budgets = budgetsAt(scene, pressed, pressed.normalForce);
    const Budget radius =
        budgetOf(budgets, Landmark::ContactRadius).of(pressed.contact.contactRadius, 0.0);
    EXPECT_GT(radius.model(), 0.01 * radius.value);
    EXPECT_TRUE(text.contains(namedBudget(QStringLiteral("contact radius"), radius, "m")))
        << "by its own landmark: " << text.toStdString();
}

TEST(ForcePanel, NoiseFarFromTheSampleReadsAsZero) {
    ForcePanel panel;
    TickSample sample = test::tickWithForce(0.0, Vector3(1.23e-16, -4.5e-17, 1.2e-13));
    panel.show(test::snapshotOf(sample));
    EXPECT_EQ(test::textOf(panel, "forceX"), QStringLiteral("0 pN"));
    EXPECT_EQ(test::textOf(panel, "forceY"), QStringLiteral("0 pN"));
    EXPECT_EQ(test::textOf(panel, "forceZ"), QStringLiteral("0.12 pN"));
    EXPECT_EQ(test::textOf(panel, "forceXSigma"), QStringLiteral("± 0"));
}

TEST(ForcePanel, AStandardDeviationBelowTheDigitsIsNotNone) {
    ForcePanel panel;
    TickSample sample = test::tickWithForce(0.0, Vector3(0.0, 0.0, -1.2e-9));
    sample.output.estimate.covariance = Vector3(1e-24, 0.0, 1e-20).asDiagonal();
    panel.show(test::snapshotOf(sample));
    EXPECT_EQ(test::textOf(panel, "forceXSigma"), QStringLiteral("< 0.01"));
    EXPECT_EQ(test::textOf(panel, "forceYSigma"), QStringLiteral("± 0"));
    EXPECT_EQ(test::textOf(panel, "forceZSigma"), QStringLiteral("± 0.10"));
}

TEST(ForcePanel, NothingMovesWhenTheNumbersChange) {
    ForcePanel panel;
    panel.resize(370, 270);
    panel.show(test::snapshotOf(indented()));
    const auto* force = panel.findChild<QLabel*>(QStringLiteral("forceX"));
    const auto* gap = panel.findChild<QLabel*>(QStringLiteral("distance"));
    ASSERT_NE(force, nullptr);
    const QSize size = force->size();
    const QSize hint = panel.minimumSizeHint();
    TickSample other = indented();
    other.output.estimate.force = Vector3(-654.32e-9, -765.43e-9, -888.88e-9);
    other.output.model.contact.indentation = 333.3e-9;
    panel.show(test::snapshotOf(other));
    EXPECT_EQ(force->size(), size);
    EXPECT_EQ(force->minimumSize(), force->maximumSize()) << "a new number lays out nothing anew";
    EXPECT_EQ(panel.minimumSizeHint(), hint);
    for (const QLabel* label : {force, gap}) {
        EXPECT_LE(label->fontMetrics().horizontalAdvance(label->text()), label->width())
            << label->text().toStdString() << " is cut off";
    }
}

TEST(ForcePanel, NothingIsCutOffInTheColumnOfTheWindow) {
    ForcePanel panel;
    panel.resize(372, 270);
    TickSample sample = test::tickWithForce(1.0, Vector3(0.0, 0.0, -888.88e-12));
    sample.output.estimate.covariance.diagonal().setConstant(888.88e-12 * 888.88e-12);
    sample.output.tip = Vector3(-88.8888e-6, -88.8888e-6, 888.88e-9);
    sample.output.model.contact.indentation = 888.88e-9;
    sample.output.model.contact.contactRadius = 888.88e-9;
    panel.show(test::snapshotOf(sample));
    panel.grab();  // lays out
    EXPECT_EQ(test::textOf(panel, "forceZSigma"), QStringLiteral("± 889"));
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        if (label->textFormat() != Qt::PlainText) {
            continue;  // a legend: its source is longer than what is read
        }
        EXPECT_LE(label->fontMetrics().horizontalAdvance(label->text()), label->width())
            << label->text().toStdString() << " is cut off";
        EXPECT_LE(label->mapTo(&panel, label->rect().topRight()).x(), 372)
            << label->text().toStdString() << " leaves the panel";
    }
}

TEST(ForcePanel, PlacesOnLargeScansFitToo) {
    ForcePanel panel;
    TickSample sample = indented();
    for (const double x : {123.4567e-6, -99.99876e-6, 87.6543e-6}) {
        sample.output.tip.x() = x;
        panel.show(test::snapshotOf(sample));
        const auto* label = panel.findChild<QLabel*>(QStringLiteral("tipX"));
        EXPECT_LE(label->fontMetrics().horizontalAdvance(label->text()), label->width())
            << label->text().toStdString() << " is cut off";
    }
}

TEST(ForcePanel, FitsTheColumnOfASmallWindow) {
    const ForcePanel panel;
    EXPECT_LE(panel.minimumSizeHint().width(), 360);
    EXPECT_LE(panel.minimumSizeHint().height(), 270);
}

TEST(ForcePanel, ShowsADashForWhatIsNotANumber) {
    ForcePanel panel;
    TickSample sample = indented();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    sample.output.estimate.force = Vector3(nan, 1e-9, INFINITY);
    sample.output.estimate.covariance.setConstant(nan);
    sample.output.tip.setConstant(nan);
    sample.output.model.contact.indentation = nan;
    panel.take(sample);
    panel.show(test::snapshotOf(sample));
    EXPECT_FALSE(test::showsNan(panel));
    EXPECT_TRUE(test::textOf(panel, "forceX").startsWith(QStringLiteral("–")));
    EXPECT_TRUE(plotOf(panel, "forcePlot").history(0).isEmpty());
    EXPECT_FALSE(plotOf(panel, "forcePlot").history(1).isEmpty());
}

TEST(ForcePanel, ClearForgetsNumbersAndCurves) {
    ForcePanel panel;
    panel.take(indented());
    panel.show(test::snapshotOf(indented()));
    panel.clear();
    EXPECT_EQ(test::textOf(panel, "forceZ"), QStringLiteral("–"));
    EXPECT_EQ(test::textOf(panel, "forceZSigma"), QString());
    EXPECT_EQ(test::textOf(panel, "distance"), QStringLiteral("–"));
    EXPECT_TRUE(plotOf(panel, "forcePlot").history(2).isEmpty());
    EXPECT_TRUE(plotOf(panel, "heightPlot").history(0).isEmpty());
}

TEST(ForcePanel, CurvesShowARunFromContactToPullOff) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    SimulatedAfm afm(scene.surface, truthOf(scene));
    ForcePanel panel;
    double strongest = 0.0;
    double weakest = 0.0;
    double lowest = INFINITY;
    TickSample last;
    const DevicePath path = slidePath(scene, {.duration = 9.0});
    runVirtually(scene, path, afm, 9000, [&](const TickSample& sample) {
        panel.take(sample);
        strongest = std::max(strongest, sample.output.estimate.force.z());
        weakest = std::min(weakest, sample.output.estimate.force.z());
        lowest = std::min(lowest, sample.output.tip.z());
        last = sample;
    });
    panel.show(test::snapshotOf(last));
    EXPECT_GT(strongest, 10.0_nN);
    EXPECT_LT(weakest, -1.0_nN) << "adhesion";
    EXPECT_EQ(plotOf(panel, "forcePlot").history(2).extent().high, strongest) << "every peak stays";
    EXPECT_EQ(plotOf(panel, "forcePlot").history(2).extent().low, weakest);
    EXPECT_EQ(plotOf(panel, "heightPlot").history(0).extent().low, lowest);
    EXPECT_GE(plotOf(panel, "forcePlot").valueRange().high, strongest);
    EXPECT_LE(plotOf(panel, "forcePlot").valueRange().low, weakest);
}

}  // namespace
}  // namespace asperity
