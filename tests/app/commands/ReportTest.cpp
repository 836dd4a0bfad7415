#include "tests/app/ProgramRun.h"
#include "tests/app/commands/ReportedPage.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace asperity {
namespace {

using test::ReportedPage;

/// Runs that all tests share: five force cycles on a particle, none, and one of a shape.
class Report : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        shared = std::make_unique<test::ScratchFolder>();
        std::filesystem::copy(test::shippedScene("polystyrene").parent_path().parent_path(),
                              shared->path() / "data", std::filesystem::copy_options::recursive);
    }
    static void TearDownTestSuite() { shared.reset(); }

    // Runs that tests share, each made when the first test needs it.
    /// Three force cycles on a particle.
    static std::filesystem::path touches() {
        return explored("touches", "polystyrene",
                        "--path " + pathOver("touches.csv", {60, 43, 60, 43, 60, 43, 60}));
    }
    /// No force cycle.
    static std::filesystem::path far() {
        return explored("far", "polystyrene", "--path " + pathOver("far.csv", {300, 290, 300}));
    }
    /// One force cycle on a shape.
    static std::filesystem::path sphere() { return explored("sphere", "sphere", "--duration 1"); }

    /// A copy of a run, to be damaged.
    [[nodiscard]] std::filesystem::path copyOf(const std::filesystem::path& run) const {
        std::filesystem::copy(run, scratch.path() / run.filename());
        return scratch.path() / run.filename();
    }
    [[nodiscard]] test::ProgramRun report(const std::string& runs) const {
        return test::runProgram("report " + runs + " --out " + out.string());
    }
    /// A report that is made. @return its page
    [[nodiscard]] ReportedPage pageOf(const std::filesystem::path& run) const {
        const auto made = report(run.string());
        EXPECT_EQ(made.exitCode, 0) << made.output;
        return ReportedPage(out / (run.filename().string() + ".html"));
    }

    static std::unique_ptr<test::ScratchFolder> shared;
    test::ScratchFolder scratch;
    std::filesystem::path out = scratch.path() / "out";

private:
    /// Writes a path above a particle. @param heights [nm] @return its file
    static std::string pathOver(const std::string& name, const std::vector<int>& heights) {
        std::ostringstream text;
        text << "time_s,x_m,y_m,z_m\n";
        for (std::size_t i = 0; i < heights.size(); ++i) {
            text << 0.4 * static_cast<double>(i) << ",6.8e-8,1.783e-7," << heights[i] << "e-9\n";
        }
        return shared->write(name, text.str()).string();
    }
    static std::filesystem::path explored(const std::string& run, const std::string& scene,
                                          const std::string& options) {
        const std::filesystem::path folder = shared->path() / run;
        if (!std::filesystem::exists(folder)) {
            const auto made =
                test::runProgram("explore --no-pictures " +
                                 (shared->path() / "data/scenes" / (scene + ".toml")).string() +
                                 " " + options + " --out " + folder.string());
            EXPECT_EQ(made.exitCode, 0) << made.output;
        }
        return folder;
    }
};

std::unique_ptr<test::ScratchFolder> Report::shared;

/// Returns whether more is known of a reading of a cycle than the noise.
bool isModelKnown(const nlohmann::json& cycle, const std::string& key) {
    const nlohmann::json& budgets = cycle["uncertainty"];
    return budgets.contains(key) && !budgets[key]["model_sigma"].is_null();
}

/// A cycle's text on a reading: noise, model and calibration together where that is known, else
/// the noise. @param noiseKey of the cycle
double sigmaOf(const nlohmann::json& cycle, const std::string& key, const std::string& noiseKey) {
    if (!isModelKnown(cycle, key)) {
        return cycle[noiseKey].get<double>();
    }
    const nlohmann::json& budget = cycle["uncertainty"][key];
    return std::hypot(budget["noise_sigma"].get<double>(), budget["model_sigma"].get<double>());
}

