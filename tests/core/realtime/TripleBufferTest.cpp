#include "core/realtime/TripleBuffer.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

namespace asperity {
namespace {

TEST(TripleBuffer, GivesTheInitialValueUntilSomethingIsWritten) {
    TripleBuffer<int> buffer(7);
    EXPECT_EQ(buffer.read(), 7);
    EXPECT_EQ(buffer.read(), 7);
}

TEST(TripleBuffer, GivesTheLatestValueAndKeepsIt) {
    TripleBuffer<int> buffer(0);
    for (int i = 1; i <= 5; ++i) {
        buffer.write(i);
    }
    EXPECT_EQ(buffer.read(), 5);
    EXPECT_EQ(buffer.read(), 5);
    buffer.write(6);
    EXPECT_EQ(buffer.read(), 6);
}

TEST(TripleBuffer, LeavesAValueAloneWhileItIsRead) {
    TripleBuffer<int> buffer(0);
    buffer.write(1);
    const int& held = buffer.read();
    buffer.write(2);
    buffer.write(3);
    buffer.write(4);
    EXPECT_EQ(held, 1);
    EXPECT_EQ(buffer.read(), 4);
}

TEST(TripleBuffer, NeverTearsAValueNorGoesBack) {
    using Wide = std::array<long, 64>;
    TripleBuffer<Wide> buffer(Wide{});
    constexpr long kLast = 200000;
    std::atomic<bool> failed{false};
    std::thread writer([&] {
        for (long i = 1; i <= kLast; ++i) {
            Wide value;
            value.fill(i);
            buffer.write(value);
        }
    });
    long newest = 0;
    while (newest < kLast && !failed) {
        const Wide& value = buffer.read();
        for (const long entry : value) {
            failed = failed || entry != value.front();
        }
        failed = failed || value.front() < newest;
        newest = value.front();
    }
    writer.join();
    EXPECT_FALSE(failed);
}

}  // namespace
}  // namespace asperity
