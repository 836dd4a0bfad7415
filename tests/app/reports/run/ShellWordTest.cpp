#include "app/reports/run/RunSections.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// Returns a word as a shell reads it.
std::string readByShell(const std::string& word) {
    std::FILE* pipe = popen(("printf %s " + word).c_str(), "r");  // NOLINT(cert-env33-c): the test
    std::string text;
    std::array<char, 256> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
        text += buffer.data();
    }
    pclose(pipe);
    return text;
}

TEST(ShellWord, IsReadAsItWas) {
    for (const std::string& text :
         std::vector<std::string>{"runs/a", "a b", "it's", "$(touch x)", "`x`;&|", "\"q\"", "Prüf",
                                  "a\\b", "*", "~", "#x"}) {
        EXPECT_EQ(readByShell(shellWord(text)), text);
    }
    EXPECT_EQ(shellWord("runs/a-b_c.1"), "runs/a-b_c.1") << "is not quoted without need";
    EXPECT_EQ(shellWord(""), "''");
}

}  // namespace
}  // namespace asperity
