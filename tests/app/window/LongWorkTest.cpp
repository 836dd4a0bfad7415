#include "app/window/LongWork.h"

#include "tests/support/Waits.h"

#include <QElapsedTimer>
#include <QtTest>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace asperity::test {
namespace {

class LongWorkTest : public ::testing::Test {
protected:
    /// Ends when it is told to, or canceled.
    int wait(Progress& progress) {
        while (!mayEnd) {
            reportTo(&progress, 0.5);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return 7;
    }
    void startToWait(const char* words) {
        work.start(words, [this](Progress& progress) { return wait(progress); });
    }

    std::atomic<bool> mayEnd = false;
    std::vector<std::string> begun;
    double fraction = -1.0;
    int ended = 0;
    std::vector<int> results;
    int failures = 0;
    LongWork<int> work{
        {.begin = [this](const QString& words) { begun.push_back(words.toStdString()); },
         .setFraction = [this](double share) { fraction = share; },
         .end = [this] { ++ended; }},
        {.finished = [this](int result) { results.push_back(result); },
         .failed = [this](const std::exception_ptr&) { ++failures; }}};
};

TEST_F(LongWorkTest, QuickWorkIsNotShown) {
    QElapsedTimer time;
    time.start();
    work.start("quick", [](Progress& progress) {
        progress.report(0.5);
        return 3;
    });
    EXPECT_TRUE(work.isAwaited());
    ASSERT_TRUE(eventually([this] { return !results.empty(); }));
    EXPECT_FALSE(work.isAwaited());
    const bool isQuick = time.elapsed() < kShownAfter;  // not where others have the processor
    QTest::qWait(kShownAfter + 100);                    // it would be shown by then
    EXPECT_TRUE(begun.empty() || !isQuick);
    EXPECT_EQ(static_cast<std::size_t>(ended), begun.size());
}

TEST_F(LongWorkTest, WorkOfMoreThanThatIsShownWithHowFarItIs) {
    QElapsedTimer time;
    time.start();
    startToWait("slow");
    ASSERT_TRUE(eventually([this] { return !begun.empty(); }));
    EXPECT_GE(time.elapsed(), kShownAfter - 10);
    EXPECT_EQ(begun, std::vector<std::string>{"slow"});
    EXPECT_EQ(fraction, 0.5) << "what was reported before, too";
    mayEnd = true;
    ASSERT_TRUE(eventually([this] { return !results.empty(); }));
    EXPECT_EQ(ended, 1);
}

TEST_F(LongWorkTest, NothingComesOfWhatIsCanceled) {
    EXPECT_FALSE(work.cancel()) << "there is nothing";
    startToWait("slow");
    ASSERT_TRUE(eventually([this] { return !begun.empty(); }));
    EXPECT_TRUE(work.cancel());
    EXPECT_EQ(ended, 1);
    EXPECT_FALSE(work.isAwaited());
    mayEnd = true;
    QTest::qWait(100);  // in which it ends: nothing may come of it
    EXPECT_TRUE(results.empty());
    EXPECT_EQ(failures, 0);
}

TEST_F(LongWorkTest, CanceledSoonItIsNeverShown) {
    startToWait("slow");
    EXPECT_TRUE(work.cancel());
    QTest::qWait(kShownAfter + 100);  // it would be shown by then
    EXPECT_TRUE(begun.empty());
    EXPECT_EQ(ended, 0);
}

TEST_F(LongWorkTest, OtherWorkTakesItsPlaceAtOnce) {
    startToWait("first");
    ASSERT_TRUE(eventually([this] { return !begun.empty(); }));
    startToWait("second");
    EXPECT_EQ(begun, (std::vector<std::string>{"first", "second"}));
    mayEnd = true;
    ASSERT_TRUE(eventually([this] { return results.size() == 1; }));
    QTest::qWait(100);  // no other one may come
    EXPECT_EQ(results.size(), 1U);
    EXPECT_EQ(ended, 1);
}

TEST_F(LongWorkTest, AFailureEndsTheLine) {
    work.start("fails", [this](Progress& progress) -> int {
        wait(progress);
        throw std::runtime_error("no");
    });
    ASSERT_TRUE(eventually([this] { return !begun.empty(); }));
    mayEnd = true;
    ASSERT_TRUE(eventually([this] { return failures == 1; }));
    EXPECT_EQ(ended, 1);
}

}  // namespace
}  // namespace asperity::test
