#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

// The sources of a file's numbers, as `asperity info` prints them.

namespace asperity {
namespace {

using testing::HasSubstr;

std::string sample() { return (test::dataFolder() / "samples/granular_film.gsf").string(); }

TEST(Info, JsonSaysWhereScaleAndOrientationComeFrom) {
    const auto run = test::runProgram("info --json " + sample());
    const nlohmann::json info = nlohmann::json::parse(run.output);
    EXPECT_EQ(info["provenance"][0],
              nlohmann::json({{"what", "format version"}, {"value", "1.0"}, {"source", "line 1"}}));
    const nlohmann::json& entries = info["channels"][0]["provenance"];
    EXPECT_EQ(entries[0]["value"], "5e-07 x 5e-07 m");
    EXPECT_EQ(entries[1]["source"], "header, ZUnits");
    EXPECT_EQ(entries[2]["what"], "orientation");
}

TEST(Info, TextSaysWhereTheNumbersOfTheDefaultChannelComeFrom) {
    EXPECT_THAT(
        test::runProgram("info " + sample()).output,
        HasSubstr("Where the numbers of 'Granular film, measured' come from\n"
                  "- format version: 1.0 (line 1)\n"
                  "- lateral size: 5e-07 x 5e-07 m (header, XReal and YReal)\n"
                  "- scale: 1 m per stored number (header, ZUnits)\n"
                  "- orientation: the top row is stored first (the same in every .gsf file)\n"));
}

/// 40 kB of a damaged file were in one sentence.
TEST(Info, QuotesNoMoreOfAFileThanCanBeRead) {
    const test::ScratchFolder scratch;
    const auto file =
        scratch.write("long.gsf", "Gwyddion Simple Field 1.0\nXRes = " + std::string(40'000, 'x') +
                                      "\nYRes = 2\n" + std::string(4, '\0'));
    for (const std::string command : {"info ", "convert --to gwy --out-dir "}) {
        const auto run = test::runProgram(
            command + (command == "info " ? "" : scratch.path().string() + " ") + file.string());
        EXPECT_EQ(run.output.rfind("asperity: " + file.string() + ": ", 0), 0U) << run.output;
        EXPECT_LT(run.output.size(), 1100U);
        EXPECT_THAT(run.output, HasSubstr("expected a whole number, found 'xxxxxx"));
        EXPECT_THAT(run.output, HasSubstr("xxx … xxx"));
    }
}

/// The mask of a scene's materials was taken for a scan whose file lacks the unit.
TEST(Info, CallsAMaskOneAndSoDoesEveryCommandThatTakesAScan) {
    const std::string mask = (test::dataFolder() / "samples/particle_mask.gsf").string();
    EXPECT_THAT(
        test::runProgram("info " + mask).output,
        HasSubstr("stand': this is a mask, not heights: its values have no unit, and 58.6 % "
                  "of them are 0 or 1\n"));
    for (const std::string command : {"measure ", "explore --out /nowhere ", "convert "}) {
        const auto run = test::runProgram(command + mask + (command == "convert " ? " x.gwy" : ""));
        EXPECT_NE(run.exitCode, 0);
        EXPECT_THAT(run.output, HasSubstr("stand': this is a mask, not heights (use it as "
                                          "material_mask"));
    }
    EXPECT_THAT(test::runProgram("measure --z-unit nm " + mask).output,
                HasSubstr("this is a mask, not heights"));
}

}  // namespace
}  // namespace asperity
