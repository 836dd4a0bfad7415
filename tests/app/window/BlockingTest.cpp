#include "app/window/live/OverviewPanel.h"
#include "app/window/scene/OpenControl.h"
#include "app/window/scene/OpenDialog.h"
#include "app/window/scene/PreviewPane.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/EventLoopWatchdog.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <iostream>

namespace asperity::test {
namespace {

constexpr double kTooLong = 0.1;  // to be seen by the watchdog [s]

void stayBusy(double seconds) {
    const double end = processorSeconds() + seconds;
    while (processorSeconds() < end) {
    }
}

double blockedIn(const EventLoopWatchdog& watchdog, const std::string& step) {
    for (const BlockedStretch& stretch : watchdog.longest()) {
        if (stretch.step == step) {
            return std::max(stretch.own, stretch.processor);
        }
    }
    return 0.0;
}

TEST(EventLoopWatchdogAlone, FindsACallThatIsBusyOrWaitsTooLong) {
    EventLoopWatchdog watchdog;
    watchdog.enter("at rest");
    QTest::qWait(100);
    watchdog.enter("busy");
    stayBusy(0.15);
    QTest::qWait(100);
    watchdog.enter("waits");
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    QTest::qWait(100);
    EXPECT_LT(blockedIn(watchdog, "at rest"), kTooLong) << tableOf(watchdog.longest());
    EXPECT_GT(blockedIn(watchdog, "busy"), kTooLong) << tableOf(watchdog.longest());
    EXPECT_GT(blockedIn(watchdog, "waits"), kTooLong) << tableOf(watchdog.longest());
    EXPECT_LT(blockedIn(watchdog, "busy"), 0.3) << tableOf(watchdog.longest());
}

/// Other threads that want the processors make the loop late, but that is not its own doing.
TEST(EventLoopWatchdogAlone, TakesNoAccountOfLoad) {
    std::atomic<bool> ends = false;
    std::vector<std::thread> load;
    for (unsigned int i = 0; i < 8 * std::thread::hardware_concurrency(); ++i) {
        load.emplace_back([&ends] {
            while (!ends) {
            }
        });
    }
    EventLoopWatchdog watchdog;
    watchdog.enter("short calls");
    for (int call = 0; call < 20; ++call) {
        stayBusy(0.02);
        QTest::qWait(1);
    }
    QTest::qWait(100);
    ends = true;
    for (std::thread& thread : load) {
        thread.join();
    }
    EXPECT_LT(blockedIn(watchdog, "short calls"), kTooLong) << tableOf(watchdog.longest());
}

/// The window with a watchdog on its event loop.
class BlockingWindow : public Window {
protected:
    /// A step of a user, and what the window does about it for a while.
    void step(const std::string& name, const std::function<void()>& act, int milliseconds = 400) {
        watchdog_->enter(name);
        act();
        live(milliseconds);
        live(20);
    }
    /// What a user does with a scan of so many pixels along each side.
    void walk(int side) {
        const std::filesystem::path scan = levelScan(folder, side);
        watchdog_.emplace();  // not before: this thread made the file
        step("open", [&] { open(scan); });
        workOnScene();
        workOnWindow(scan);
        measure();
        step("close", [this] { stage.runs().end(); });
    }
    void workOnScene() {
        step("material", [this] {
            choose("material", "polystyrene");
            EXPECT_TRUE(changeEnds());
        });
        step("level", [this] {
            SceneDescription next = *stage.edits().wanted();
            next.sample.leveling.push_back(LevelingStep::Zero);
            stage.edits().change(QStringLiteral("Leveling"), next);
            EXPECT_TRUE(changeEnds());
        });
        step("undo", [this] {
            window.menus().entry("undo").trigger();
            EXPECT_TRUE(changeEnds());
        });
    }
    void workOnWindow(const std::filesystem::path& scan) {
        step("resize", [this] { window.resize(1280, 800); });
        step("resize back", [this] { window.resize(1600, 1000); });
        step("dark", [] { theme::choose(ThemeChoice::Dark); });
        step("light", [] { theme::choose(ThemeChoice::Light); });
        step("second view", [this] { window.menus().entry("secondView").trigger(); });
        step("open dialog", [this] { stage.get<OpenControl>().ask(); });
        step("preview", [&] {
            stage.get<OpenControl>().dialog()->choose(QString::fromStdString(scan.string()));
            EXPECT_TRUE(eventually(
                [this] { return stage.get<OpenControl>().dialog()->preview().isComplete(); },
                60000));
        });
        step("close dialog", [this] { stage.get<OpenControl>().dialog()->reject(); });
        step("fidelity", [this] { window.menus().entry("fidelity").trigger(); });
        step("copy the window", [this] { window.menus().entry("copyWindow").trigger(); });
    }
    void measure() {
        step("profile page", [this] { window.menus().entry("profile").trigger(); });
        step("profile line", [this] {
            OverviewMap& map = panels.overview().map();
            const QSizeF scan = map.scanSize();
            dragMouse(map, map.toPixel({0.1 * scan.width(), 0.3 * scan.height()}),
                      map.toPixel({0.9 * scan.width(), 0.7 * scan.height()}));
            EXPECT_TRUE(eventually([this] { return text("profileLength") != "–"; }, 60000));
        });
        step(
            "roughness page", [this] { window.menus().entry("roughness").trigger(); }, 1500);
        step("smoothed heights", [this] { child<QAbstractButton>("measureSmoothed")->click(); });
        step("leveled heights", [this] { child<QAbstractButton>("measureSmoothed")->click(); });
        step("record", [this] { window.menus().entry("record").trigger(); });
        const auto click = [this](const char* button) {
            QTest::mouseClick(child<QAbstractButton>(button), Qt::LeftButton);
        };
        step(
            "engage", [&] { click("engage"); }, 3000);
        step(
            "withdraw", [&] { click("withdraw"); }, 1000);
        step("end recording", [this] { window.menus().entry("record").trigger(); });
        step("zoom", [this] { window.menus().entry("zoomOut").trigger(); });
    }
    void open(const std::filesystem::path& scan) {
        QSignalSpy shown(&stage.runs(), &RunControl::begun);
        stage.get<SceneControl>().open(scan);
        ASSERT_TRUE(eventually([&] { return shown.count() == 1; }, 60000));
    }
    void expectNoneTooLong() {
        const std::vector<BlockedStretch> longest = watchdog_->longest();
        std::cout << tableOf(longest);
        const double limit = watchdog_->longestBlock();
        for (const BlockedStretch& stretch : longest) {
            EXPECT_LT(stretch.processor, limit) << stretch.step;
            // Waiting for a thread or a disk; part of it may be another program's load.
            EXPECT_LT(stretch.own, kLongestWait) << stretch.step;
        }
    }

    void SetUp() override {
        Window::SetUp();
        openFlatScene();  // the driver compiles its shaders
    }

    std::optional<EventLoopWatchdog> watchdog_;
};

class BlockingWindowAlone : public BlockingWindow {};

TEST_F(BlockingWindowAlone, NoStepBlocksTheLoop) {
    walk(512);
    expectNoneTooLong();
}

class BlockingWindowLong : public BlockingWindow {};

TEST_F(BlockingWindowLong, NoStepBlocksTheLoopOnALargeScan) {
    walk(4096);
    expectNoneTooLong();
}

}  // namespace
}  // namespace asperity::test
