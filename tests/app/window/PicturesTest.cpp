#include "app/window/live/LivePanels.h"
#include "core/Units.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/app/window/SettledWindow.h"
#include "tests/support/PictureBaseline.h"
#include "tests/support/TestScenes.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/RunPanel.h"
#include "ui/view/SecondView.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QApplication>
#include <QLabel>
#include <QPixmap>
#include <QStatusBar>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

/// Gray levels; what shows more is a panel that is missing, or has another position or color.
constexpr double kTolerance = 8.0;

/// The window with a fixed scene and the deepest tick of a fixed run; no loop is running.
class Pictures : public ::testing::Test {
protected:
    void SetUp() override {
        theme::choose(ThemeChoice::Light);
        window.addSidePage(new QLabel, QStringLiteral("Scene"));
        window.addSidePage(new QLabel, QStringLiteral("Haptics"));
        panels.showScene(&scene, QStringLiteral("hills"));
        window.resize(1280, 800);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        takeRun();
        settle(panels);
    }

    void TearDown() override { theme::choose(ThemeChoice::Light); }

    /// Down to the sample, along it and up again, on a virtual clock.
    void takeRun() {
        RunEventRecorder recorder;
        SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
        PathPlan plan;
        plan.position = Vector2(50.0_nm, 60.0_nm);
        const long ticks = std::lround(plan.duration / scene.timeStep()) + 1;
        runVirtually(scene, slidePath(scene, plan), afm, ticks, [&](const TickSample& sample) {
            recorder.take(sample);
            for (RunPanel* const panel : panels.panels()) {
                panel->take(sample);
            }
        });
        ASSERT_TRUE(recorder.events().deepest.has_value());
        snapshot.sample = *recorder.events().deepest;
        snapshot.statistics.ticks = ticks;
    }

    QImage picture() {
        panels.view().showSnapshot(snapshot);
        panels.second().showSnapshot(snapshot);
        for (RunPanel* const panel : panels.panels()) {
            panel->show(snapshot);
        }
        window.statusBar()->clearMessage();
        settle(panels);
        return window.grab().toImage();
    }

    Scene scene = buildScene(plainScene(), hillyMap());
    MainWindow window;
    LivePanels panels{window};
    Snapshot snapshot;
};

TEST_F(Pictures, TheWindowLooksAsItShould) {
    EXPECT_EQ(compareWithBaseline(picture(), QStringLiteral("window_light"), kTolerance), "");
}

TEST_F(Pictures, TheDarkWindowLooksAsItShould) {
    theme::choose(ThemeChoice::Dark);
    EXPECT_EQ(compareWithBaseline(picture(), QStringLiteral("window_dark"), kTolerance), "");
}

TEST_F(Pictures, APanelThatIsMissingShows) {
    const QImage before = reduced(picture());
    for (Card* card : window.cards()) {
        card->hide();
        EXPECT_GT(difference(reduced(picture()), before).worst, kTolerance)
            << card->title().toStdString();
        card->show();
    }
    EXPECT_LT(difference(reduced(picture()), before).worst, kTolerance) << "all are back";
}

TEST_F(Pictures, ColorsThatAreSwappedShow) {
    const QImage before = picture();
    EXPECT_GT(difference(reduced(before.rgbSwapped()), reduced(before)).worst, kTolerance);
}

TEST_F(Pictures, HintingOfLettersDoesNotShow) {
    const QImage before = picture();
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        QFont own = widget->font();
        own.setHintingPreference(QFont::PreferNoHinting);
        own.setStyleStrategy(QFont::NoAntialias);
        widget->setFont(own);
    }
    const QImage after = picture();
    EXPECT_NE(before, after) << "other letters are drawn";
    EXPECT_LT(difference(reduced(after), reduced(before)).worst, kTolerance);
}

}  // namespace
}  // namespace asperity::test
