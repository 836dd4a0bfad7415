#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/scene/SceneFile.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

// Scans whose files do not say their size or what their values are.

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kScale = " --size 320x160nm --z-unit nm --z-scale 0.5";

class ScaleRuns : public ::testing::Test {
protected:
    /// 32 x 16 numbers, a wave of 0 to 4.
    [[nodiscard]] std::string bareMatrix() const {
        std::ostringstream text;
        for (int row = 0; row < 16; ++row) {
            for (int column = 0; column < 32; ++column) {
                text << (column % 8 < 4 ? column % 8 : 8 - column % 8) << ' ';
            }
            text << '\n';
        }
        return scratch.write("bare matrix.txt", text.str()).string();
    }
    [[nodiscard]] std::string quoted(const std::string& path) const { return " '" + path + "'"; }
    [[nodiscard]] std::string out(const std::string& name) const {
        return quoted(scratch.file(name).string());
    }
    /// Each command whose input is a height map, but `info`, which shows what is unknown, too.
    [[nodiscard]] std::vector<std::string> commands(const std::string& scan) const {
        const auto points = scratch.write("points.csv", "x_m,y_m,z_m\n1e-8,1e-8,1e-8\n");
        return {"convert" + quoted(scan) + out("out.gsf"),
                "explore" + quoted(scan) + " --duration 0.2 --out" + out("explored"),
                "loop" + quoted(scan) + " --duration 0.3",
                "project" + quoted(scan) + " --points " + points.string() + " --out" +
                    out("feet.csv")};
    }

    test::ScratchFolder scratch;
};

TEST_F(ScaleRuns, WithoutAScaleEachCommandNamesTheOptionsThatGiveIt) {
    std::vector<std::string> calls = commands(bareMatrix());
    calls.push_back("tradeoff" + quoted(bareMatrix()) + " --out" + out("table"));
    calls.push_back(quoted(bareMatrix()));
    for (const std::string& call : calls) {
        const auto run = test::runProgram(call, "DISPLAY=");
        EXPECT_EQ(run.exitCode, 3) << call << "\n" << run.output;
        EXPECT_THAT(run.output, AllOf(HasSubstr("bare matrix.txt: channel 'matrix': "),
                                      HasSubstr("--size"), HasSubstr("--z-unit")))
            << call;
    }
}

TEST_F(ScaleRuns, WithTheScaleEachCommandIsDone) {
    for (const std::string& call : commands(bareMatrix())) {
        const auto run = test::runProgram(call + kScale);
        EXPECT_EQ(run.exitCode, 0) << call << "\n" << run.output;
    }
}

TEST_F(ScaleRuns, OptionsThatAreNoneAreWrongUsage) {
    for (const std::string option : {"--size large", "--size 5umx2", "--size 0", "--z-unit V",
                                     "--z-scale 0", "--z-scale nan", "--z-scale -2"}) {
        for (const std::string command : {"info x", "convert x y.gsf", "explore x --out y",
                                          "loop x", "tradeoff x --out y", "x.gsf"}) {
            const auto run = test::runProgram(command + " " + option, "DISPLAY=");
            EXPECT_EQ(run.exitCode, 2) << command << " " << option << "\n" << run.output;
            EXPECT_THAT(run.output, HasSubstr(option.substr(0, option.find(' '))));
        }
    }
}

TEST_F(ScaleRuns, ConvertWritesTheValuesTimesTheScale) {
    const auto run = test::runProgram("convert" + quoted(bareMatrix()) + out("out.gwy") + kScale);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, AllOf(HasSubstr("size 320 nm x 160 nm as given"),
                                  HasSubstr("heights of 5e-10 m each as given")));
    const ScanChannel channel = readHeightMapFile(scratch.file("out.gwy")).channels.at(0);
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 10e-9);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 10e-9);
    for (int column = 0; column < 8; ++column) {
        const double value = column < 4 ? column : 8 - column;
        EXPECT_EQ(channel.map.heights.at(static_cast<std::size_t>(column)), value * (0.5 * 1e-9));
    }
}

TEST_F(ScaleRuns, InfoShowsWhatIsUnknownAndWhatIsGiven) {
    const auto unknown = test::runProgram("info --json" + quoted(bareMatrix()));
    ASSERT_EQ(unknown.exitCode, 0) << unknown.output;
    EXPECT_FALSE(nlohmann::json::parse(unknown.output)["channels"][0]["size_known"]);
    const auto given = test::runProgram("info --json" + quoted(bareMatrix()) + kScale);
    const auto channel = nlohmann::json::parse(given.output)["channels"][0];
    EXPECT_TRUE(channel["size_known"]);
    EXPECT_EQ(channel["unit"], "m");
    EXPECT_DOUBLE_EQ(channel["size_x_m"], 320e-9);
    EXPECT_EQ(channel["max"], 4 * (0.5 * 1e-9));
}

