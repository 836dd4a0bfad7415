#include "core/haptics/blackbox/BlackBox.h"

#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kStep = 1e-3;  // [s]

/// Ticks that say nothing but their time and fault, with a mark at regular intervals.
class Ticks {
public:
    explicit Ticks(BlackBox& box) : box_(box) {}

    void run(long count, Fault fault = Fault::None) {
        for (long i = 0; i < count; ++i) {
            Snapshot& now = latest_;
            now.sample.time = static_cast<double>(ticks_) * kStep;
            now.sample.input.timeStep = kStep;
            now.sample.output.fault = fault;
            now.memory.started = true;
            now.memory.mapping.device.x() = now.sample.time;  // tells the memories apart
            box_.take(now.sample);
            if (++ticks_ % markedEvery == 0) {
                box_.mark(now);
            }
        }
    }
    /// @param isMarked whether the last one is the loop's latest when somebody visits the box
    void lose(long count, bool isMarked = false) {
        ticks_ += count;
        if (isMarked) {
            latest_.sample.time = static_cast<double>(ticks_ - 1) * kStep;
            latest_.memory.mapping.device.x() = latest_.sample.time;
            box_.mark(latest_);
        }
    }
    [[nodiscard]] double now() const { return latest_.sample.time; }

    long markedEvery = 25;

private:
    BlackBox& box_;
    Snapshot latest_;
    long ticks_ = 0;
};

/// Without a gap, and the memory is that of the tick before the first one.
void expectReplayable(const BlackBox& box) {
    ASSERT_FALSE(box.samples().empty());
    for (std::size_t i = 1; i < box.samples().size(); ++i) {
        ASSERT_NEAR(box.samples()[i].time - box.samples()[i - 1].time, kStep, 1e-9 * kStep);
    }
    EXPECT_NEAR(box.memory().mapping.device.x(), box.samples().front().time - kStep, 1e-9 * kStep);
}

double heldSeconds(const BlackBox& box) {
    return static_cast<double>(box.samples().size()) * kStep;
}

TEST(BlackBox, KeepsAYoungRunFromItsFirstTick) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.run(1500);
    EXPECT_EQ(box.samples().size(), 1500U);
    EXPECT_EQ(box.samples().front().time, 0.0);
    EXPECT_FALSE(box.memory().started);
}

TEST(BlackBox, KeepsTheLastSecondsInOrder) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    for (int i = 0; i < 20; ++i) {
        ticks.run(2137);
        EXPECT_EQ(box.samples().back().time, ticks.now());
        EXPECT_GE(heldSeconds(box), 2.0 - 1e-9);
        EXPECT_LE(heldSeconds(box), 2.0 + BlackBox::kMarkSpacing + 25 * kStep + 1e-9);
        expectReplayable(box);
    }
}

TEST(BlackBox, AsksForNoMemoryWhileItRuns) {
    BlackBox box(kStep, 1.0);
    Ticks ticks(box);
    const std::size_t before = test::allocationCount();
    ticks.run(10000);
    box.freeze();
    ticks.run(10);
    box.restart();
    ticks.run(3000);
    EXPECT_EQ(test::allocationCount(), before);
    expectReplayable(box);
}

TEST(BlackBox, FreezesAtTheFirstFaultAndKeepsIt) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.run(5000);
    EXPECT_FALSE(box.frozen());
    ticks.run(1, Fault::DeviceLost);
    const double event = ticks.now();
    ticks.run(5000, Fault::DeviceLost);
    ticks.run(5000);
    ticks.run(100, Fault::VelocityTrip);
    EXPECT_TRUE(box.frozen());
    EXPECT_EQ(box.samples().back().time, event);
    EXPECT_EQ(box.samples().back().output.fault, Fault::DeviceLost);
    EXPECT_GE(heldSeconds(box), 2.0 - 1e-9);
    expectReplayable(box);
}

TEST(BlackBox, BegunAnewItWaitsForTheNextFaultNotTheLatchedOne) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.run(3000);
    ticks.run(500, Fault::DeviceLost);
    box.restart();
    EXPECT_TRUE(box.samples().empty());
    ticks.run(500, Fault::DeviceLost);
    EXPECT_FALSE(box.frozen());
    ticks.run(500);
    ticks.run(1, Fault::NotFinite);
    EXPECT_TRUE(box.frozen());
    EXPECT_EQ(box.samples().back().output.fault, Fault::NotFinite);
    expectReplayable(box);
}

TEST(BlackBox, GivesAwayWhatItHoldsAndBeginsAnew) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.run(3000);
    ticks.run(1, Fault::DeviceLost);
    const double event = ticks.now();
    const BlackBox given = box.release();
    ticks.run(500, Fault::DeviceLost);
    EXPECT_TRUE(given.frozen());
    EXPECT_EQ(given.samples().back().time, event);
    expectReplayable(given);
    EXPECT_FALSE(box.frozen());
    EXPECT_GT(box.samples().front().time, event);
    expectReplayable(box);
    ticks.run(3000);
    EXPECT_GE(heldSeconds(box), 2.0 - 1e-9);
}

TEST(BlackBox, BeginsAfterTicksThatWereLost) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.run(1000);
    ticks.lose(1);
    const double end = ticks.now();
    ticks.run(500);
    EXPECT_GT(box.samples().front().time, end + kStep);
    EXPECT_GT(heldSeconds(box), 0.4);
    expectReplayable(box);
}

/// The owner's thread hung, visits the box once, and the fault comes before its next visit.
TEST(BlackBox, BeginsRightAfterALostTickThatIsMarked) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.run(1000);
    ticks.lose(500, true);
    const double lost = ticks.now();
    ticks.run(3);
    ticks.run(1, Fault::NotFinite);
    EXPECT_TRUE(box.frozen());
    ASSERT_EQ(box.samples().size(), 4U);
    EXPECT_NEAR(box.samples().front().time, lost + kStep, 1e-9 * kStep);
    EXPECT_EQ(box.samples().back().output.fault, Fault::NotFinite);
    expectReplayable(box);
}

TEST(BlackBox, HoldsLessRatherThanMoreMemoryWhenMarksAreFarApart) {
    BlackBox box(kStep, 2.0);
    Ticks ticks(box);
    ticks.markedEvery = 2500;
    ticks.run(3100);
    for (int i = 0; i < 20; ++i) {
        ticks.run(2600);
        EXPECT_LE(heldSeconds(box), 3.0 + 1e-9);
        expectReplayable(box);
    }
    ticks.markedEvery = 1000000;
    ticks.run(10000);
    EXPECT_TRUE(box.samples().empty()) << "no replay could begin";
}

}  // namespace
}  // namespace asperity
