#include "core/ShareOut.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace asperity {
namespace {

/// The last report, for all threads.
class LatestShare : public Progress {
public:
    void report(double fraction) override {
        ++reports;
        latest = fraction;
    }
    [[nodiscard]] bool isCanceled() const override { return false; }

    std::atomic<int> reports = 0;
    std::atomic<double> latest = -1.0;
};

TEST(ShareOut, DoesEachPieceOnceAndReportsAFewDozenTimes) {
    std::vector<std::atomic<int>> done(1000);
    LatestShare progress;
    shareOut(1000, &progress, [&](int index, const CancelCheck& check) {
        check();
        ++done[static_cast<std::size_t>(index)];
    });
    for (const std::atomic<int>& times : done) {
        EXPECT_EQ(times, 1);
    }
    EXPECT_LE(progress.reports, 51);
    EXPECT_GE(progress.latest, 0.9);
}

TEST(ShareOut, UsesNoMoreThreadsThanItMay) {
    const std::thread::id caller = std::this_thread::get_id();
    shareOut(
        50, nullptr,
        [&](int /*index*/, const CancelCheck& /*check*/) {
            EXPECT_EQ(std::this_thread::get_id(), caller);
        },
        1);
}

/// A loaded machine may start the calling thread when the others have done everything.
TEST(ShareOut, ReportsWhatOthersDidAlone) {
    if (std::thread::hardware_concurrency() < 2) {
        GTEST_SKIP() << "there are no others";
    }
    LatestShare progress;
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> othersAreDone = false;
    shareOut(2, &progress, [&](int /*index*/, const CancelCheck& /*check*/) {
        if (std::this_thread::get_id() != caller) {
            othersAreDone = true;
        }
        while (!othersAreDone) {
            std::this_thread::yield();
        }
    });
    EXPECT_EQ(progress.latest, 1.0);
}

/// While the first piece took minutes, nothing showed that the others were done.
TEST(ShareOut, ReportsWhatIsDoneWhileAPieceTakesLong) {
    if (std::thread::hardware_concurrency() < 2) {
        GTEST_SKIP() << "there is nobody to do the rest meanwhile";
    }
    LatestShare progress;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    shareOut(4, &progress, [&](int index, const CancelCheck& check) {
        while (index == 0 && progress.latest < 0.75 &&
               std::chrono::steady_clock::now() < deadline) {
            check();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (index == 0) {
            EXPECT_EQ(progress.latest, 0.75);
        }
    });
}

}  // namespace
}  // namespace asperity
