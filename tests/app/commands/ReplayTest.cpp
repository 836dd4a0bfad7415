#include "core/io/FileBytes.h"
#include "core/io/FormerKeys.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/zip/ZipArchive.h"
#include "tests/app/ProgramRun.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {
namespace {

using std::filesystem::copy_options;

/// A run with the data of its scene, made when the first test needs it: each has a copy of the run.
const std::filesystem::path& madeOnce() {
    static const test::ScratchFolder scratch;
    static const std::filesystem::path folder = [] {
        std::filesystem::copy(test::shippedScene("polystyrene").parent_path().parent_path(),
                              scratch.path() / "data", copy_options::recursive);
        (void)test::runProgram("explore --no-pictures " +
                               (scratch.path() / "data/scenes/polystyrene.toml").string() +
                               " --duration 0.5 --out " + scratch.file("run").string());
        return scratch.path();
    }();
    return folder;
}

void expectCurrentNames(const std::filesystem::path& file) {
    const std::string text = test::contentOf(file);
    EXPECT_FALSE(text.empty()) << file;
    for (const auto& [former, current] : kFormerKeys) {
        EXPECT_EQ(text.find(former), std::string::npos) << file << ": " << former;
    }
}

class Replay : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(std::filesystem::exists(madeOnce() / "run/summary.json"));
        std::filesystem::copy(madeOnce() / "run", run, copy_options::recursive);
    }

    [[nodiscard]] test::ProgramRun replay() const {
        return test::runProgram("replay " + run.string() + " --out " +
                                scratch.file("again").string());
    }

    /// Changes one cell of a table of the run.
    void alter(std::size_t row, const std::string& column, const std::string& value,
               const char* file = "tick_input.csv") {
        std::stringstream text(test::contentOf(run / file));
        std::ofstream out(run / file);
        std::vector<std::string> names;
        std::size_t tick = 0;
        for (std::string line; std::getline(text, line);) {
            if (line.front() != '#') {
                if (names.empty()) {
                    names = split(line);
                } else if (tick++ == row) {
                    line = withCell(split(line), names, column, value);
                }
            }
            out << line << '\n';
        }
    }

    test::ScratchFolder scratch;
    std::filesystem::path run = scratch.path() / "run";

private:
    static std::vector<std::string> split(const std::string& line) {
        std::vector<std::string> cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) {
            cells.push_back(cell);
        }
        return cells;
    }

    static std::string withCell(std::vector<std::string> cells,
                                const std::vector<std::string>& names, const std::string& column,
                                const std::string& value) {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            line += (i > 0 ? "," : "") + (names[i] == column ? value : cells[i]);
        }
        return line;
    }
};

TEST_F(Replay, IsBitIdentical) {
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_NE(again.output.find("bit-identical: 501 ticks"), std::string::npos) << again.output;
    EXPECT_EQ(test::contentOf(run / "force_log.csv"),
              test::contentOf(scratch.path() / "again/force_log.csv"));
    for (const char* name : {"scene.toml", "tick_input.csv", "force_log.csv", "summary.json"}) {
        expectCurrentNames(run / name);
    }
}

/// The law of a sphere, too: silicone rubber has it, and its log says where the sample is curved.
TEST(ReplayOfShippedScenes, IsBitIdentical) {
    const test::ScratchFolder scratch;
    for (const char* scene : {"silicon", "silicon_oxide", "silicone_rubber", "sphere"}) {
        const auto run = scratch.file(scene);
        const auto made =
            test::runProgram("explore --no-pictures " + test::shippedScene(scene).string() +
                             " --duration 0.3 --out " + run.string());
        ASSERT_EQ(made.exitCode, 0) << made.output;
        const auto again = test::runProgram("replay " + run.string() + " --out " +
                                            scratch.file(std::string(scene) + "_again").string());
        EXPECT_NE(again.output.find("bit-identical: 301 ticks"), std::string::npos)
            << scene << ": " << again.output;
    }
}

