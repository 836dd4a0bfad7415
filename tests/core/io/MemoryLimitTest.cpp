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

/// What is compressed is refused before it is decoded, what lies open before it is copied.
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
