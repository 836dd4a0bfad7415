#include "core/io/FileBytes.h"
#include "tests/core/io/heightmap/BoundedRead.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

// Real files cut off or with a flipped bit: never a crash or a hang, nor more memory than their
// size explains. ASPERITY_DAMAGES says how many of each (25).

namespace asperity::test {

namespace {

constexpr double kMaxSeconds = 2.0;
constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;

std::uint64_t memoryBound(std::uint64_t size) { return 10 * size + 64 * kMiB; }

class DamageBounds : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() {
        std::printf("%-42s %6s %6s %8s %9s %9s\n", "file", "cases", "read", "refused", "worst s",
                    "worst MiB");
    }

    void SetUp() override {
        ASPERITY_NEEDS_SHARED_DATA();
        if (kSanitized) {
            GTEST_SKIP() << "a sanitizer takes memory of its own";
        }
        bytes = readFileBytes(sharedData("afm/" + GetParam()));
    }

    void TearDown() override {
        std::printf("%-42s %6d %6d %8d %9.3f %9.1f\n", GetParam().c_str(), read + refused, read,
                    refused, worst.seconds,
                    static_cast<double>(worst.memory) / static_cast<double>(kMiB));
    }

    static int damages() {
        const char* const wanted = std::getenv("ASPERITY_DAMAGES");
        return wanted != nullptr ? std::atoi(wanted) : 25;
    }

    /// Where headers are, and the directories at the end of archives, there are more of them.
    std::size_t offset() {
        const auto size = static_cast<double>(bytes.size());
        const double share = std::uniform_real_distribution<double>(0.0, 1.0)(random);
        const auto near = std::min(static_cast<std::size_t>(std::pow(size, share)) - 1,
                                   bytes.size() - 1);  // to an end
        switch (random() % 4) {
        case 0:
            return random() % bytes.size();
        case 1:
            return bytes.size() - 1 - near;
        default:
            return near;
        }
    }

    void expectWithinBounds(const std::string& damaged, const std::string& what) {
        const std::uint64_t most = memoryBound(bytes.size());
        const BoundedRead result = readBounded(damaged, most);
        EXPECT_EQ(result.failure, "") << what;
        EXPECT_LT(result.seconds, kMaxSeconds) << what;
        EXPECT_LT(result.memory, most) << what;
        ++(result.isRead ? read : refused);
        worst.seconds = std::max(worst.seconds, result.seconds);
        worst.memory = std::max(worst.memory, result.memory);
    }

    std::string bytes;
    std::mt19937_64 random{20261123};
    int read = 0;
    int refused = 0;
    BoundedRead worst;  ///< the most of each
};

TEST_P(DamageBounds, HoldWhereverItIsCutOff) {
    for (int i = 0; i < damages(); ++i) {
        const std::size_t length = offset();
        expectWithinBounds(bytes.substr(0, length), "cut to " + std::to_string(length));
    }
}

TEST_P(DamageBounds, HoldWhicheverBitIsFlipped) {
    for (int i = 0; i < damages(); ++i) {
        const std::size_t flipped = offset();
        const auto bit = static_cast<unsigned>(random() % 8);
        std::string damaged = bytes;
        damaged[flipped] =
            static_cast<char>(static_cast<unsigned char>(damaged[flipped]) ^ (1U << bit));
        expectWithinBounds(damaged, "bit " + std::to_string(bit) + " of byte " +
                                        std::to_string(flipped) + " flipped");
    }
}

INSTANTIATE_TEST_SUITE_P(RealScans, DamageBounds, testing::ValuesIn(allScans()),
                         [](const auto& scan) { return testName(scan.param); });

}  // namespace
}  // namespace asperity::test
