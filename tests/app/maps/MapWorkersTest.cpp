#include "app/maps/MapJob.h"
#include "core/Error.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

namespace asperity::test {
namespace {

using namespace std::chrono_literals;

std::vector<double> twice(int row, const CancelCheck& /*check*/) { return {2.0 * row}; }

TEST(MapWorkers, GivesEachRowBackOnce) {
    MapWorkers crew(3, twice);
    for (int row = 0; row < 50; ++row) {
        crew.give(row);
    }
    EXPECT_EQ(crew.open(), 50U);
    std::set<int> rows;
    while (crew.open() > 0) {
        for (const FinishedRow& made : crew.take()) {
            EXPECT_EQ(made.values, std::vector<double>{2.0 * made.row});
            EXPECT_TRUE(rows.insert(made.row).second);
        }
    }
    EXPECT_EQ(rows.size(), 50U);
}

TEST(MapWorkers, TellsWhatWentWrong) {
    MapWorkers crew(
        2, [](int, const CancelCheck&) -> std::vector<double> { throw Error("no such row"); });
    crew.give(1);
    const auto takeUntilItThrows = [&crew] {
        for (int i = 0; i < 1000; ++i) {
            (void)crew.take();
            std::this_thread::sleep_for(1ms);
        }
    };
    EXPECT_THROW(takeUntilItThrows(), Error);
}

TEST(MapWorkers, ItsEndCancelsWhatIsInWork) {
    std::atomic<bool> begun = false;
    {
        MapWorkers crew(1, [&begun](int, const CancelCheck& check) -> std::vector<double> {
            begun = true;
            for (;;) {
                check();
                std::this_thread::sleep_for(1ms);
            }
        });
        crew.give(0);
        crew.give(1);
        while (!begun) {
            std::this_thread::sleep_for(1ms);
        }
    }
    SUCCEED() << "it would never come here";
}

}  // namespace
}  // namespace asperity::test
