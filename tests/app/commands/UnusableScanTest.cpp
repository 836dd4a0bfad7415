#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/app/ProgramRun.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace asperity::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The same fault has the same exit code, whichever command finds it.
TEST(UnusableScan, WithoutAHeightIsAFileThatCannotBeRead) {
    const ScratchFolder scratch;
    HeightMap map = bumpyMap(16, 16);
    std::ranges::fill(map.heights, std::numeric_limits<double>::quiet_NaN());
    const std::string scan = scratch.file("nan.gsf").string();
    writeHeightMap(scan, map, {});
    const std::string out = " --out " + scratch.file("out").string();
    const auto target = [&](const char* name) { return " " + scratch.file(name).string(); };
    for (const std::string& call :
         {"measure " + scan, "explore " + scan + out, "loop " + scan + " --duration 0.1",
          "map " + scan + " --no-pictures --out" + target("map.gwy"),
          "render " + scan + " --out" + target("a.png"), "tradeoff " + scan + out,
          "convert " + scan + target("a.stl"), "convert " + scan + target("a.vtp"),
          "convert " + scan + target("a.vts"), "convert " + scan + target("a.gwy") + " --residual",
          "convert " + scan + target("a.gwy") + " --erode 1e-8",
          "convert " + scan + target("a.gwy") + " --level plane"}) {
        const auto run = runProgram(call);
        EXPECT_EQ(run.exitCode, 3) << call << '\n' << run.output;
        EXPECT_THAT(run.output, HasSubstr("nan.gsf: the height map holds no valid pixel")) << call;
    }
    EXPECT_EQ(runProgram("convert " + scan + target("copy.gwy")).exitCode, 0)
        << "nothing is computed";
    for (const std::string& call : {"info " + scan, "info --json " + scan}) {
        const auto run = runProgram(call);
        EXPECT_EQ(run.exitCode, 0) << "it says what the file is";
        EXPECT_THAT(run.output, HasSubstr("' holds no valid pixel: commands that need heights"));
    }
}

TEST(UnusableScan, OfADiskThatIsFullIsToldInOurWordsAlone) {
    const ScratchFolder scratch;
    const std::string scan = scratch.file("in.gsf").string();
    writeHeightMap(scan, bumpyMap(300, 300), {});
    for (const char* const name :
         {"out.vtp", "out.vts", "out.stl", "out.tiff", "out.exr", "out.txt", "out.png"}) {
        const auto run =
            runProgram("convert " + scan + " " + scratch.file(name).string(), "ulimit -f 40;");
        EXPECT_EQ(run.exitCode, 1) << name;
        EXPECT_THAT(run.output, HasSubstr("writing stopped half-way (disk full?)")) << name;
        EXPECT_THAT(run.output, Not(HasSubstr("ERR"))) << name;
        EXPECT_THAT(run.output, Not(HasSubstr("vtk"))) << name;
        EXPECT_THAT(run.output, Not(HasSubstr("TIFF"))) << name;
        EXPECT_THAT(run.output, Not(HasSubstr(".part"))) << name;
    }
}

}  // namespace
}  // namespace asperity::test
