#include "app/loading/SceneLoader.h"
#include "app/window/LongWork.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/Places.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WorkInBackground.h"

#include <QAction>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace asperity::test {
namespace {

class CanceledAt : public Progress {
public:
    explicit CanceledAt(double fraction) : fraction_(fraction) {}

    void report(double fraction) override { canceled_ = fraction >= fraction_; }
    [[nodiscard]] bool isCanceled() const override { return canceled_; }

private:
    double fraction_;
    bool canceled_ = false;
};

TEST(Loading, CanBeCanceledAllTheWay) {
    ScratchFolder folder;
    const std::filesystem::path scan = levelScan(folder, 1024);
    for (const double fraction : {0.0, 0.1, 0.25, 0.5, 0.75, 0.85, 0.95}) {
        CanceledAt progress(fraction);
        EXPECT_THROW((void)loadScene(scan, {}, &progress), Canceled) << fraction;
    }
    CanceledAt never(2.0);
    EXPECT_NO_THROW((void)loadScene(scan, {}, &never));
}

/// With a flat scene shown and a large scan to open.
class WindowThatLoads : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        openFlatScene();
        large_ = levelScan(folder, 3072);
    }

    bool isLoading() {
        const bool shown = child<QWidget>("loadingBar")->isVisible();
        EXPECT_EQ(window.menus().entry("cancelLoading").isEnabled(), shown);
        return shown;
    }
    /// The loader works one by one: once another scene is shown, nothing can come of one before.
    void expectTheNextToBeTheFirstShown() {
        window.setWindowTitle({});
        stage.get<SceneControl>().open(test::dataFolder() / "samples" / "steps.gsf");
        ASSERT_TRUE(eventually([this] { return shown_.count() > 0; }));
        EXPECT_EQ(shown_.count(), 1);
        EXPECT_TRUE(window.windowTitle().startsWith("steps.gsf"));
        EXPECT_FALSE(isLoading());
        EXPECT_TRUE(window.findChildren<QMessageBox*>().empty());
    }

    std::filesystem::path large_;
    QSignalSpy shown_{&stage.runs(), &RunControl::begun};
};

TEST_F(WindowThatLoads, ShowsHowFarItIsWhileTheRunGoesOn) {
    shown_.clear();
    std::vector<int> percents;
    QObject::connect(child<QProgressBar>("loadingBar"), &QProgressBar::valueChanged, &window,
                     [&](int percent) { percents.push_back(percent); });
    EXPECT_FALSE(isLoading());
    stage.get<SceneControl>().open(large_);
    EXPECT_FALSE(isLoading()) << "quick work must not flicker";
    EXPECT_TRUE(eventually([this] { return isLoading(); }));
    EXPECT_TRUE(stage.run()->loop().running());
    ASSERT_TRUE(eventually([this] { return shown_.count() == 1; }));
    EXPECT_FALSE(isLoading());
    ASSERT_GT(percents.size(), 10U);
    percents.pop_back();  // back at the beginning, for the next file
    EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end()));
}

TEST_F(WindowThatLoads, CancelLeavesTheSceneAsItWas) {
    shown_.clear();
    QSignalSpy canceled(&stage.get<SceneControl>(), &SceneControl::openCanceled);
    const LiveRun* run = stage.run();
    const QString title = window.windowTitle();
    stage.get<SceneControl>().open(large_);
    ASSERT_TRUE(eventually([this] { return isLoading(); }));
    QTest::mouseClick(child<QPushButton>("cancelLoading"), Qt::LeftButton);
    EXPECT_EQ(canceled.count(), 1);
    EXPECT_FALSE(isLoading());
    ASSERT_TRUE(runsFor(0.3));
    EXPECT_EQ(stage.run(), run);
    EXPECT_EQ(window.windowTitle(), title);
    EXPECT_TRUE(stage.run()->settings().forcesOn);
    EXPECT_TRUE(stage.run()->loop().running());
    expectTheNextToBeTheFirstShown();
}

TEST_F(WindowThatLoads, CancelEndsWhatTheLineNamesAndTheLineGoesBackToTheOther) {
    LongWork<int> film(loadingLine(window),
                       {.finished = [](int) {}, .failed = [](const std::exception_ptr&) {}});
    film.start(QStringLiteral("Writing film …"), [](Progress& progress) -> int {
        for (;;) {  // until it is canceled
            reportTo(&progress, 0.5);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    });
    ASSERT_TRUE(eventually([this] { return isLoading(); }));
    stage.get<SceneControl>().open(large_);
    ASSERT_TRUE(eventually([this] { return text("loadingWords").starts_with("Loading"); }));
    QTest::mouseClick(child<QPushButton>("cancelLoading"), Qt::LeftButton);
    EXPECT_TRUE(isLoading());
    EXPECT_EQ(text("loadingWords"), "Writing film …");
    EXPECT_TRUE(film.isAwaited());
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_FALSE(film.isAwaited());
    EXPECT_FALSE(isLoading());
}

TEST_F(WindowThatLoads, TheMenuCancels) {
    shown_.clear();
    stage.get<SceneControl>().open(large_);
    ASSERT_TRUE(eventually([this] { return isLoading(); }));
    window.menus().entry("cancelLoading").trigger();
    EXPECT_FALSE(isLoading());
    expectTheNextToBeTheFirstShown();
}

TEST_F(WindowThatLoads, EscCancelsAndLeavesTheForcesWhereNoDeviceHasAny) {
    shown_.clear();
    stage.get<SceneControl>().open(large_);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_FALSE(isLoading());
    EXPECT_TRUE(stage.run()->settings().forcesOn);
    expectTheNextToBeTheFirstShown();
}

TEST_F(WindowThatLoads, AnotherFileTakesThePlaceOfTheOneBefore) {
    shown_.clear();
    stage.get<SceneControl>().open(large_);
    expectTheNextToBeTheFirstShown();
}

// A loader that outlives its session would be found by the sanitizers.
TEST_F(WindowThatLoads, MayBeClosedMeanwhile) {
    stage.get<SceneControl>().open(large_);
    ASSERT_TRUE(eventually([this] { return isLoading(); }));
}

}  // namespace
}  // namespace asperity::test
