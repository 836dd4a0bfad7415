#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;

/// Two runs on a flat sample, whose normal is the vertical: they differ in adhesion alone.
class Compare : public testing::Test {
protected:
    static void SetUpTestSuite() {
        scratch = std::make_unique<test::ScratchFolder>();
        explore("weak", "0.05");
        explore("strong", "0.08");
    }
    static void TearDownTestSuite() { scratch.reset(); }

    static void explore(const std::string& name, const std::string& work) {
        const auto scene = scratch->write(name + ".toml", "[sample]\nshape = \"plane\"\n"
                                                          "work_of_adhesion_j_m2 = " +
                                                              work + "\n");
        const auto made = test::runProgram("explore --no-pictures " + scene.string() +
                                           " --duration 1 --out " + in(name));
        ASSERT_EQ(made.exitCode, 0) << made.output;
    }
    static std::string in(const std::string& name) { return scratch->file(name).string(); }
    static test::ProgramRun compare(const std::string& arguments) {
        return test::runProgram("compare " + arguments);
    }
    static CsvTable logOf(const std::string& run) {
        return readCsv(scratch->file(run) / "force_log.csv");
    }

    static std::unique_ptr<test::ScratchFolder> scratch;
};

std::unique_ptr<test::ScratchFolder> Compare::scratch;

TEST_F(Compare, TellsWhatTheLogsOfBothRunsTell) {
    const auto told = compare(in("weak") + " " + in("strong") + " --json --out " + in("table.csv"));
    ASSERT_EQ(told.exitCode, 0) << told.output;
    const CsvTable weak = logOf("weak");
    const CsvTable strong = logOf("strong");
    const CsvTable table = readCsv(scratch->file("table.csv"));
    ASSERT_EQ(table.rows(), weak.rows());
    double sum = 0.0;
    double squares = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < weak.rows(); ++i) {
        const double difference = strong.number(i, "est_fz_n") - weak.number(i, "est_fz_n");
        EXPECT_NEAR(table.number(i, "difference_n"), difference, 1e-20);
        sum += difference;
        squares += difference * difference;
        largest = std::abs(difference) > std::abs(largest) ? difference : largest;
    }
    const auto ticks = static_cast<double>(weak.rows());
    const nlohmann::json answer = nlohmann::json::parse(told.output.substr(told.output.find('{')));
    const nlohmann::json& difference = answer["difference"];
    ASSERT_LT(largest, -1e-9) << "the stronger one pulls";
    EXPECT_NEAR(difference["mean_n"].get<double>(), sum / ticks, 1e-18);
    EXPECT_NEAR(difference["rms_n"].get<double>(), std::sqrt(squares / ticks), 1e-18);
    EXPECT_NEAR(difference["largest_n"].get<double>(), largest, 1e-20);
    EXPECT_EQ(answer["compared_ticks"], weak.rows());
    ASSERT_EQ(answer["differs"].size(), 2U) << "as believed and in truth: " << answer["differs"];
    EXPECT_THAT(answer["differs"][0].get<std::string>(), HasSubstr("50 mJ/m² → 80 mJ/m²"));
}

TEST_F(Compare, ARunDoesNotDifferFromItself) {
    const auto told = compare(in("weak") + " " + in("weak"));
    ASSERT_EQ(told.exitCode, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("rms:      0 N"));
    EXPECT_THAT(told.output, HasSubstr("scan and parameters are the same"));
}

TEST_F(Compare, TakesABundle) {
    const auto bundled = test::runProgram("bundle " + in("strong") + " " + in("strong.zip"));
    ASSERT_EQ(bundled.exitCode, 0) << bundled.output;
    const auto folder = compare(in("weak") + " " + in("strong") + " --json");
    const auto bundle = compare(in("weak") + " " + in("strong.zip") + " --json");
    ASSERT_EQ(bundle.exitCode, 0) << bundle.output;
    const auto differenceOf = [](const test::ProgramRun& run) {
        return nlohmann::json::parse(run.output.substr(run.output.find('{')))["difference"];
    };
    EXPECT_EQ(differenceOf(bundle), differenceOf(folder));
}

TEST_F(Compare, RefusesWhatIsNoRunInASentence) {
    const auto none = compare(in("weak") + " " + in("nothing"));
    EXPECT_NE(none.exitCode, 0);
    EXPECT_THAT(none.output, HasSubstr("nothing"));
    (void)scratch->write("notes.txt", "no archive, longer than the end of one");
    const auto text = compare(in("weak") + " " + in("notes.txt"));
    EXPECT_EQ(text.exitCode, 3);
    EXPECT_THAT(text.output, HasSubstr("notes.txt: expected the folder of a run, or a bundle"));
}

TEST_F(Compare, ReplacesAFileOnlyWithForce) {
    (void)scratch->write("mine.csv", "mine");
    const std::string call = in("weak") + " " + in("strong") + " --out " + in("mine.csv");
    const auto refused = compare(call);
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("mine.csv: is there already; name another file, or "
                                          "replace it with --force"));
    EXPECT_EQ(test::contentOf(scratch->file("mine.csv")), "mine");
    EXPECT_EQ(compare(call + " --force").exitCode, 0);
    EXPECT_GT(readCsv(scratch->file("mine.csv")).rows(), 0U);
}

TEST_F(Compare, WritesIntoNoRunThatItCompares) {
    std::filesystem::create_symlink("strong", scratch->file("link"));
    const std::string log = test::contentOf(scratch->file("strong") / "force_log.csv");
    for (const char* file : {"weak/force_log.csv", "strong/force_log.csv", "link/force_log.csv",
                             "strong/new.csv", "strong/../weak/new.csv"}) {
        const auto refused =
            compare(in("weak") + " " + in("strong") + " --force --out " + in(file));
        EXPECT_EQ(refused.exitCode, 1) << file;
        EXPECT_THAT(refused.output, HasSubstr("lies in the folder of one")) << file;
    }
    EXPECT_EQ(test::contentOf(scratch->file("strong") / "force_log.csv"), log);
    EXPECT_FALSE(std::filesystem::exists(scratch->file("weak") / "new.csv"));
}

}  // namespace
}  // namespace asperity