/// It did not know the flag `strength_limited`.
TEST(ReplayOfAnEarlierProgram, IsBitIdenticalButForFlags) {
    const test::ScratchFolder scratch;
    const auto again =
        test::runProgram("replay " + test::referenceFolder().string() +
                         "/recordings/sphere --out " + scratch.file("again").string());
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.output.find("bit-identical but for flags: 201 ticks"), std::string::npos)
        << again.output;
    EXPECT_NE(again.output.find("was elastic_limit, is now elastic_limit|strength_limited"),
              std::string::npos)
        << again.output;
}

/// Unpacks a bundle as any other program does.
void unpack(const std::filesystem::path& bundle, const std::filesystem::path& folder) {
    const FileBytes bytes(bundle);
    const ZipArchive archive(bytes);
    for (const ZipEntry& entry : archive.entries()) {
        std::filesystem::create_directories((folder / entry.name).parent_path());
        std::ofstream(folder / entry.name, std::ios::binary)
            << archive.decoded(entry, std::uint64_t{1} << 22U);
    }
}

/// Runs of the program as it was when columns, keys and flags said foot and hand: one in the
/// compact format, one as text that begins in contact, so with a memory.
class ReplayOfFormerNames : public testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] std::string bundle() const {
        return (test::referenceFolder() / "recordings" / GetParam()).string();
    }
    [[nodiscard]] std::string in(const std::string& name) const {
        return scratch.file(name).string();
    }

    test::ScratchFolder scratch;
};

INSTANTIATE_TEST_SUITE_P(Bundles, ReplayOfFormerNames,
                         testing::Values("valley.zip", "valley_part.zip"), [](const auto& one) {
                             return std::string(one.param, std::string_view(one.param).find('.'));
                         });

TEST_P(ReplayOfFormerNames, IsBitIdentical) {
    const auto again = test::runProgram("replay " + bundle() + " --out " + in("again"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_NE(again.output.find("bit-identical: "), std::string::npos) << again.output;
    const CsvTable log = readCsv(scratch.file("again") / "force_log.csv");
    EXPECT_TRUE(log.has("device_fz_n"));
    bool areSeveral = false;
    for (std::size_t row = 0; row < log.rows(); ++row) {
        areSeveral = areSeveral ||
                     log.text(row, "flags").find("several_contact_points") != std::string::npos;
    }
    EXPECT_TRUE(areSeveral);
}

/// A part is written with current names only, and replays.
TEST_P(ReplayOfFormerNames, PutsNoneOfThemIntoWhatIsWritten) {
    const auto part =
        test::runProgram("bundle " + bundle() + " " + in("part.zip") + " --from 0.005 --to 0.045");
    ASSERT_EQ(part.exitCode, 0) << part.output;
    const auto again = test::runProgram("replay " + in("part.zip") + " --out " + in("again"));
    EXPECT_NE(again.output.find("bit-identical: 41 ticks"), std::string::npos) << again.output;
    unpack(scratch.file("part.zip"), scratch.file("part"));
    for (const char* name :
         {"scene.toml", "tick_memory.csv", "tick_input.csv", "force_log.csv", "summary.json"}) {
        expectCurrentNames(scratch.file("part") / name);
    }
}

TEST_P(ReplayOfFormerNames, ConvertsThemToTheCurrentOnes) {
    unpack(bundle(), scratch.file("run"));
    std::string last = "run";
    for (const std::string format : {"h5", "csv"}) {
        const auto converted =
            test::runProgram("convert " + in(last) + " " + in(format) + " --format " + format);
        if (last == "run" && format == "h5" && converted.exitCode == 1) {
            continue;  // it is compact already
        }
        ASSERT_EQ(converted.exitCode, 0) << converted.output;
        std::filesystem::copy(scratch.file("run") / "scan", scratch.file(format) / "scan");
        const auto again =
            test::runProgram("replay " + in(format) + " --out " + in("again_" + format));
        EXPECT_EQ(again.exitCode, 0) << again.output;
        last = format;
    }
    for (const char* name : {"tick_input.csv", "force_log.csv"}) {
        expectCurrentNames(scratch.file("csv") / name);
    }
}

TEST(ReplayOfFormerFlags, NamesOneThatIsAnother) {
    const test::ScratchFolder scratch;
    const std::filesystem::path run = scratch.file("run");
    unpack(test::referenceFolder() / "recordings/valley_part.zip", run);
    std::string log = test::contentOf(run / "force_log.csv");
    const std::string flag = "several_feet";
    ASSERT_NE(log.find(flag), std::string::npos);
    log.replace(log.find(flag), flag.size(), "sharp_valley");
    std::ofstream(run / "force_log.csv") << log;
    const auto again =
        test::runProgram("replay " + run.string() + " --out " + scratch.file("again").string());
    EXPECT_EQ(again.exitCode, 1) << again.output;
    EXPECT_NE(again.output.find("bit-identical but for flags: 51 ticks; first differing tick: 0 "),
              std::string::npos)
        << again.output;
}

TEST_F(Replay, ComparesALogFromBeforeItsLastColumnWasAdded) {
    std::stringstream text(test::contentOf(run / "force_log.csv"));
    std::ofstream out(run / "force_log.csv");
    for (std::string line; std::getline(text, line);) {
        out << (line.front() == '#' ? line : line.substr(0, line.rfind(','))) << '\n';
    }
    out.close();
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_NE(again.output.find("bit-identical: 501 ticks"), std::string::npos) << again.output;
}

TEST_F(Replay, NamesTheTickOfAnAlteredDeviceSample) {
    alter(217, "device_z_m", "1.0000000001e-8");
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.output.find("first differing tick: 217 "), std::string::npos) << again.output;
}

TEST_F(Replay, SaysThatFlagsAloneDiffer) {
    alter(100, "flags", "thin_film", "force_log.csv");
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(
        again.output.find("bit-identical but for flags: 501 ticks; first differing tick: 100 "),
        std::string::npos)
        << again.output;
}

TEST_F(Replay, NamesAnAlteredForceAfterAnAlteredFlag) {
    alter(100, "flags", "thin_film", "force_log.csv");
    alter(217, "device_z_m", "1.0000000001e-8");
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_EQ(again.output.find("but for flags"), std::string::npos) << again.output;
    EXPECT_NE(again.output.find("first differing tick: 217 "), std::string::npos) << again.output;
}

TEST_F(Replay, NamesTheTickOfAnAlteredSetting) {
    alter(333, "force_gain", "1.0000001");
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.output.find("first differing tick: 333 "), std::string::npos) << again.output;
    EXPECT_NE(again.output.find("device_f"), std::string::npos) << "names the column";
}

