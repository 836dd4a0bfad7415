#include "core/Units.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

// Names of files, folders and channels are bytes that others chose.

namespace asperity {
namespace {

/// Finds what no text may show a terminal: a control character but the line feed.
bool obeysNothing(const std::string& output) {
    return output.find_first_of("\x1b\r\a\x7f") == std::string::npos &&
           output.find("\xC2\x9B") == std::string::npos;
}

const std::string kChannel = "H\x1b[31m\u009B\x7f";

HeightMap bumps() {
    HeightMap map{.columns = 32,
                  .rows = 32,
                  .pitchX = 3.0_nm,
                  .pitchY = 3.0_nm,
                  .heights = {},
                  .invalid = {}};
    for (int i = 0; i < 32 * 32; ++i) {
        map.heights.push_back(0.1_nm * (i * 7 % 11));
    }
    return map;
}

class Names : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        std::filesystem::create_directory(folder);
        const std::string plain =
            "H_of_nine";  // our writer would take the other one's characters away
        writeHeightMap(scan, bumps(), {.title = plain});
        std::string bytes = test::contentOf(scan);
        bytes.replace(bytes.find(plain), plain.size(), kChannel);
        std::ofstream(scan, std::ios::binary) << bytes;
    }

    [[nodiscard]] static std::string quoted(const std::filesystem::path& path) {
        return "'" + path.string() + "'";
    }

    test::ScratchFolder scratch;
    std::filesystem::path folder = scratch.path() / GetParam();
    std::filesystem::path scan = folder / (GetParam() + ".gsf");
};

TEST_P(Names, InfoShowsThemAndItsJsonIsValid) {
    const auto shown = test::runProgram("info " + quoted(scan));
    EXPECT_EQ(shown.exitCode, 0);
    EXPECT_TRUE(obeysNothing(shown.output)) << shown.output;
    const auto json = test::runProgram("info --json " + quoted(scan));
    EXPECT_TRUE(obeysNothing(json.output)) << json.output;
    const auto info = nlohmann::json::parse(json.output);
    EXPECT_EQ(info["channels"][0]["name"], kChannel);
}

TEST_P(Names, ConvertReadsAndWritesThem) {
    for (const char* extension : {".gwy", ".exr", ".png", ".tiff", ".txt", ".vti", ".stl"}) {
        const std::filesystem::path out = folder / (GetParam() + extension);
        const auto run = test::runProgram("convert " + quoted(scan) + " " + quoted(out));
        EXPECT_EQ(run.exitCode, 0) << run.output;
        EXPECT_TRUE(obeysNothing(run.output)) << run.output;
        EXPECT_TRUE(std::filesystem::exists(out)) << extension;
    }
}

TEST_P(Names, ErrorsShowThem) {
    const std::filesystem::path broken = scratch.write(GetParam() + "2.gsf", "no scan");
    for (const std::string& arguments :
         {"info " + quoted(broken), "info " + quoted(folder), "extra " + quoted(scan),
          "info " + quoted(scan) + " " + quoted(scan),
          "convert " + quoted(scan) + " " + quoted(folder / "none")}) {
        const auto run = test::runProgram(arguments);
        EXPECT_NE(run.exitCode, 0) << arguments;
        EXPECT_TRUE(obeysNothing(run.output)) << run.output;
    }
}

TEST_P(Names, ARunIsWholeAndReplays) {
    const std::filesystem::path run = folder / "run";
    const auto explored =
        test::runProgram("explore " + quoted(scan) + " --duration 0.1 --out " + quoted(run));
    ASSERT_EQ(explored.exitCode, 0) << explored.output;
    for (const char* file : {"summary.json", "scene.toml", "overview.png", "deformation.png",
                             "forces.png", "deformation.exr"}) {
        EXPECT_TRUE(std::filesystem::exists(run / file)) << file;
    }
    const auto summary = nlohmann::json::parse(test::contentOf(run / "summary.json"));
    EXPECT_EQ(summary["input"]["file"], summary["scene"]["sample"]["file"]);
    const auto again =
        test::runProgram("replay " + quoted(run) + " --out " + quoted(folder / "again"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_NE(again.output.find("bit-identical: 101 ticks"), std::string::npos) << again.output;
}

INSTANTIATE_TEST_SUITE_P(Bytes, Names,
                         ::testing::Values("25 \xB5m", "line\nfeed \x1b[31m\x7f", "a%41 \"b\" \\"),
                         [](const auto& name) { return "Name" + std::to_string(name.index); });

}  // namespace
}  // namespace asperity
