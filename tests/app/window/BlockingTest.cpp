#include "tests/app/window/WindowFixture.h"
#include "tests/support/EventLoopWatchdog.h"
#include "ui/panels/EngageBar.h"
#include "ui/view/ZoomView.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <iostream>

namespace asperity::test {
namespace {

constexpr double kLongest = 0.1;  // without an answer [s]

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

TEST(EventLoopWatchdog, FindsACallThatIsBusyOrWaitsTooLong) {
    EventLoopWatchdog watchdog;
    watchdog.enter("at rest");
    QTest::qWait(100);
    watchdog.enter("busy");
    stayBusy(0.15);
    QTest::qWait(100);
    watchdog.enter("waits");
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    QTest::qWait(100);
    EXPECT_LT(blockedIn(watchdog, "at rest"), kLongest) << tableOf(watchdog.longest());
    EXPECT_GT(blockedIn(watchdog, "busy"), kLongest) << tableOf(watchdog.longest());
    EXPECT_LT(blockedIn(watchdog, "busy"), 0.3) << tableOf(watchdog.longest());
}

/// Other threads that want the processors make the loop late, but that is not its own doing.
TEST(EventLoopWatchdog, TakesNoAccountOfLoad) {
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
    EXPECT_LT(blockedIn(watchdog, "short calls"), kLongest) << tableOf(watchdog.longest());
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
    void open(const std::filesystem::path& scan) {
        QSignalSpy shown(&session.runs(), &RunControl::begun);
        session.scenes().open(scan);
        ASSERT_TRUE(eventually([&] { return shown.count() == 1; }, 60000));
    }
    void expectNoneTooLong() {
        const std::vector<BlockedStretch> longest = watchdog_->longest();
        std::cout << tableOf(longest);
        for (const BlockedStretch& stretch : longest) {
            EXPECT_LT(std::max(stretch.own, stretch.processor), kLongest) << stretch.step;
        }
    }

    void SetUp() override {
        Window::SetUp();
        openFlatScene();  // the driver compiles its shaders
        watchdog_.emplace();
    }

    std::optional<EventLoopWatchdog> watchdog_;
};

TEST_F(BlockingWindow, NoStepBlocksTheLoop) {
    step("open 512² pixels", [this] { open(levelScan(folder, 512)); });
    step("material", [this] { choose("material", "polystyrene"); });
    step(
        "record", [this] { window.menus().record->trigger(); }, 1000);
    step("end recording", [this] { window.menus().record->trigger(); });
    step("resize", [this] { window.resize(1280, 800); });
    step("resize back", [this] { window.resize(1600, 1000); });
    step(
        "engage", [this] { QTest::mouseClick(child<QPushButton>("engage"), Qt::LeftButton); },
        3000);
    step(
        "withdraw", [this] { QTest::mouseClick(child<QPushButton>("withdraw"), Qt::LeftButton); },
        1000);
    step("zoom", [this] { window.menus().zoomOut->trigger(); });
    step("copy the window", [this] { window.menus().copyWindow->trigger(); });
    step("fidelity", [this] { window.menus().fidelity->trigger(); });
    step("close", [this] { session.runs().end(); });
    expectNoneTooLong();
}

}  // namespace
}  // namespace asperity::test