/// Nothing is shown of a scan whose heights cannot be.
TEST_F(ScaleRuns, AScaleThatNoInstrumentHasIsRefusedInOneSentence) {
    for (const char* command : {"info", "info --json"}) {
        const auto run =
            test::runProgram(command + quoted(bareMatrix()) + " --z-unit m --z-scale 1e4");
        EXPECT_EQ(run.exitCode, 3);
        EXPECT_TRUE(run.output.starts_with("asperity: ")) << run.output;
        EXPECT_THAT(run.output, HasSubstr("its unit or scale is wrong"));
    }
}

TEST_F(ScaleRuns, AShapeHasNoScaleToBeGiven) {
    const auto run = test::runProgram("loop " + test::shippedScene("sphere").string() +
                                      " --duration 0.3 --size 1um");
    EXPECT_EQ(run.exitCode, 3) << run.output;
    EXPECT_THAT(run.output, HasSubstr("a scene with a shape has no height map"));
}

/// A scene file says the scale, too; an option overrules it.
TEST_F(ScaleRuns, ASceneSaysTheScale) {
    (void)bareMatrix();
    const auto scene = scratch.write("scene.toml", "[sample]\nfile = \"bare matrix.txt\"\n"
                                                   "size_x_m = 320e-9\nsize_y_m = 160e-9\n"
                                                   "z_scale_m = 0.5e-9\n");
    const auto byScene = test::runProgram("explore --no-pictures " + scene.string() +
                                          " --duration 0.2 --out" + out("scene"));
    ASSERT_EQ(byScene.exitCode, 0) << byScene.output;
    const auto byOptions = test::runProgram("explore" + quoted(bareMatrix()) +
                                            " --duration 0.2 --out" + out("options") + kScale);
    ASSERT_EQ(byOptions.exitCode, 0) << byOptions.output;
    const auto overruled = test::runProgram("explore --no-pictures " + scene.string() +
                                            " --duration 0.2 --size 64x32nm --out" + out("other"));
    ASSERT_EQ(overruled.exitCode, 0) << overruled.output;
    EXPECT_EQ(test::contentOf(scratch.file("scene") / "force_log.csv"),
              test::contentOf(scratch.file("options") / "force_log.csv"));
    const auto summary =
        nlohmann::json::parse(test::contentOf(scratch.file("other") / "summary.json"));
    EXPECT_DOUBLE_EQ(summary["input"]["size_x_m"], 64e-9);
}

/// Whatever the command, the recorded scene knows the scale.
TEST_F(ScaleRuns, ARecordingReplaysBitIdentical) {
    for (const std::string& call :
         {"explore" + quoted(bareMatrix()) + " --duration 0.2 --out" + out("explore"),
          "loop" + quoted(bareMatrix()) + " --duration 1.2 --record" + out("loop")}) {
        const std::string name = call.substr(0, call.find(' '));
        const auto made = test::runProgram(call + kScale);
        ASSERT_EQ(made.exitCode, 0) << made.output;
        const auto run = scratch.file(name);
        EXPECT_EQ(readScene(run / "scene.toml").sample.scale,
                  (GivenScale{320 * 1e-9, 160 * 1e-9, 0.5 * 1e-9}));
        const auto summary = nlohmann::json::parse(test::contentOf(run / "summary.json"));
        EXPECT_EQ(summary["scene"]["sample"]["size_x_m"], 320 * 1e-9);
        EXPECT_EQ(summary["scene"]["sample"]["z_scale_m"], 0.5 * 1e-9);
        EXPECT_THAT(summary["input"]["notes"].dump(), AllOf(HasSubstr("320 nm x 160 nm as given"),
                                                            HasSubstr("5e-10 m each as given")));
        const auto again = test::runProgram("replay" + out(name) + " --out" + out(name + " again"));
        EXPECT_EQ(again.exitCode, 0) << again.output;
        EXPECT_THAT(again.output, HasSubstr("bit-identical: "));
        EXPECT_EQ(test::contentOf(run / "force_log.csv"),
                  test::contentOf(scratch.file(name + " again") / "force_log.csv"));
    }
}

TEST_F(ScaleRuns, RealFilesOfUnknownScaleOpenByOptions) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const std::string name :
         {"derived/cl0_height_u16_noscale.png", "text/matrix-5_plain.txt", "text/xyz-1.txt",
          "igor/10x10-one_channel_without_name.ibw", "gwy/gwyfile_test_no_units.gwy"}) {
        const std::string call = "convert" + quoted(test::sharedData("afm/" + name).string()) +
                                 " --force" + out("out.gsf");
        const auto without = test::runProgram(call);
        EXPECT_EQ(without.exitCode, 3) << name << "\n" << without.output;
        EXPECT_THAT(without.output, HasSubstr("--z-unit")) << name;
        const auto with = test::runProgram(call + " --size 1um --z-unit pm");
        EXPECT_EQ(with.exitCode, 0) << name << "\n" << with.output;
    }
}

}  // namespace
}  // namespace asperity
