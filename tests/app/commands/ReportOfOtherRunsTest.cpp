#include "tests/app/ProgramRun.h"
#include "tests/app/commands/ReportedPage.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::ReportedPage;
using testing::HasSubstr;
using testing::Not;

/// Reports on bundles, parts, runs at rest, and on what is no run.
class ReportOfOtherRuns : public ::testing::Test {
protected:
    static void expectRuns(const std::string& call) {
        const auto run = test::runProgram(call);
        ASSERT_EQ(run.exitCode, 0) << call << "\n" << run.output;
    }
    [[nodiscard]] std::string in(const std::string& name) const {
        return scratch.file(name).string();
    }
    void explore(const std::string& name, const std::string& options) const {
        expectRuns("explore --no-pictures " + test::shippedScene("polystyrene").string() + " " +
                   options + " --out " + in(name));
    }
    [[nodiscard]] ReportedPage pageOf(const std::string& run) const {
        expectRuns("report " + in(run) + " --force --out " + in("out"));
        return ReportedPage(scratch.file("out") / (run + ".html"));
    }
    void unpack(const std::string& bundle, const std::string& folder) const {
        const std::string call = "python3 -m zipfile -e " + in(bundle) + " " + in(folder);
        ASSERT_EQ(std::system(call.c_str()), 0);
    }
    /// The lines of hashes of a page. @param inBundle those of a bundle's files, or the others
    static std::string hashLines(const ReportedPage& page, bool inBundle) {
        const std::string text = page.text();
        const std::regex line("[0-9a-f]{64}  ([^\\s]+?)(?=Of the files|\\s|$)");
        std::string lines;
        for (std::sregex_iterator hash(text.begin(), text.end(), line), end; hash != end; ++hash) {
            if (inBundle == (hash->str(1).front() != '/')) {
                lines += hash->str() + "\n";
            }
        }
        return lines;
    }
    [[nodiscard]] int checkHashes(const std::string& lines, const std::string& folder) const {
        const auto list = scratch.write("hashes.txt", lines);
        const std::string call =
            "cd " + in(folder) + " && sha256sum --quiet -c " + list.string() + " >&2";
        return std::system(call.c_str());
    }

    test::ScratchFolder scratch;
};

TEST_F(ReportOfOtherRuns, OfABundleNamesFilesThatAreThereAndChecksThem) {
    explore("run", "--duration 1");
    expectRuns("bundle " + in("run") + " " + in("packed.zip"));
    const ReportedPage page = pageOf("packed.zip");
    EXPECT_FALSE(std::regex_search(page.text(), std::regex("/asperity-[A-Za-z0-9]{6}/")))
        << "the folder that it was unpacked into is gone";
    EXPECT_EQ(page.fact("File"), "scan/particles.gsf in the bundle packed.zip");
    const std::string inside = hashLines(page, true);
    for (const char* name : {"scene.toml", "tick_input.csv", "force_log.csv", "particles.gsf"}) {
        EXPECT_THAT(inside, HasSubstr(name));
    }
    EXPECT_THAT(hashLines(page, false), HasSubstr(in("packed.zip")));
    EXPECT_EQ(checkHashes(hashLines(page, false), "."), 0);
    unpack("packed.zip", "unpacked");
    EXPECT_EQ(checkHashes(inside, "unpacked"), 0);
}

TEST_F(ReportOfOtherRuns, OfAPartThatBeginsInContactClaimsNoApproach) {
    explore("run", "--duration 1");
    const auto whole =
        nlohmann::json::parse(test::contentOf(scratch.file("run") / "summary.json"))["cycles"][0];
    const double middle = 0.5 * (whole["touch_s"].get<double>() + whole["off_s"].get<double>());
    expectRuns("bundle " + in("run") + " " + in("part.zip") + " --from " + std::to_string(middle));
    const ReportedPage page = pageOf("part.zip");
    EXPECT_EQ(page.column("hysteresis").at(0), "–");
    EXPECT_EQ(page.column("snap-in force").at(0), "–");
    EXPECT_EQ(page.column("remark").at(0), "in contact from the start");
    EXPECT_EQ(page.fact("First contact"), "");
    EXPECT_THAT(page.text(), HasSubstr("The contact model is in contact from the first tick on."));
    EXPECT_THAT(page.text(), Not(HasSubstr("never snapped")));
    unpack("part.zip", "part");
    const auto part =
        nlohmann::json::parse(test::contentOf(scratch.file("part") / "summary.json"))["cycles"][0];
    EXPECT_TRUE(part["hysteresis_j"].is_null());
    EXPECT_TRUE(part["snap_in_force_n"].is_null());
    EXPECT_FALSE(whole["hysteresis_j"].is_null());
    EXPECT_NEAR(part["pull_off_force_n"], whole["pull_off_force_n"],
                3.0 * whole["pull_off_force_sigma_n"].get<double>());
}

TEST_F(ReportOfOtherRuns, OfATipAtRestHasASentenceInPlaceOfACurve) {
    const auto path = scratch.write("rest.csv", "time_s,x_m,y_m,z_m\n"
                                                "0,6.8e-8,1.783e-7,3e-7\n"
                                                "0.1,6.8e-8,1.783e-7,3e-7\n");
    explore("rest", "--path " + path.string());
    const ReportedPage page = pageOf("rest");
    EXPECT_THAT(page.text(), HasSubstr("The tip did not move to or from the sample"));
    EXPECT_EQ(page.count("//*[local-name()='svg']"), 0U);
}

TEST_F(ReportOfOtherRuns, SaysOfWhatIsNoRunWhatOtherCommandsSay) {
    (void)scratch.write("notes.txt", "no archive, longer than the end of one");
    (void)scratch.write("cut.zip", "PK\x03\x04 and no more of an archive than that");
    for (const char* input : {"notes.txt", "cut.zip", "missing"}) {
        const auto report = test::runProgram("report " + in(input) + " --out " + in("out"));
        const auto replay = test::runProgram("replay " + in(input) + " --out " + in("again"));
        EXPECT_EQ(report.exitCode, 3) << report.output;
        EXPECT_EQ(report.output, replay.output);
        EXPECT_THAT(report.output, Not(HasSubstr("scene.toml")));
        EXPECT_FALSE(fs::exists(scratch.file("out")));
    }
}

// A summary that a full disk cut said that the hash of the scan was expected.
TEST_F(ReportOfOtherRuns, ACutSummaryIsDamagedJson) {
    explore("run", "--duration 0.05");
    std::ofstream(in("run/summary.json")) << R"({"input": {"sha)";
    const auto run = test::runProgram("report " + in("run") + " --out " + in("out"));
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_THAT(run.output, HasSubstr("summary.json: byte 15: this is no JSON; the file is "
                                      "truncated or damaged"));
}

}  // namespace
}  // namespace asperity