TEST_F(Replay, NamesTheFirstTickAfterAnAlteredScene) {
    std::string scene = test::contentOf(run / "scene.toml");
    const std::string key = "work_of_adhesion_j_m2 = 0.066";
    ASSERT_NE(scene.find(key), std::string::npos);
    scene.replace(scene.find(key), key.size(), "work_of_adhesion_j_m2 = 0.067");
    std::ofstream(run / "scene.toml") << scene;
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.output.find("first differing tick: "), std::string::npos) << again.output;
}

TEST_F(Replay, NamesASettingThatWasAlteredInTheScene) {
    for (const char* key : {"correction_hz", "force_gain", "rate_hz"}) {
        const std::string original = test::contentOf(run / "scene.toml");
        std::string altered = original;
        const std::size_t value = altered.find(std::string(key) + " = ") + std::string(key).size();
        altered.insert(value + 3, "1");
        std::ofstream(run / "scene.toml") << altered;
        const auto again = replay();
        EXPECT_EQ(again.exitCode, 1) << again.output;
        EXPECT_NE(again.output.find(key), std::string::npos) << again.output;
        std::ofstream(run / "scene.toml") << original;
    }
}

TEST_F(Replay, RefusesKnobsThatNoSceneMayHave) {
    const std::vector<std::pair<const char*, const char*>> knobs{{"coupling_stiffness_n_m", "-600"},
                                                                 {"coupling_damping_n_s_m", "1e7"},
                                                                 {"proxy_damping_n_s_m", "-3"},
                                                                 {"max_force_n", "nan"},
                                                                 {"engage_s", "0"},
                                                                 {"max_device_speed_m_s", "inf"},
                                                                 {"position_gain", "0"},
                                                                 {"force_gain", "-1"}};
    for (const auto& [column, value] : knobs) {
        const std::string original = test::contentOf(run / "tick_input.csv");
        alter(333, column, value);
        const auto again = replay();
        EXPECT_EQ(again.exitCode, 3) << again.output;
        for (const char* part : {"tick_input.csv", "line 337", column}) {
            EXPECT_NE(again.output.find(part), std::string::npos) << again.output;
        }
        std::ofstream(run / "tick_input.csv") << original;
    }
}