/// A column of the page has what a key of `cycles` has, rounded as it is shown.
/// @param sigmaKey of the noise; empty: the column has no deviation
void expectSame(const ReportedPage& page, const nlohmann::json& cycles, const std::string& title,
                const std::string& key, const std::string& sigmaKey = {}) {
    const std::vector<std::string> cells = page.column(title);
    ASSERT_EQ(cells.size(), cycles.size()) << title;
    const double unit = page.unitOf(title);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto shown = test::shownValue(cells[i]);
        const nlohmann::json& value = cycles[i][key];
        ASSERT_EQ(shown.has_value(), !value.is_null()) << title << ": " << cells[i];
        if (!shown) {
            continue;
        }
        EXPECT_NEAR(shown->value, value.get<double>() / unit, 1.001 * shown->rounding) << title;
        ASSERT_EQ(shown->sigma.has_value(), !sigmaKey.empty()) << title << ": " << cells[i];
        if (shown->sigma) {
            EXPECT_NEAR(*shown->sigma, sigmaOf(cycles[i], key, sigmaKey) / unit,
                        1.001 * shown->sigmaRounding)
                << title;
            EXPECT_EQ(cells[i].find("(noise)") == std::string::npos, isModelKnown(cycles[i], key))
                << cells[i];
        }
    }
}

TEST_F(Report, HasTheNumbersOfTheSummary) {
    const ReportedPage page = pageOf(touches());
    const auto summary = nlohmann::json::parse(test::contentOf(touches() / "summary.json"));
    const nlohmann::json& cycles = summary["cycles"];
    ASSERT_EQ(cycles.size(), 3U);
    expectSame(page, cycles, "time [s]", "touch_s");
    expectSame(page, cycles, "x [", "x_m");
    expectSame(page, cycles, "y [", "y_m");
    expectSame(page, cycles, "max. force", "max_force_n", "max_force_sigma_n");
    expectSame(page, cycles, "max. indentation", "max_indentation_m", "max_indentation_sigma_m");
    expectSame(page, cycles, "snap-in force", "snap_in_force_n", "snap_in_force_sigma_n");
    expectSame(page, cycles, "snap-in at gap", "snap_in_distance_m", "snap_in_distance_sigma_m");
    expectSame(page, cycles, "pull-off force", "pull_off_force_n", "pull_off_force_sigma_n");
    expectSame(page, cycles, "work of adhesion", "adhesion_work_j", "area_sigma_j");
    expectSame(page, cycles, "hysteresis", "hysteresis_j", "area_sigma_j");
}

