#include "tests/app/ProgramRun.h"
#include "tests/support/GermanLocale.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Commands of a user whose language has a decimal comma.
class LocaleTest : public ::testing::Test {
protected:
    [[nodiscard]] test::ProgramRun inGerman(const std::string& arguments) const {
        return test::runProgram(arguments, german_.environment());
    }
    void expectTheSame(const std::string& arguments) const {
        const test::ProgramRun german = inGerman(arguments);
        const test::ProgramRun plain = test::runProgram(arguments, "LC_ALL=C");
        EXPECT_EQ(german.output, plain.output) << arguments;
        EXPECT_EQ(german.exitCode, plain.exitCode) << arguments;
    }

    test::ScratchFolder folder_;
    test::GermanLocale german_;
};

TEST_F(LocaleTest, TheLocaleHasADecimalComma) {
    const std::string command = german_.environment() + " locale decimal_point";
    std::FILE* pipe = popen(command.c_str(), "r");  // NOLINT(cert-env33-c)
    ASSERT_NE(pipe, nullptr);
    EXPECT_EQ(std::fgetc(pipe), ',');
    pclose(pipe);
}

TEST_F(LocaleTest, TheCommandLineTakesAndPrintsNumbersAsInFiles) {
    expectTheSame("curve --material polystyrene --stiffness 14.5 --radius 1.5e-8");
    expectTheSame("info " + test::shippedScene("").parent_path().parent_path().string() +
                  "/samples/particles.gsf");
    expectTheSame("curve --stiffness 14,5");
    const fs::path cases =
        folder_.write("cases.csv", "model,radius_m,e_star_pa,work_of_adhesion_j_m2,sigma0_pa,"
                                   "indentation_m,branch\n"
                                   "md,15e-9,2.35e9,0.066,1.85e8,1e-9,retract\n");
    expectTheSame("contact --cases " + cases.string());
}

TEST_F(LocaleTest, TheFilesOfARunAreTheSameAndReplay) {
    const std::string scene = test::shippedScene("sphere").string();
    const fs::path plain = folder_.file("plain");
    const fs::path german = folder_.file("german");
    const std::string run = "explore " + scene + " --duration 0.3 --out ";
    ASSERT_EQ(test::runProgram(run + plain.string(), "LC_ALL=C").exitCode, 0);
    ASSERT_EQ(inGerman(run + german.string()).exitCode, 0);
    for (const char* name : {"force_log.csv", "tick_input.csv", "scene.toml"}) {
        EXPECT_EQ(test::contentOf(plain / name), test::contentOf(german / name)) << name;
    }
    const test::ProgramRun again =
        inGerman("replay " + plain.string() + " --out " + folder_.file("again").string());
    EXPECT_NE(again.output.find("bit-identical"), std::string::npos) << again.output;
}

}  // namespace
}  // namespace asperity
