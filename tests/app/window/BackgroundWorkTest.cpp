#include "app/window/LongWork.h"
#include "tests/support/Waits.h"

#include <QtTest>

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <vector>

namespace asperity::test {
namespace {

class Work : public ::testing::Test {
protected:
    /// Goes on until it is canceled.
    static int endless(Progress& progress) {
        while (true) {
            reportTo(&progress, 0.5);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    std::vector<double> shares;
    std::vector<int> results;
    std::string reason;
    int canceled = 0;
    BackgroundWork<int> work{
        {.progressed = [this](double share) { shares.push_back(share); },
         .finished = [this](int result) { results.push_back(result); },
         .failed =
             [this](const std::exception_ptr& error) { reason = reasonOf(error).toStdString(); },
         .canceled = [this] { ++canceled; }}};
};

TEST_F(Work, SaysHowFarItIsAndGivesItsResult) {
    EXPECT_FALSE(work.isBusy());
    work.start([](Progress& progress) {
        progress.report(0.25);
        progress.report(1.0);
        return 7;
    });
    EXPECT_TRUE(work.isBusy());
    ASSERT_TRUE(eventually([this] { return !work.isBusy(); }));
    EXPECT_EQ(shares, (std::vector{0.25, 1.0}));
    EXPECT_EQ(results, std::vector{7});
    EXPECT_EQ(canceled, 0);
}

TEST_F(Work, SaysWhyItFailed) {
    work.start([](Progress&) -> int { throw std::runtime_error("no\nluck"); });
    ASSERT_TRUE(eventually([this] { return !reason.empty(); }));
    EXPECT_EQ(reason, "no\\nluck") << "in one line";
    work.start([](Progress&) -> int { throw std::bad_alloc(); });
    EXPECT_TRUE(eventually([this] { return reason == "out of memory"; }));
    EXPECT_TRUE(results.empty());
}

TEST_F(Work, OnceCanceledItOnlySaysThatItHasEnded) {
    work.start(endless);
    ASSERT_TRUE(eventually([this] { return !shares.empty(); }));
    work.cancel();
    shares.clear();
    ASSERT_TRUE(eventually([this] { return canceled == 1; }));
    EXPECT_FALSE(work.isBusy());
    EXPECT_TRUE(shares.empty());
    EXPECT_TRUE(reason.empty());
}

TEST_F(Work, OnlyTheLastOneCounts) {
    work.start(endless);
    work.start([](Progress&) { return 1; });
    work.start([](Progress&) { return 2; });
    ASSERT_TRUE(eventually([this] { return !results.empty(); }));
    QTest::qWait(50);  // no other one may come
    EXPECT_EQ(results, std::vector{2});
}

TEST_F(Work, EndsWithItsOwner) {
    BackgroundWork<int> brief({.progressed = [](double) {},
                               .finished = [](int) {},
                               .failed = [](const std::exception_ptr&) {}});
    brief.start(endless);
}

}  // namespace
}  // namespace asperity::test