TEST_F(Report, SaysWhatTheScanIsWhereItWasTouchedAndHowToRepeatIt) {
    const ReportedPage page = pageOf(touches());
    const auto summary = nlohmann::json::parse(test::contentOf(touches() / "summary.json"));
    const std::string sha256 = summary["input"]["sha256"];
    EXPECT_EQ(page.fact("SHA-256"), sha256);
    EXPECT_EQ(page.fact("Channel"), summary["input"]["channel"]);
    EXPECT_EQ(page.fact("Format"), summary["input"]["format"]);
    EXPECT_EQ(page.fact("Size"), "400 nm × 400 nm");
    EXPECT_EQ(page.fact("First contact"), "x = 68 nm, y = 178 nm");
    const std::string text = page.text();
    for (const std::string& part :
         {std::string("asperity replay ") + touches().string() + " --out AGAIN",
          sha256 + "  " + (shared->path() / "data/samples/particles.gsf").string(),
          std::string("bit for bit"), std::string("asperity 0.1.0, compiler ")}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
    for (const auto& entry : summary["input"]["provenance"]) {
        EXPECT_NE(text.find(entry["value"].get<std::string>()), std::string::npos) << entry;
    }
    EXPECT_EQ(page.count("//img"), 2U) << "overview and deformation";
    EXPECT_EQ(page.count("//*[name()='svg']"), 1U);
}

TEST_F(Report, NamesTheSourceOfEachParameter) {
    const ReportedPage page = pageOf(touches());
    const auto names = page.column("Parameter");
    const auto values = page.column("Value");
    const auto sources = page.column("Source");
    const auto expect = [&](const std::string& name, const std::string& value,
                            const std::string& source) {
        const auto found = std::ranges::find(names, name);
        ASSERT_NE(found, names.end()) << name;
        const auto row = static_cast<std::size_t>(found - names.begin());
        EXPECT_EQ(sources.at(row), source) << name;
        EXPECT_EQ(page.text().find(name + " " + value) == std::string::npos, false)
            << name << " " << value;
    };
    expect("Sample: Young's modulus", "2 GPa", "library: polystyrene");
    expect("Sample: Work of adhesion", "66 mJ/m²", "library: polystyrene");
    expect("Lever: Stiffness", "14 N/m", "library: silicon_14_n_m");
    expect("Tip: Radius", "15 nm", "default");
}

TEST_F(Report, SaysOfAnotherTipThatItIsTheScenes) {
    const auto run = scratch.file("tip");
    (void)scratch.write("tip.toml", "[sample]\nshape = \"plane\"\nyoungs_modulus_pa = 3.3e9\n"
                                    "[tip]\nradius_m = 22e-9\n[truth]\nstiffness_n_m = 16.0\n");
    const auto made =
        test::runProgram("explore --no-pictures " + scratch.file("tip.toml").string() +
                         " --duration 1 --out " + run.string());
    ASSERT_EQ(made.exitCode, 0) << made.output;
    const ReportedPage page = pageOf(run);
    const std::string text = page.text();
    EXPECT_NE(text.find("Tip: Radius 22 nm scene"), std::string::npos);
    EXPECT_NE(text.find("Sample: Young's modulus 3.3 GPa scene"), std::string::npos);
    EXPECT_NE(text.find("differs from what the model takes it to be"), std::string::npos);
    EXPECT_NE(text.find("Stiffness 16 N/m 14 N/m"), std::string::npos);
}

TEST_F(Report, OfSeveralRunsListsThemAndLeadsToEach) {
    std::filesystem::create_directory(scratch.file("other"));
    std::filesystem::copy(sphere(), scratch.path() / "other/touches");
    const auto made = report(touches().string() + " " + far().string() + " " +
                             (scratch.path() / "other/touches").string());
    ASSERT_EQ(made.exitCode, 0) << made.output;
    const ReportedPage index(out / "index.html");
    EXPECT_EQ(index.column("Run"), (std::vector<std::string>{"touches", "far", "touches_2"}));
    EXPECT_EQ(index.column("Force cycles"), (std::vector<std::string>{"3", "0", "1"}));
    EXPECT_EQ(index.column("Pull-off force").at(1), "–");
    EXPECT_EQ(index.column("Validity").at(1), "no contact");
    EXPECT_EQ(index.column("Scan or shape").at(2), "sphere of radius 100 nm");
    for (const char* page : {"index", "touches", "far", "touches_2"}) {
        for (const std::string& link : ReportedPage(out / (std::string(page) + ".html")).links()) {
            EXPECT_TRUE(std::filesystem::is_regular_file(out / link)) << page << ": " << link;
        }
    }
}

TEST_F(Report, OfARunWithoutContactSaysSo) {
    const ReportedPage page = pageOf(far());
    EXPECT_NE(page.text().find("The tip never touched the sample"), std::string::npos);
    EXPECT_EQ(page.count("//img"), 1U) << "no deformation";
    EXPECT_EQ(page.text().find("Maximum indentation"), std::string::npos);
}

TEST_F(Report, OfAShapeHasNoFile) {
    const ReportedPage page = pageOf(sphere());
    EXPECT_EQ(page.fact("Shape"), "sphere of radius 100 nm");
    EXPECT_EQ(page.fact("File"), "");
    EXPECT_EQ(page.fact("SHA-256"), "");
}

TEST_F(Report, OfARecordingThatWasCutOffGoesUpToItsLastTick) {
    const auto run = copyOf(touches());
    std::filesystem::remove(run / "summary.json");
    const auto sha256 =
        nlohmann::json::parse(test::contentOf(touches() / "summary.json"))["input"]["sha256"];
    std::ofstream(run / "recording.json")
        << nlohmann::json{{"format", "asperity recording"},
                          {"format_version", 1},
                          {"versions", {{"asperity", "0.0.9"}, {"compiler", "11"}}},
                          {"input", {{"sha256", sha256}}},
                          {"complete", false},
                          {"recovered", false}};
    for (const char* name : {"tick_input.csv", "force_log.csv"}) {
        std::filesystem::resize_file(run / name, std::filesystem::file_size(run / name) / 2);
    }
    const auto made = report(run.string());
    ASSERT_EQ(made.exitCode, 0) << made.output;
    EXPECT_NE(made.output.find("note: "), std::string::npos);
    const ReportedPage page(out / "touches.html");
    EXPECT_NE(page.text().find("The recording was cut off; it goes up to its last whole tick."),
              std::string::npos);
    EXPECT_EQ(page.fact("Made by"), "asperity 0.0.9, compiler 11");
    EXPECT_NE(page.text().find("no summary with the reasons"), std::string::npos);
}

TEST_F(Report, SaysWhereTheReplayDiffersFromTheLog) {
    const auto run = copyOf(touches());
    std::string log = test::contentOf(run / "force_log.csv");
    const std::size_t line = log.find("\n0.5,");
    ASSERT_NE(line, std::string::npos);
    const std::size_t cell = log.find(',', log.find(',', line + 1) + 1);
    log.insert(cell, "1");
    std::ofstream(run / "force_log.csv") << log;
    const auto made = report(run.string());
    EXPECT_EQ(made.exitCode, 0) << made.output;
    EXPECT_NE(made.output.find("differs from the recorded log: first differing tick: 500 "),
              std::string::npos)
        << made.output;
    const ReportedPage page(out / "touches.html");
    EXPECT_GE(page.count("//p[@class='fault']"), 2U);
    EXPECT_EQ(page.text().find("bit for bit"), std::string::npos);
}

/// A device that is lost at a tick; so is it in the log.
TEST_F(Report, NamesAFault) {
    const auto run = copyOf(touches());
    std::stringstream input(test::contentOf(run / "tick_input.csv"));
    std::ofstream altered(run / "tick_input.csv");
    for (std::string line; std::getline(input, line);) {
        const bool isTick = !line.empty() && std::isdigit(static_cast<unsigned char>(line[0])) != 0;
        if (isTick && std::stod(line) > 0.6) {
            std::size_t start = 0;  // of the seventh cell: connected
            for (int i = 0; i < 6; ++i) {
                start = line.find(',', start) + 1;
            }
            line.replace(start, 1, "0");
        }
        altered << line << '\n';
    }
    altered.close();
    (void)test::runProgram("replay " + run.string() + " --out " + scratch.file("log").string());
    std::filesystem::copy(scratch.path() / "log/force_log.csv", run / "force_log.csv",
                          std::filesystem::copy_options::overwrite_existing);
    const ReportedPage page = pageOf(run);
    EXPECT_NE(page.text().find("device not connected"), std::string::npos);
    EXPECT_EQ(page.column("Fault"),
              (std::vector<std::string>{"Device not connected: forces switched off"}));
}

TEST_F(Report, RefusesInOneSentenceAndLeavesNothing) {
    const auto run = copyOf(touches());
    const std::string good = far().string();
    const auto expectRefused = [&](const std::string& runs, const std::string& sentence) {
        const auto made = report(runs);
        EXPECT_EQ(made.exitCode, 3) << made.output;
        EXPECT_NE(made.output.find(sentence), std::string::npos) << made.output;
        EXPECT_EQ(made.lines(), 1) << made.output;
        EXPECT_FALSE(std::filesystem::exists(out));
    };
    expectRefused(good + " " + scratch.file("nothing").string(), "expected the folder of a run");
    const std::string scene = test::contentOf(run / "scene.toml");
    const std::string name = "particles.gsf";
    std::string other = scene;
    other.replace(other.find(name), name.size(), "nothing.gsf");
    std::ofstream(run / "scene.toml") << other;
    expectRefused(good + " " + run.string(), "nothing.gsf");
    other = scene;
    other.replace(other.find(name), name.size(), "egg_box.gsf");
    const std::size_t channel = other.find("channel = ");
    other.erase(channel, other.find('\n', channel) - channel);
    std::ofstream(run / "scene.toml") << other;
    expectRefused(run.string(), "its hash differs");
}

TEST_F(Report, ReplacesAnEarlierReportAndNoOtherFileUnasked) {
    std::filesystem::create_directory(out);
    std::ofstream(out / "far.html") << "mine";
    const auto refused = report(far().string());
    EXPECT_EQ(refused.exitCode, 1) << refused.output;
    EXPECT_EQ(test::contentOf(out / "far.html"), "mine");
    EXPECT_EQ(report(far().string() + " --force").exitCode, 0);
    EXPECT_EQ(report(sphere().string()).exitCode, 0) << "an earlier report";
    EXPECT_FALSE(std::filesystem::exists(out / "far.html"));
    EXPECT_TRUE(std::filesystem::exists(out / "sphere.pdf"));
}

TEST_F(Report, IsTheSameForTheSameRun) {
    const auto run = sphere();
    (void)pageOf(run);
    const std::string first = test::contentOf(out / "sphere.html");
    (void)pageOf(run);
    EXPECT_EQ(test::contentOf(out / "sphere.html"), first);
}

TEST_F(Report, SaysTheSameInBothForms) {
    const ReportedPage page = pageOf(touches());
    const std::string pdf = (out / "touches.pdf").string();
    const auto text = test::runCommand("pdftotext -layout " + pdf + " -");
    ASSERT_EQ(text.exitCode, 0) << text.output;
    std::vector<std::string> parts = page.column("pull-off force");
    for (const char* title : {"max. force", "work of adhesion", "Ticks", "Effect"}) {
        std::ranges::copy(page.column(title), std::back_inserter(parts));
    }
    for (const char* fact : {"SHA-256", "Format", "First contact", "Size", "Made by"}) {
        parts.push_back(page.fact(fact));
    }
    parts.emplace_back("pull-off force");  // without a ligature
    std::string shown = text.output;
    for (std::size_t at = shown.find("\u00A0"); at != std::string::npos;
         at = shown.find("\u00A0")) {
        shown.replace(at, 2, " ");
    }
    for (const std::string& part : parts) {
        EXPECT_NE(shown.find(part), std::string::npos) << part;
    }
    const auto facts = test::runCommand("pdfinfo " + pdf);
    EXPECT_NE(facts.output.find("(A4)"), std::string::npos) << facts.output;
    EXPECT_NE(facts.output.find("Run touches"), std::string::npos) << facts.output;
    const auto fonts = test::runCommand("pdffonts " + pdf);
    EXPECT_NE(fonts.output.find("DejaVuSans"), std::string::npos) << fonts.output;
    EXPECT_EQ(fonts.output.find(" no  no "), std::string::npos) << "a font is not embedded";
}

TEST_F(Report, IsHtmlForAnotherReader) {
    (void)pageOf(touches());
    const auto read =
        test::runCommand("python3 " + (test::checkout() / "tests/app/html_page.py ").string() +
                         (out / "touches.html").string());
    EXPECT_EQ(read.exitCode, 0) << read.output;
}

/// Qt made a folder there where a desktop session names none.
TEST_F(Report, LeavesNoFolderInThatOfTemporaryFiles) {
    const std::filesystem::path temporary = scratch.path() / "tmp";
    std::filesystem::create_directory(temporary);
    const std::string environment = "env -u XDG_RUNTIME_DIR TMPDIR=" + temporary.string();
    const std::filesystem::path broken = copyOf(far());
    std::ofstream(broken / "scene.toml") << "broken";
    EXPECT_EQ(test::runProgram("report " + far().string() + " --out " + out.string(), environment)
                  .exitCode,
              0);
    EXPECT_EQ(test::runProgram("report " + broken.string() + " --force --out " + out.string(),
                               environment)
                  .exitCode,
              3);
    EXPECT_TRUE(std::filesystem::is_empty(temporary));
}

}  // namespace
}  // namespace asperity
