#include "app/window/live/CantileverPanel.h"

#include "core/scene/SceneDescription.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/Theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

const Cantilever kLever(defaultScene().probe);

/// A tick whose signals are those that the force causes.
TickSample tickOf(double time, const Vector3& force) {
    TickSample sample = test::tickWithForce(time, force);
    sample.input.measurement.signals = leverSignals(kLever, force);
    return sample;
}

/// Mean row of the drawn beam's free end, from the top [px].
double beamEndRow(const QImage& image) {
    const QColor beam(theme::colors().tip);
    double rows = 0.0;
    int count = 0;
    const int from = static_cast<int>(0.45 * image.width());
    for (int x = from; x < from + 40; ++x) {
        for (int y = 16; y < image.height(); ++y) {
            if (image.pixelColor(x, y) == beam) {
                rows += y;
                ++count;
            }
        }
    }
    return count > 0 ? rows / count : -1.0;
}

TEST(CantileverPanel, ShowsTheMeasuredAnglesAndTheDeflection) {
    CantileverPanel panel;
    panel.setCantilever(kLever);
    TickSample sample = tickOf(1.0, Vector3(0.0, 0.0, 14e-9));
    sample.input.measurement.signals = {.bending = 12.3e-6, .torsion = -0.45e-6};
    panel.show(test::snapshotOf(sample));
    EXPECT_EQ(test::textOf(panel, "bending"), QStringLiteral("12.3 µrad"));
    EXPECT_EQ(test::textOf(panel, "torsion"), QStringLiteral("-0.45 µrad"));
    EXPECT_EQ(test::textOf(panel, "deflection"), QStringLiteral("1.00 nm")) << "14 nN at 14 N/m";
    EXPECT_EQ(test::textOf(panel, "lateral"), QStringLiteral("0 nm"));
}

TEST(CantileverPanel, WithoutALeverItShowsTheSignalsAlone) {
    CantileverPanel panel;
    TickSample sample = tickOf(1.0, Vector3(0.0, 0.0, 14e-9));
    panel.take(sample);
    panel.show(test::snapshotOf(sample));
    EXPECT_EQ(test::textOf(panel, "bending"), QStringLiteral("10.0 µrad"));
    EXPECT_EQ(test::textOf(panel, "deflection"), QStringLiteral("–"));
    panel.resize(370, 220);
    EXPECT_FALSE(panel.grab().isNull());
}

TEST(CantileverPanel, KeepsEveryPeakOfTheSignals) {
    CantileverPanel panel;
    panel.setCantilever(kLever);
    for (int i = 0; i < 5000; ++i) {
        panel.take(tickOf(1e-3 * i, Vector3(0.0, 0.0, i == 2345 ? 50e-9 : 1e-9)));
    }
    EXPECT_EQ(panel.plot().history(0).extent().high,
              leverSignals(kLever, Vector3(0.0, 0.0, 50e-9)).bending);
    panel.clear();
    EXPECT_TRUE(panel.plot().history(0).isEmpty());
    EXPECT_EQ(test::textOf(panel, "bending"), QStringLiteral("–"));
}

TEST(CantileverPanel, ExaggeratesWeakForcesMoreThanStrongOnes) {
    CantileverPanel panel;
    panel.setCantilever(kLever);
    panel.resize(370, 220);
    const auto factorFor = [&panel](double force) {
        panel.clear();
        const TickSample sample = tickOf(0.0, Vector3(0.0, force, force));
        panel.take(sample);
        panel.show(test::snapshotOf(sample));
        return std::make_pair(panel.sketch().bendingFactor(), panel.sketch().torsionFactor());
    };
    const auto weak = factorFor(10e-9);
    const auto strong = factorFor(1000e-9);
    EXPECT_GT(weak.first, 20.0 * strong.first);
    EXPECT_GT(weak.second, 20.0 * strong.second);
    EXPECT_GE(strong.first, 1.0);
}

TEST(CantileverPanel, NeverShowsNan) {
    CantileverPanel panel;
    panel.setCantilever(kLever);
    TickSample sample = tickOf(0.0, Vector3(NAN, NAN, NAN));
    panel.take(sample);
    panel.show(test::snapshotOf(sample));
    panel.resize(370, 220);
    EXPECT_FALSE(panel.grab().isNull());
    EXPECT_FALSE(test::showsNan(panel));
}

TEST(CantileverSketch, TheBeamBendsUpWhenTheSamplePushesAndDownWhenItPulls) {
    CantileverSketch sketch;
    sketch.resize(360, 90);
    sketch.setCantilever(kLever);
    const double rest = beamEndRow(sketch.grab().toImage());
    const auto rowUnder = [&sketch](double force) {
        const Vector3 vector(0.0, 0.0, force);
        sketch.showForce(vector, cantileverShape(kLever, vector, kLever.geometry().length));
        return beamEndRow(sketch.grab().toImage());
    };
    EXPECT_LT(rowUnder(20e-9), rest - 2.0);
    EXPECT_GT(rowUnder(-20e-9), rest + 2.0);
}

TEST(CantileverSketch, TheForceIsDrawnInRedAndOnlyWhenThereIsOne) {
    CantileverSketch sketch;
    sketch.resize(360, 90);
    sketch.setCantilever(kLever);
    EXPECT_EQ(test::pixelsLike(sketch.grab().toImage(), theme::colors().force), 0);
    const Vector3 force(0.0, 0.0, 20e-9);
    sketch.showForce(force, cantileverShape(kLever, force, kLever.geometry().length));
    EXPECT_GT(test::pixelsLike(sketch.grab().toImage(), theme::colors().force), 20);
}

/// Without its head an arrow does not say whether the sample pulls or pushes.
TEST(CantileverSketch, TheArrowOfAPullKeepsItsHeadOnALowCard) {
    CantileverSketch sketch;
    sketch.setCantilever(kLever);
    sketch.resize(400, 64);
    const auto widest = [&](double force) {
        sketch.showForce({0.0, 0.0, force},
                         cantileverShape(kLever, {0.0, 0.0, force}, kLever.geometry().length));
        const QImage image = sketch.grab().toImage();
        const QColor red(theme::colors().force);
        int most = 0;
        for (int y = 0; y < image.height(); ++y) {
            int width = 0;
            for (int x = 0; x < image.width(); ++x) {
                width += image.pixelColor(x, y) == red ? 1 : 0;
            }
            most = std::max(most, width);
        }
        return most;
    };
    EXPECT_GE(widest(-14e-9), 5) << "of the head";
    EXPECT_NEAR(widest(-14e-9), widest(14e-9), 1);
}

}  // namespace
}  // namespace asperity
