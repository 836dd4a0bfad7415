#include "core/io/tables/CsvTable.h"
#include "core/scene/ModelTerm.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace asperity {
namespace {

TEST(Usage, EverySubcommandHasHelp) {
    const auto overview = test::runProgram("--help");
    EXPECT_EQ(overview.exitCode, 0);
    for (const std::string command :
         {"explore", "info", "convert", "contact", "curve", "fit", "decouple", "tradeoff",
          "extremes", "replay", "report", "loop", "bench", "devices"}) {
        EXPECT_NE(overview.output.find("\n  " + command + " "), std::string::npos) << command;
        const auto run = test::runProgram(command + " --help");
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_NE(run.output.find("Usage"), std::string::npos) << run.output;
    }
}

TEST(Usage, WrongCallsExitWith2) {
    for (const std::string call : {"fly",
                                   "loop --rate 1",
                                   "bench nothing",
                                   "loop --duration nan",
                                   "devices now",
                                   "explore",
                                   "explore x.gsf",
                                   "explore a --out b --duration -1",
                                   "explore a --out b --duration x",
                                   "explore a --out b --duration nan",
                                   "explore a --out ''",
                                   "replay a --out ''",
                                   "report",
                                   "report a",
                                   "report a --out ''",
                                   "explore a --out b --level flat",
                                   "a.gsf --level flat",
                                   "map",
                                   "map a",
                                   "map a --out b.tif",
                                   "map a --out b.gwy --grid 8",
                                   "map a --out b.gwy --region 0,0,1e-9",
                                   "map a --out b.gwy --mode tapping",
                                   "map a --out b.gwy --threads 0",
                                   "map a --out b.gwy --resume --force",
                                   "measure",
                                   "explore a --out b --setpoint 5nm",
                                   "explore a --out b --setpoint 5",
                                   "explore a --out b --setpoint x",
                                   "explore a --out b --setpoint -5nN",
                                   "explore a --out b --path slide --setpoint 5nN",
                                   "info",
                                   "extremes",
                                   "extremes --out a --states 10",
                                   "convert a b.gsf --residual --smoothing-px nan",
                                   "convert a b.gsf --residual --smoothing-m nan",
                                   "convert a b.gsf --residual --smoothing-m inf",
                                   "project a --points b --sigma nan"}) {
        const auto run = test::runProgram(call);
        EXPECT_EQ(run.exitCode, 2) << call << "\n" << run.output;
    }
}

TEST(Usage, UnreadableInputExitsWith3AndOneSentence) {
    const test::ScratchFolder scratch;
    const auto noise = scratch.write("noise.gsf", "this is no scan");
    const auto scene = scratch.write("scene.toml", "[sample]\nfile = \"none.gsf\"\n");
    const std::string out = " --out " + scratch.file("out").string();
    const std::vector<std::string> calls = {
        "info " + noise.string(),
        "info /nonexistent",
        noise.string(),
        "/nonexistent.gsf",
        "loop " + noise.string(),
        "explore " + noise.string() + out,
        "explore " + scene.string() + out,
        "tradeoff " + noise.string() + out,
        "explore " + test::shippedScene("silicon").string() + " --path /nonexistent.csv" + out,
        "explore " + test::shippedScene("silicon").string() + " --channel Nothing" + out};
    for (const std::string& call : calls) {
        const auto run = test::runProgram(call);
        EXPECT_EQ(run.exitCode, 3) << call << "\n" << run.output;
        const std::size_t message = run.output.find("asperity: ");
        ASSERT_NE(message, std::string::npos) << run.output;
        EXPECT_EQ(run.output.find('\n', message), run.output.size() - 1) << run.output;
    }
}

TEST(Usage, WithoutADisplayTheWindowReadsItsInputFirst) {
    const test::ScratchFolder scratch;
    for (const std::string& file : {std::string("/nonexistent.gsf"),
                                    scratch.write("noise.gsf", "this is no scan").string()}) {
        const auto run = test::runProgram(file, "DISPLAY=");
        EXPECT_EQ(run.exitCode, 3) << run.output;
        EXPECT_NE(run.output.find(file), std::string::npos) << run.output;
    }
}

TEST(Usage, TheWindowTakesTheChannelThatIsNamed) {
    const std::string scan = test::dataFolder().string() + "/samples/steps.gsf";
    const auto run = test::runProgram(scan + " --channel Phase", "DISPLAY=");
    EXPECT_EQ(run.exitCode, 3) << run.output;
    EXPECT_NE(run.output.find("there is no channel 'Phase'"), std::string::npos) << run.output;
}

TEST(Usage, WithoutADisplayTheWindowSaysWhatWorksInstead) {
    const auto run = test::runProgram(test::shippedScene("silicon").string(), "DISPLAY=");
    EXPECT_EQ(run.exitCode, 1) << run.output;
    EXPECT_NE(run.output.find("asperity explore"), std::string::npos) << run.output;
}

TEST(Usage, TellsHowSoonTheWindowShowsAScan) {
    const test::ScratchFolder home;
    const auto run = test::runCommand("env XDG_CONFIG_HOME=" + home.path().string() +
                                      " XDG_DATA_HOME=" + home.path().string() +
                                      " xvfb-run -a -s '-screen 0 1280x800x24' " +
                                      test::programOfBuild("asperity").string() + " --time-start");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const auto times = nlohmann::json::parse(run.output.substr(run.output.find('{')));
    EXPECT_GT(times.at("window_s"), 0.0);
    EXPECT_GE(times.at("first_picture_s"), times.at("window_s"));
}

TEST(Loop, MeasuresItselfBesideABareLoop) {
    const auto run = test::runProgram("loop --rate 2000 --duration 2.5 --json");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const auto report = nlohmann::json::parse(run.output);
    EXPECT_EQ(report["rate_hz"], 2000.0);
    EXPECT_EQ(report["pairs_of_blocks"], 1);
    EXPECT_GT(report["ticks"], 1000);
    EXPECT_GT(report["bare_loop"]["ticks"], 500);
    EXPECT_GT(report["tick_time"]["p50_s"], 0.0);
    EXPECT_GE(report["tick_time"]["p99_s"], report["tick_time"]["p50_s"]);
    EXPECT_GE(report["lateness"]["largest_s"], report["lateness"]["p99_s"]);
    EXPECT_GT(report["median_block_p99_lateness_ratio"], 0.0);
    EXPECT_FALSE(report.contains("frames_per_second"));
    EXPECT_FALSE(report.contains("recording"));
    EXPECT_EQ(report["duration_s"], 2.5);
    EXPECT_GE(report["elapsed_s"], 2.5);
    EXPECT_EQ(report["block_s"], 1.0);
}

/// "1993 ticks at 1000 Hz" was all that was said of 3 s.
TEST(Loop, SaysWhatItsDurationCovers) {
    const auto run = test::runProgram("loop --duration 0.3");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_NE(run.output.find(": the loop and a bare loop in turn, 1 s each"), std::string::npos)
        << run.output;
    const auto help = test::runProgram("loop --help");
    EXPECT_NE(help.output.find("a bare loop in turn"), std::string::npos) << help.output;
}

/// A recording during a measurement is a run like any other, and its cost is printed.
void expectRecords(const std::string& loop) {
    const test::ScratchFolder folder;
    const std::string recording = folder.file("run").string();
    const auto run =
        test::runProgram(loop + " --duration 2.5 --json --record " + recording, "DISPLAY=");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const auto report = nlohmann::json::parse(run.output.substr(run.output.find('{')));
    const double fetching = report["black_box"]["time_per_tick_s"];
    EXPECT_GT(fetching, 0.0);
    EXPECT_GT(report["recording"]["time_per_tick_s"], fetching);
    const auto replay =
        test::runProgram("replay " + recording + " --out " + folder.file("again").string());
    EXPECT_EQ(replay.exitCode, 0) << replay.output;
}

TEST(Loop, RecordsMeanwhile) { expectRecords("loop"); }

TEST(Loop, RecordsWithTheSimulatedDeviceMeanwhile) { expectRecords("loop --simulated-device"); }

TEST(Loop, RecordsInTheWindowMeanwhile) { expectRecords("loop --window"); }

/// On a machine with other work the first frames can take longer than a short run.
TEST(Loop, DrawsEveryViewMeanwhile) {
    std::string missing;
    for (const char* const duration : {"2.5", "10", "40"}) {
        const auto run = test::runProgram(
            std::string("loop --window --json --duration ") + duration, "DISPLAY=");
        ASSERT_EQ(run.exitCode, 0) << run.output;
        const auto report = nlohmann::json::parse(run.output.substr(run.output.find('{')));
        missing.clear();
        for (const char* const view : {"zoom", "second", "forces", "cantilever", "overview"}) {
            if (!(report["frames_per_second"][view] > 0.0)) {
                missing.append(view).append(" ");
            }
        }
        if (missing.empty()) {
            break;
        }
    }
    EXPECT_EQ(missing, "");
}

/// As a file that cannot be read; a scan that could not be written ended with 1.
TEST(Usage, AFileOrFolderThatCannotBeMadeExitsWith3) {
    const std::string scene = test::shippedScene("silicon").string();
    const std::string scan = test::dataFolder().string() + "/samples/steps.gsf";
    const std::vector<std::string> calls = {
        "explore " + scene + " --duration 0.1 --out /proc/nothing",
        "loop " + scene + " --duration 0.1 --record /proc/nothing",
        "extremes --states 10000 --out /proc/nothing",
        "convert " + scan + " /proc/nothing.gwy",
        "convert " + scan + " /nonexistent/scan.gwy",
        "curve --out /nonexistent/curve.csv",
        "curve --figure /nonexistent/curve.png"};
    for (const std::string& call : calls) {
        const auto run = test::runProgram(call);
        EXPECT_EQ(run.exitCode, 3) << call << "\n" << run.output;
        EXPECT_EQ(run.output.find("force_n"), std::string::npos) << "before it works: " << call;
    }
}

TEST(Info, GivesTheSameInJsonAsTheFileHolds) {
    const auto run = test::runProgram("info --json " +
                                      test::shippedScene("x").parent_path().parent_path().string() +
                                      "/samples/egg_box.gsf");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const nlohmann::json info = nlohmann::json::parse(run.output);
    const nlohmann::json& channel = info["channels"][0];
    EXPECT_NEAR(channel["max"].get<double>() - channel["min"].get<double>(), 1e-8, 1e-10);
    EXPECT_TRUE(channel["corners"]["top_left"].is_number());
    EXPECT_EQ(channel["unit"], "m");
}

TEST(Info, ShowsTheOneChannelThatIsNamed) {
    const std::string scan = test::dataFolder().string() + "/samples/steps.gsf";
    const auto all = test::runProgram("info --json " + scan);
    const auto name = nlohmann::json::parse(all.output)["channels"][0]["name"].get<std::string>();
    const auto one = test::runProgram("info --json " + scan + " --channel '" + name + "'");
    EXPECT_EQ(one.exitCode, 0);
    EXPECT_EQ(one.output, all.output);
    const auto none = test::runProgram("info " + scan + " --channel Phase");
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_NE(none.output.find("there is no channel 'Phase'; there are '" + name + "' (m)"),
              std::string::npos)
        << none.output;
}

/// 10,001 of 10,001 ticks of a run were over pixels that the mask takes out, which nothing said;
/// and the notes were on every channel of the file.
TEST(MaskedScan, IsExploredWhereItHoldsDataWithNotesOnItsOwnChannel) {
    ASPERITY_NEEDS_SHARED_DATA();
    const std::string scan = test::sharedData("afm/derived/frt2_with_mask.gwy").string();
    const auto info = test::runProgram("info " + scan + " --channel 'Intensity (top sensor) 1'");
    EXPECT_EQ(info.exitCode, 0) << info.output;
    EXPECT_EQ(info.output.find("Topography"), std::string::npos) << info.output;
    const test::ScratchFolder scratch;
    for (const std::string path : {"approach", "raster", "scratch"}) {
        const auto out = scratch.file(path);
        const auto run = test::runProgram("explore " + scan + " --duration 1 --path " + path +
                                          " --out " + out.string());
        ASSERT_EQ(run.exitCode, 0) << run.output;
        EXPECT_NE(run.output.find("'Topography"), std::string::npos) << run.output;
        EXPECT_EQ(run.output.find("'Intensity"), std::string::npos) << run.output;
        const auto summary = nlohmann::json::parse(test::contentOf(out / "summary.json"));
        EXPECT_EQ(summary["statistics"]["ticks_flagged"]["filled_pixel"], 0) << path;
    }
}

TEST(Convert, WritesEveryFormatItNames) {
    const test::ScratchFolder scratch;
    const std::string start = "convert " +
                              test::shippedScene("x").parent_path().parent_path().string() +
                              "/samples/egg_box.gsf --level plane ";
    for (const char* name : {"a.gsf", "a.gwy", "a.exr", "a.tiff", "a.png", "a.txt", "a.vti",
                             "a.vtp", "a.vts", "a.stl"}) {
        const auto run = test::runProgram(start + scratch.file(name).string());
        EXPECT_EQ(run.exitCode, 0) << run.output;
        EXPECT_GT(std::filesystem::file_size(scratch.file(name)), 1000U) << name;
    }
}

TEST(Convert, RefusesAnExtensionThatItDoesNotKnow) {
    const test::ScratchFolder scratch;
    const auto run =
        test::runProgram("convert " + test::shippedScene("x").parent_path().parent_path().string() +
                         "/samples/egg_box.gsf " + scratch.file("a.doc").string());
    EXPECT_EQ(run.exitCode, 2) << run.output;
    EXPECT_NE(run.output.find(".gwy"), std::string::npos) << "names what it knows";
}

TEST(TradeOff, WritesATableAndAFigureAndPrintsThem) {
    const test::ScratchFolder scratch;
    const auto run = test::runProgram("tradeoff " + test::shippedScene("polystyrene").string() +
                                      " --out " + scratch.file("out").string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    for (const char* part : {"cheapest within 5 % of the force", "error of the reference",
                             "closed form, 97 x 97", "what the scene requires", "sphere correction",
                             "Pareto-optimal configurations", "the cheapest within 5 %"}) {
        EXPECT_NE(run.output.find(part), std::string::npos) << part;
    }
    const CsvTable table = readCsv(scratch.path() / "out/tradeoff.csv");
    EXPECT_GT(table.rows(), 20U);
    int onFront = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        onFront += table.number(row, "on_front") > 0.0 ? 1 : 0;
    }
    EXPECT_GE(onFront, 1);
    EXPECT_EQ(readCsv(scratch.path() / "out/frames.csv").rows(), 12U);
    EXPECT_EQ(readCsv(scratch.path() / "out/needs.csv").rows(), kModelTerms.size());
    EXPECT_EQ(readCsv(scratch.path() / "out/rates.csv").rows(), 6U);
    EXPECT_GE(readCsv(scratch.path() / "out/compositions.csv").rows(), 3U);
    EXPECT_GT(std::filesystem::file_size(scratch.path() / "out/tradeoff.png"), 5000U);
    const CsvTable deformations = readCsv(scratch.path() / "out/deformation.csv");
    EXPECT_EQ(deformations.rows(), 24U) << "three materials, flat and scan, four deformations";
}

/// The sentences of `asperity extremes` under "refused:", without their counts.
std::vector<std::string> refusalsIn(const std::string& output) {
    std::vector<std::string> sentences;
    const std::string heading = "\nrefused:\n";
    std::istringstream lines(output.substr(output.find(heading) + heading.size()));
    for (std::string line; std::getline(lines, line) && !line.empty();) {
        sentences.push_back(line.substr(line.find("  ", line.find_first_of("0123456789")) + 2));
    }
    return sentences;
}

/// Returns the number of states that `asperity extremes` says it has evaluated.
double statesIn(const std::string& output) {
    const std::size_t end = output.find(" states in ");
    const std::size_t start = output.rfind('\n', end) + 1;
    return std::stod(output.substr(start, end - start));
}

TEST(Extremes, EvaluatesAsManyStatesAsAreAskedForAndRefusesInTheWordsOfItsPage) {
    const test::ScratchFolder scratch;
    const std::filesystem::path out = scratch.file("out");
    std::filesystem::create_directory(out);
    const std::filesystem::path others = scratch.write("out/needs.csv", "of another command");
    const auto run = test::runProgram("extremes --states 10000 --out " + out.string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_GT(readCsv(scratch.path() / "out/extremes.csv").rows(), 100U);
    EXPECT_GT(std::filesystem::file_size(scratch.path() / "out/extremes.png"), 5000U);
    EXPECT_GT(readCsv(scratch.path() / "out/coupling.csv").rows(), 20U);
    EXPECT_GT(std::filesystem::file_size(scratch.path() / "out/coupling.png"), 5000U);
    EXPECT_EQ(test::contentOf(others), "of another command");
    EXPECT_NEAR(statesIn(run.output), 10000.0, 1000.0);
    std::ifstream file(test::dataFolder().string() + "/../docs/extremes.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::vector<std::string> sentences = refusalsIn(run.output);
    EXPECT_GE(sentences.size(), 8U) << run.output;
    for (const std::string& sentence : sentences) {
        EXPECT_NE(page.find("| " + sentence + " |"), std::string::npos) << sentence;
    }
}

}  // namespace
}  // namespace asperity
