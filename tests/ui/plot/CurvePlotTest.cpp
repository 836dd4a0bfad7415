#include "ui/plot/CurvePlot.h"

#include "tests/ui/widgets/MouseEvents.h"
#include "tests/ui/widgets/PanelSamples.h"

#include <QCoreApplication>
#include <QLabel>
#include <QToolButton>

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

const QColor kFirst(0, 114, 178);
const QColor kSecond(213, 94, 0);

CurvePlotSetup setupOf(ZeroLine zero) {
    return {.title = QStringLiteral("Force"),
            .unit = QStringLiteral("N"),
            .smallest = 1e-12,
            .curves = {{QStringLiteral("Fx"), &ThemeColors::blue},
                       {QStringLiteral("Fz"), &ThemeColors::orange}},
            .zero = zero};
}

/// How many pixels have this hue: the curves' edges are blended with the paper.
int pixelsOfHue(const QImage& image, const QColor& color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const bool sameHue = std::abs(pixel.hsvHue() - color.hsvHue()) < 12;
            count += sameHue && pixel.hsvSaturation() > 90 ? 1 : 0;
        }
    }
    return count;
}

QImage picture(CurvePlot& plot) {
    plot.resize(400, 160);
    plot.refresh();
    return plot.grab().toImage();
}

QString titleOf(const CurvePlot& plot) { return plot.findChild<QLabel*>()->text(); }

/// Whether the plot shows its values in this unit.
bool isIn(const CurvePlot& plot, const char* unit) {
    return titleOf(plot).contains(QStringLiteral("[%1]").arg(QString::fromUtf8(unit)));
}

TEST(CurvePlot, NamesItsUnitWithTheFittingPrefix) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    plot.take(0.0, {1e-9, 20e-9});
    plot.refresh();
    EXPECT_TRUE(isIn(plot, "nN")) << titleOf(plot).toStdString();
    EXPECT_TRUE(titleOf(plot).contains(QStringLiteral("Fz")));
    plot.take(0.1, {1e-9, 3e-6});
    plot.refresh();
    EXPECT_TRUE(isIn(plot, "µN")) << titleOf(plot).toStdString();
}

TEST(CurvePlot, RangeHoldsAPeakOfOneTickUntilItIsTenSecondsOld) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    for (int i = 0; i < 20000; ++i) {
        plot.take(1e-3 * i, {0.0, i == 5000 ? -40e-9 : 1e-9});
        if (i == 14000) {
            plot.refresh();
            EXPECT_LE(plot.valueRange().low, -40e-9);
        }
    }
    plot.refresh();
    EXPECT_GT(plot.valueRange().low, -2e-9);
    EXPECT_GE(plot.valueRange().high, 1e-9);
    EXPECT_LE(plot.valueRange().low, 0.0) << "zero stays in sight";
}

TEST(CurvePlot, RangeDoesNotFlickerWithNoise) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    int changes = 0;
    AxisRange last{};
    for (int i = 0; i < 3000; ++i) {
        plot.take(0.01 * i, {1e-9 * std::sin(0.31 * i), 1e-9 + 0.2e-9 * std::sin(12.9 * i)});
        plot.refresh();
        changes += last.low == plot.valueRange().low && last.high == plot.valueRange().high ? 0 : 1;
        last = plot.valueRange();
    }
    EXPECT_LE(changes, 6);
}

TEST(CurvePlot, FarFromZeroItShowsDifferencesInTheirOwnUnit) {
    CurvePlot plot(setupOf(ZeroLine::None));
    for (int i = 0; i < 100; ++i) {
        plot.take(0.1 * i, {7e-6 + 1e-9 * (i % 7), 7e-6});
    }
    plot.refresh();
    EXPECT_GT(plot.valueRange().low, 6.9e-6) << "zero need not be in sight";
    EXPECT_TRUE(isIn(plot, "nN")) << "not 7.000 µN";
}

TEST(CurvePlot, DrawsEachCurveInItsColor) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    const int legendFirst = pixelsOfHue(picture(plot), kFirst);
    const int legendSecond = pixelsOfHue(picture(plot), kSecond);
    for (int i = 0; i < 1000; ++i) {
        plot.take(0.01 * i, {1e-9, -1e-9});
    }
    const QImage full = picture(plot);
    EXPECT_GT(pixelsOfHue(full, kFirst), legendFirst + 200);
    EXPECT_GT(pixelsOfHue(full, kSecond), legendSecond + 200);
    plot.clear();
    EXPECT_EQ(pixelsOfHue(picture(plot), kFirst), legendFirst);
}

TEST(CurvePlot, DrawsNothingAcrossTimeThatWasLeaptOver) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    const auto takeFor = [&plot](double begin, int ticks) {
        for (int tick = 0; tick < ticks; ++tick) {
            plot.take(begin + 0.01 * tick, {1e-9, -1e-9});
        }
    };
    takeFor(0.0, 1000);
    const int whole = pixelsOfHue(picture(plot), kFirst);
    plot.clear();
    takeFor(0.0, 250);
    takeFor(7.5, 250);
    const int half = pixelsOfHue(picture(plot), kFirst);
    EXPECT_LT(half, 0.75 * whole);
    EXPECT_GT(half, 0.3 * whole);
}

