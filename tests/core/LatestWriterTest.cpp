#include "core/LatestWriter.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>

namespace asperity {
namespace {

using namespace std::chrono_literals;

bool eventually(const std::function<bool()>& holds) {
    const auto end = std::chrono::steady_clock::now() + 120s;
    while (std::chrono::steady_clock::now() < end) {
        if (holds()) {
            return true;
        }
        std::this_thread::sleep_for(2ms);
    }
    return false;
}

/// A disk that can be full.
class LatestWriterTest : public ::testing::Test {
protected:
    void make(std::chrono::milliseconds pause) {
        writer = std::make_unique<LatestWriter<int>>(
            [this](int value) {
                if (isFull) {
                    ++failures;
                    throw std::runtime_error("the disk is full");
                }
                written = value;
            },
            pause);
    }
    std::string failure() {
        std::string why;
        EXPECT_TRUE(eventually([&] {
            why = writer->takeFailure();
            return !why.empty();
        }));
        return why;
    }

    std::atomic<bool> isFull = false;
    std::atomic<int> written = 0;
    std::atomic<int> failures = 0;
    std::unique_ptr<LatestWriter<int>> writer;
};

TEST_F(LatestWriterTest, WritesTheLastValueAtTheLatestWhenItEnds) {
    make(3s);
    for (int i = 1; i <= 200; ++i) {
        writer->write(i);
    }
    writer.reset();
    EXPECT_EQ(written, 200);
}

TEST_F(LatestWriterTest, TriesAgainAndSaysOnceWhyItMust) {
    make(5ms);
    isFull = true;
    writer->write(1);
    EXPECT_EQ(failure(), "the disk is full");
    ASSERT_TRUE(eventually([this] { return failures >= 3; }));
    EXPECT_EQ(writer->takeFailure(), "");
    isFull = false;
    EXPECT_TRUE(eventually([this] { return written == 1; }));
    isFull = true;
    writer->write(2);
    EXPECT_EQ(failure(), "the disk is full") << "another time";
}

TEST_F(LatestWriterTest, ALaterValueReplacesOneThatCouldNotBeWritten) {
    make(1h);
    isFull = true;
    writer->write(1);
    EXPECT_EQ(failure(), "the disk is full");
    writer->write(2);
    isFull = false;
    writer.reset();
    EXPECT_EQ(written, 2) << "at the end, however long the pause is";
}

TEST_F(LatestWriterTest, EndsWhereNothingCanBeWritten) {
    make(1h);
    isFull = true;
    writer->write(1);
    EXPECT_EQ(failure(), "the disk is full");
    writer.reset();
    EXPECT_EQ(written, 0);
    EXPECT_EQ(failures, 2);
}

}  // namespace
}  // namespace asperity
