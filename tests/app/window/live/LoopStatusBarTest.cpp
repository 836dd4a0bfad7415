#include "app/window/live/LoopStatusBar.h"

#include "tests/ui/widgets/PanelSamples.h"

#include <QLabel>

#include <gtest/gtest.h>

namespace asperity {
namespace {

LoopStatistics statistics(SchedulingPolicy policy) {
    return {.tickTime = {.median = 12.3e-6, .p99 = 25.1e-6, .largest = 1e-3},
            .lateness = {.median = 1e-6, .p99 = 68e-6, .largest = 2e-3},
            .ticks = 1234567,
            .overruns = 12,
            .lostSamples = 3,
            .policy = policy};
}

TEST(LoopStatusBar, ShowsHowTheLoopKeepsItsTime) {
    LoopStatusBar bar;
    bar.setRateAsked(4000.0);
    bar.setFramesPerSecond(29.74);
    bar.show({.statistics = statistics(SchedulingPolicy::Realtime)});
    EXPECT_EQ(test::textOf(bar, "rate"), QStringLiteral("4,000 Hz"));
    EXPECT_EQ(test::textOf(bar, "tickTime"), QStringLiteral("12.3 µs / 25.1 µs"));
    EXPECT_EQ(test::textOf(bar, "lateness"), QStringLiteral("68 µs"));
    EXPECT_EQ(test::textOf(bar, "ticks"), QStringLiteral("1,234,567"));
    EXPECT_EQ(test::textOf(bar, "overruns"), QStringLiteral("12"));
    EXPECT_EQ(test::textOf(bar, "lost"), QStringLiteral("3"));
    EXPECT_EQ(test::textOf(bar, "frames"), QStringLiteral("29.7"));
    EXPECT_EQ(test::textOf(bar, "scheduling"), QStringLiteral("real-time"));
}

TEST(LoopStatusBar, SaysWhenTheLoopMayNotBeRealTime) {
    LoopStatusBar bar;
    bar.show({.statistics = statistics(SchedulingPolicy::Ordinary)});
    EXPECT_EQ(test::textOf(bar, "scheduling"), QStringLiteral("ordinary"));
    EXPECT_TRUE(bar.findChild<QLabel*>(QStringLiteral("scheduling"))
                    ->toolTip()
                    .contains(QStringLiteral("no permission for SCHED_FIFO")));
    bar.clear();
    EXPECT_EQ(test::textOf(bar, "scheduling"), QStringLiteral("–"));
    EXPECT_EQ(test::textOf(bar, "ticks"), QStringLiteral("–"));
}

TEST(LoopStatusBar, ARateThatIsNotKnownYetIsNoZero) {
    LoopStatusBar bar;
    bar.setFramesPerSecond(std::nullopt);
    EXPECT_EQ(test::textOf(bar, "frames"), QStringLiteral("–"));
    const std::size_t unknown = bar.numbers({}).size();
    bar.setFramesPerSecond(30.0);
    EXPECT_EQ(bar.numbers({}).size(), unknown + 1);
}

bool isShown(const LoopStatusBar& bar, const char* name) {
    return !bar.findChild<QLabel*>(QString::fromUtf8(name))->isHidden();
}

TEST(LoopStatusBar, SaysInOneWordWhetherTheLoopKeepsItsRateAndTheRestOnRequest) {
    LoopStatusBar bar;
    bar.resize(1240, 20);
    bar.setRateAsked(1000.0);
    LoopStatistics now = statistics(SchedulingPolicy::Ordinary);
    bar.show({.statistics = now});
    now.ticks += 1000;
    now.overruns += 5;
    bar.show({.statistics = now});
    EXPECT_EQ(test::textOf(bar, "loopState"), QStringLiteral("● loop on time"));
    now.ticks += 1000;
    now.overruns += 50;
    bar.show({.statistics = now});
    EXPECT_EQ(test::textOf(bar, "loopState"), QStringLiteral("▲ loop late"));
    for (const char* const name : {"tickTime", "lateness", "overruns"}) {
        EXPECT_FALSE(isShown(bar, name)) << name;
    }
    EXPECT_TRUE(bar.findChild<QLabel*>(QStringLiteral("loopState"))
                    ->toolTip()
                    .contains(QStringLiteral("25.1 µs")));
    bar.setDetailed(true);
    for (const char* const name : {"tickTime", "lateness", "overruns"}) {
        EXPECT_TRUE(isShown(bar, name)) << name;
    }
    now.ticks += 1000;
    bar.show({.statistics = now});
    EXPECT_EQ(test::textOf(bar, "loopState"), QStringLiteral("● loop on time"));
}

TEST(LoopStatusBar, LeavesOutWhatDoesNotFit) {
    LoopStatusBar bar;
    bar.resize(700, 20);
    bar.setDetailed(true);
    bar.show({.statistics = statistics(SchedulingPolicy::Ordinary)});
    EXPECT_LE(bar.minimumSizeHint().width(), 700);
    EXPECT_TRUE(isShown(bar, "tickTime"));
    EXPECT_FALSE(isShown(bar, "ticks"));
}

}  // namespace
}  // namespace asperity