/// A plot with a ramp of ten seconds.
struct CurvePlotByMouse : ::testing::Test {
    void SetUp() override {
        plot.resize(400, 160);
        plot.grab();  // lays out
        ramp(0);
    }
    void ramp(int from) {
        for (int i = from; i < from + 10000; ++i) {
            plot.take(1e-3 * i, {1e-12 * i, -1e-9});
        }
        plot.refresh();
    }
    /// Where a time before now is on the canvas, while nothing is zoomed.
    [[nodiscard]] QPointF at(double time) {
        return {(1.0 + time / CurvePlot::kSpan) * plot.canvas().width(), 40.0};
    }

    CurvePlot plot{setupOf(ZeroLine::Shown)};
};

TEST_F(CurvePlotByMouse, TheCursorReadsTimeAndAllCurves) {
    EXPECT_TRUE(plot.reading().isEmpty());
    test::sendMouse(plot.canvas(), QEvent::MouseMove, at(-4.0), Qt::NoButton);
    const QString reading = plot.reading();
    EXPECT_TRUE(reading.startsWith(QStringLiteral("-4.0"))) << reading.toStdString();
    EXPECT_TRUE(reading.contains(QStringLiteral("Fx 6.0"))) << reading.toStdString();
    EXPECT_TRUE(reading.contains(QStringLiteral("Fz -1.00 nN"))) << reading.toStdString();
}

TEST_F(CurvePlotByMouse, PauseFreezesThePictureAndGoesOnWithNow) {
    const QImage before = plot.grab().toImage();
    plot.setPaused(true);
    ramp(10000);
    EXPECT_EQ(plot.grab().toImage(), before);
    EXPECT_DOUBLE_EQ(plot.history(0).newestTime(), 19.999) << "values are kept on";
    plot.setPaused(false);
    EXPECT_GE(plot.valueRange().high, 19e-9);
    EXPECT_NE(plot.grab().toImage(), before);
}

TEST_F(CurvePlotByMouse, ZoomsByDragAndBackByTheButton) {
    auto* button = plot.findChild<QToolButton*>(QStringLiteral("resetZoom"));
    EXPECT_TRUE(button->isHidden());
    test::dragMouse(plot.canvas(), at(-8.0), at(-6.0) + QPointF(0.0, 2.0));
    EXPECT_TRUE(plot.isZoomed());
    EXPECT_NEAR(plot.shownTimes().low, -8.0, 0.05);
    EXPECT_NEAR(plot.shownTimes().high, -6.0, 0.05);
    EXPECT_FALSE(button->isHidden());
    button->click();
    EXPECT_FALSE(plot.isZoomed());
    EXPECT_EQ(plot.shownTimes().low, -CurvePlot::kSpan);
}

TEST(CurvePlot, BringsItsCurvesBack) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    plot.take(0.0, {1e-9, 20e-9});
    plot.take(1.0, {2e-9, 30e-9});
    const QString before = plot.table().tabSeparated();
    const std::function<void()> bringBack = plot.keptCurves();
    plot.clear();
    plot.take(5.0, {7e-9, 8e-9});
    EXPECT_NE(plot.table().tabSeparated(), before);
    bringBack();
    EXPECT_EQ(plot.table().tabSeparated(), before);
}

TEST(CurvePlot, LeavesOutValuesThatAreNotNumbers) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    plot.take(0.0, {NAN, 1e-9});
    plot.refresh();
    EXPECT_TRUE(plot.history(0).isEmpty());
    EXPECT_FALSE(plot.history(1).isEmpty());
    EXPECT_TRUE(std::isfinite(plot.valueRange().low));
}

TEST(CurvePlot, TakesTheColorsOfAnotherThemeWhileItIsShown) {
    CurvePlot plot(setupOf(ZeroLine::Shown));
    for (int i = 0; i < 100; ++i) {
        plot.take(0.1 * i, {1e-9 * i, -1e-9 * i});
    }
    (void)picture(plot);  // from now on the ticks suit the size
    const QImage light = picture(plot);
    theme::choose(ThemeChoice::Dark);
    const QImage dark = picture(plot);
    EXPECT_GT(test::pixelsLike(dark, toQColor(kDarkPalette.paper)), 20000);
    EXPECT_EQ(test::pixelsLike(dark, toQColor(kLightPalette.paper)), 0);
    EXPECT_GT(pixelsOfHue(dark, toQColor(kDarkPalette.blue)), 60);
    EXPECT_TRUE(titleOf(plot).contains(theme::colors().blue.name()));
    theme::choose(ThemeChoice::Desktop);
    EXPECT_EQ(picture(plot), light);
}

TEST(CurvePlot, ItsCanvasDoesNotJumpWithItsNumbers) {
    CurvePlot plot(setupOf(ZeroLine::None));
    const auto canvasAt = [&plot](double value) {
        plot.clear();
        for (int i = 0; i < 100; ++i) {
            plot.take(0.1 * i, {value + 1e-12 * i, value, 0.0});
        }
        picture(plot);
        QCoreApplication::sendPostedEvents();
        return plot.canvas().geometry();
    };
    const QRect wide = canvasAt(-999.123e-9);  // many digits
    EXPECT_EQ(canvasAt(1e-9), wide);
    EXPECT_EQ(canvasAt(-999.123e-9), wide);
}

TEST(CurvePlot, ItsTitleSaysHowThePanelIsEnlarged) {
    CurvePlot plot(setupOf(ZeroLine::None));
    EXPECT_TRUE(plot.findChild<QLabel*>()->toolTip().contains(QStringLiteral("ouble click")));
}

}  // namespace
}  // namespace asperity
