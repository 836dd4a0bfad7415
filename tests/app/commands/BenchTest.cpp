#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The program in a folder of its own: beside it there are the measurements that a test puts there.
class Bench : public testing::Test {
protected:
    Bench() {
        std::filesystem::copy_file(test::programOfBuild("asperity"), folder_.file("asperity"));
        putMeasurement("asperity_contact_bench", R"([
            {"name": "fast", "value": 4.5, "unit": "x", "goal": 3, "goal_is": "at_least",
             "met": true},
            {"name": "slow", "value": 7, "unit": "ms", "goal": 5, "goal_is": "at_most",
             "met": false},
            {"name": "alone", "value": null, "unit": "x", "goal": 2, "goal_is": "at_least",
             "met": null}])");
    }

    void putProgram(const std::string& name, const std::string& script) {
        std::filesystem::permissions(folder_.write(name, "#!/bin/sh\n" + script),
                                     std::filesystem::perms::owner_all);
    }
    /// A measurement that gives these rows, and what it was asked for beside them.
    void putMeasurement(const std::string& name, const std::string& rows) {
        putProgram(name, "echo table\necho \"$3\" >" + folder_.file("asked").string() +
                             "\ncat >\"$2\" <<'END'\n" + rows + "\nEND\n");
    }
    [[nodiscard]] test::ProgramRun bench(const std::string& arguments) const {
        return test::runCommand(folder_.file("asperity").string() + " bench " + arguments);
    }
    [[nodiscard]] std::string asked() const {
        std::ifstream stream(folder_.file("asked"));
        std::string line;
        std::getline(stream, line);
        return line;
    }

    test::ScratchFolder folder_;
};

TEST_F(Bench, PrintsEachFigureBesideItsGoalAndWritesThem) {
    const auto run = bench("contact --quick --json " + folder_.file("rows.json").string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, testing::ContainsRegex("fast +4.5 x +>= 3 +met"));
    EXPECT_THAT(run.output, testing::ContainsRegex("slow +7 ms +<= 5 +not met"));
    EXPECT_THAT(run.output, testing::ContainsRegex("alone +- +>= 2 +not installed"));
    EXPECT_THAT(run.output, HasSubstr("1 goals met, 1 not met, 1 beside programs that are not "));
    EXPECT_THAT(run.output, Not(HasSubstr("table"))) << "each measurement's own tables stay away";
    EXPECT_EQ(asked(), "--quick");
    const nlohmann::json rows =
        nlohmann::json::parse(std::ifstream(folder_.file("rows.json"))).at("rows");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].at("name"), "fast");
    EXPECT_EQ(rows[0].at("value"), 4.5);
    EXPECT_EQ(rows[1].at("met"), false);
    EXPECT_TRUE(rows[2].at("value").is_null());
}

TEST_F(Bench, SaysWhatIsNotBuiltBeforeItMeasures) {
    const auto run = bench("contact fit");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("tools/build.sh release asperity_benchmarks"));
    EXPECT_THAT(run.output, Not(HasSubstr("measuring:")));
}

TEST_F(Bench, FailsWithAMeasurementThatFails) {
    putMeasurement("asperity_contact_bench", "no rows");
    const auto run = bench("contact --json " + folder_.file("rows.json").string());
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("asperity_contact_bench has failed"));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("rows.json")));
}

// A program that a measurement had started ran on.
TEST_F(Bench, EndsAllThatItHasStartedWithIt) {
    const std::string child = folder_.file("child").string();
    putProgram("asperity_contact_bench",
               "echo complaint >&2; sleep 1000 & echo $! >begun; mv begun " + child + "; wait\n");
    const auto run = test::runCommand(
        "{ cd " + folder_.path().string() + "; ./asperity bench contact & bench=$!; while ! [ -e " +
        child + " ]; do sleep 0.05; done; kill -TERM $bench; wait $bench; echo status $?; }");
    EXPECT_THAT(run.output, HasSubstr("complaint\n"));
    EXPECT_THAT(run.output, HasSubstr("asperity: canceled\nstatus 1"));
    const std::string state =
        test::contentOf("/proc/" + std::to_string(std::stoi(test::contentOf(child))) + "/stat");
    EXPECT_TRUE(state.empty() || state.find(") Z ") != std::string::npos) << state;
}

}  // namespace
}  // namespace asperity