TEST_F(Replay, RefusesAScanThatHasChanged) {
    const auto scan = madeOnce() / "data/samples/particles.gsf";
    const std::string original = test::contentOf(scan);
    std::string bytes = original;
    bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
    std::ofstream(scan, std::ios::binary) << bytes;
    const auto again = replay();
    std::ofstream(scan, std::ios::binary) << original;
    EXPECT_EQ(again.exitCode, 3);
    EXPECT_NE(again.output.find("has changed"), std::string::npos) << again.output;
}

/// No tick is the same, and none is to blame. Why is not known.
TEST_F(Replay, NamesASizeThatIsAnother) {
    auto summary = nlohmann::json::parse(test::contentOf(run / "summary.json"));
    summary["input"]["size_y_m"] = 2.0 * summary["input"]["size_y_m"].get<double>();
    std::ofstream(run / "summary.json") << summary;
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 3) << again.output;
    EXPECT_NE(again.output.find("when the run was recorded, and is now read as"), std::string::npos)
        << again.output;
    EXPECT_EQ(again.output.find("correction"), std::string::npos) << again.output;
    EXPECT_EQ(again.output.find("first differing tick"), std::string::npos);
}

/// It was taken as it was, whatever the manifest of the recording said.
TEST_F(Replay, RefusesASizeThatNoScanHas) {
    std::filesystem::remove(run / "summary.json");
    for (const char* size : {"0", "-1e-6"}) {
        std::ofstream(run / "recording.json")
            << R"({"format": "asperity recording", "format_version": 1, "complete": true, )"
            << R"("recovered": false, "input": {"sha256": "", "size_x_m": 1e-6, "size_y_m": )"
            << size << "}}";
        const auto again = replay();
        EXPECT_EQ(again.exitCode, 3) << again.output;
        EXPECT_EQ(again.output,
                  "asperity: " + (run / "recording.json").string() +
                      ": input.size_y_m: expected the size of a scan in meters, above 0; the file "
                      "is damaged\n");
    }
}

/// A run on a NanoScope scan that is not square, of 30 nm x 13.3 nm, or on a part of it.
class ReplayOfANanoscopeScan : public testing::Test {
protected:
    void explore(const std::string& options) {
        std::vector<std::int32_t> counts;
        for (int i = 0; i < 24 * 16; ++i) {
            counts.push_back(i * 7919 % 11);
        }
        const auto scan =
            scratch.write("scan.spm", test::nanoscopeFile({.samples = "24",
                                                           .lines = "16",
                                                           .dataLength = "768",
                                                           .scanGrid = "\\Aspect Ratio: 3:2\r\n"},
                                                          counts));
        const auto made = test::runProgram("explore --no-pictures " + scan.string() +
                                           " --duration 0.1 --out " + run.string() + options);
        ASSERT_EQ(made.exitCode, 0) << made.output;
    }
    void changeSummary(const std::function<void(nlohmann::json& input)>& change) {
        auto summary = nlohmann::json::parse(test::contentOf(run / "summary.json"));
        change(summary["input"]);
        std::ofstream(run / "summary.json") << summary;
    }
    /// A recording that was cut off does not say with which size its scan was read.
    void cutOff() {
        const auto summary = nlohmann::json::parse(test::contentOf(run / "summary.json"));
        std::filesystem::remove(run / "summary.json");
        std::ofstream(run / "recording.json")
            << nlohmann::json{{"format", "asperity recording"},
                              {"format_version", 1},
                              {"input", {{"sha256", summary["input"]["sha256"]}}},
                              {"complete", false},
                              {"recovered", false}};
        std::string log = test::contentOf(run / "force_log.csv");
        const std::size_t line = log.find("\n0.0500");
        ASSERT_NE(line, std::string::npos);
        log.insert(log.find(',', log.find(',', line + 1) + 1), "1");
        std::ofstream(run / "force_log.csv") << log;
    }
    void expectCorrection(const test::ProgramRun& call) {
        EXPECT_EQ(call.exitCode, 1);
        EXPECT_NE(call.output.find("the size along y of NanoScope scans that are not square has "
                                   "been corrected; the scan is now read as 30 nm x 13.3 nm"),
                  std::string::npos)
            << call.output;
        EXPECT_NE(call.output.find("first differing tick: 50"), std::string::npos) << call.output;
    }
    test::ProgramRun replay() {
        return test::runProgram("replay " + run.string() + " --out " +
                                scratch.file("again").string());
    }
    test::ProgramRun bundle() {
        return test::runProgram("bundle " + run.string() + " " + scratch.file("a.zip").string());
    }

