#include "app/window/live/LoopStatusBar.h"

#include "tests/ui/widgets/PanelSamples.h"

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
    EXPECT_EQ(test::textOf(bar, "scheduling"),
              QStringLiteral("ordinary: no permission for SCHED_FIFO"));
    bar.clear();
    EXPECT_EQ(test::textOf(bar, "scheduling"), QString());
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

TEST(LoopStatusBar, FitsASmallWindow) {
    LoopStatusBar bar;
    bar.show({.statistics = statistics(SchedulingPolicy::Ordinary)});
    EXPECT_LE(bar.minimumSizeHint().width(), 1240);
}

}  // namespace
}  // namespace asperity
