#include "core/io/MemoryLimit.h"

#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/tables/CsvTable.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/GivenMemory.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(MemoryLimit, IsHalfOfTheMachines) {
    EXPECT_GT(memoryForInput(), std::uint64_t{1} << 28U);
    const GivenMemory small(2'000'000);
    EXPECT_EQ(memoryForInput(), 1'000'000U);
    EXPECT_EQ(refusalOf([] { requireMemory(1'000'000, "a.gsf", ""); }), "");
    EXPECT_THAT(refusalOf([] { requireMemory(3'000'000, "a.gsf", "part"); }),
                AllOf(HasSubstr("a.gsf: part: it takes 3 MB"), HasSubstr("at most 1 MB")));
}

/// A stopped scan of usual size is one value; a file of several images counts as one.
TEST(MemoryLimit, HasASecondOneForWhatAFileIsPackedIn) {
    constexpr std::uint64_t kGiB = std::uint64_t{1} << 30U;
    const auto refusal = [](std::uint64_t decoded, std::uint64_t packed) {
        return refusalOf([&] { requireUsualPacking(decoded, packed, "a.png", "IDAT"); });
    };
    EXPECT_EQ(refusal(kGiB, 1), "");
    EXPECT_EQ(refusal(32 * kGiB, kGiB / 2), "") << "as much as a large file may hold";
    EXPECT_THAT(refusal(33 * kGiB, kGiB / 2),
                AllOf(HasSubstr("a.png: IDAT: its images decode to 35.4 GB"),
                      HasSubstr("of a file of 537 MB at most 34.4 GB are expected")));
}

/// Compressed data are refused before they are decoded, others before they are copied.
TEST(MemoryLimit, HoldsForImages) {
    const ScratchFolder scratch;
    for (const char* const name : {"a.png", "a.exr", "a.gsf", "a.tiff"}) {
        writeHeightMap(scratch.file(name), bumpyMap(512, 512), {});
        const GivenMemory small(std::uint64_t{1} << 20U);
        EXPECT_THAT(refusalOf([&] { (void)ScanFile(scratch.file(name)).readHeightChannel(""); }),
                    AllOf(HasSubstr(name), HasSubstr("of memory; expected at most 524 kB")));
    }
}

TEST(MemoryLimit, HoldsForTables) {
    std::string text = "a,b\n";
    for (int i = 0; i < 10'000; ++i) {
        text += "1,2\n";
    }
    EXPECT_EQ(CsvTable(text, "a.csv").rows(), 10'000U);
    const GivenMemory small(std::uint64_t{1} << 18U);
    EXPECT_THAT(refusalOf([&] { const CsvTable table(text, "a.csv"); }),
                HasSubstr("a.csv: it takes"));
}

}  // namespace
}  // namespace asperity::test