    test::ScratchFolder scratch;
    std::filesystem::path run = scratch.file("run");
};

/// The reader was wrong when the run was made.
TEST_F(ReplayOfANanoscopeScan, NamesASizeThatWasCorrected) {
    explore("");
    changeSummary([](nlohmann::json& input) { input["size_y_m"] = input["size_x_m"]; });
    for (const auto& call : {replay(), bundle()}) {
        EXPECT_EQ(call.exitCode, 3) << call.output;
        EXPECT_NE(call.output.find("and is now read as 30 nm x 13.3 nm, after a correction of the "
                                   "reader: the run does not replay"),
                  std::string::npos)
            << call.output;
    }
}

TEST_F(ReplayOfANanoscopeScan, NamesASizeThatTheSceneGives) {
    explore(" --size 30x20nm");
    changeSummary([](nlohmann::json& input) { input["size_y_m"] = input["size_x_m"]; });
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 3) << again.output;
    EXPECT_NE(again.output.find("and is now read as 30 nm x 20 nm, by the size in scene.toml: "),
              std::string::npos)
        << again.output;
}

TEST_F(ReplayOfANanoscopeScan, NamesACorrectionThatIsKnownWhereItWasCutOff) {
    explore("");
    cutOff();
    expectCorrection(replay());
    expectCorrection(bundle());
}

/// The part is a square, the scan is not.
TEST_F(ReplayOfANanoscopeScan, NamesTheCorrectionWhateverThePart) {
    explore(" --crop 2,2,8,12");
    cutOff();
    expectCorrection(replay());
}

/// No reader gave that size.
TEST_F(ReplayOfANanoscopeScan, NamesNoCorrectionWhereTheSizeWasGiven) {
    explore(" --size 30x20nm");
    cutOff();
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_EQ(again.output.find("corrected"), std::string::npos) << again.output;
    EXPECT_NE(again.output.find("first differing tick: 50"), std::string::npos) << again.output;
}

TEST_F(Replay, RefusesWhatIsNoRunAndToOverwriteTheRun) {
    const auto onto = test::runProgram("replay " + run.string() + " --out " + run.string());
    EXPECT_EQ(onto.exitCode, 1) << onto.output;
    const auto none = test::runProgram("replay " + scratch.path().string() + " --out " +
                                       scratch.file("again").string());
    EXPECT_EQ(none.exitCode, 3) << none.output;
}

/// A damaged log is named, not the hidden one that it is compared with.
TEST_F(Replay, NamesTheLogWithAColumnThatNoneHas) {
    std::string log = test::contentOf(run / "force_log.csv");
    log.replace(log.find("est_fz_n"), 8, "est_fq_n");
    std::ofstream(run / "force_log.csv") << log;
    const auto again = replay();
    EXPECT_EQ(again.exitCode, 3) << again.output;
    EXPECT_NE(again.output.find((run / "force_log.csv").string() + ": column est_fq_n: "),
              std::string::npos)
        << again.output;
}

}  // namespace
}  // namespace asperity
