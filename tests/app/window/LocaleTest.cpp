#include "tests/app/ProgramRun.h"
#include "tests/support/GermanLocale.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <regex>

namespace asperity::test {
namespace {

/// The first number with a decimal comma, and what is around it; empty: there is none.
std::string decimalComma(const std::string& text) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(".{0,20}[0-9],[0-9].{0,20}")) ? found.str()
                                                                                   : std::string();
}

// Qt sets the user's locale when the window is made.
TEST(WindowInGerman, WritesNumbersAsEverywhere) {
    const GermanLocale german;
    const ScratchFolder folder;
    const std::filesystem::path out = folder.file("run");
    const ProgramRun run = runProgram("loop " + shippedScene("polystyrene").string() +
                                          " --window --duration 1 --record " + out.string(),
                                      german.environment());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_EQ(decimalComma(run.output), "");
    for (const char* name : {"summary.json", "recording.json", "scene.toml"}) {
        ASSERT_NE(contentOf(out / name), "") << name;
        EXPECT_EQ(decimalComma(contentOf(out / name)), "") << name;
    }
    const ProgramRun again =
        runProgram("replay " + out.string() + " --out " + folder.file("again").string());
    EXPECT_NE(again.output.find("bit-identical"), std::string::npos) << again.output;
}

}  // namespace
}  // namespace asperity::test
