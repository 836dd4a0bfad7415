#include "core/io/NestedText.h"

#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/TomlFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {
namespace {

using testing::HasSubstr;

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

std::string tomlRefusal(const std::string& text) {
    return refusalOf([&] { requireParsable(text, NestedSyntax::Toml, "a.toml"); });
}

std::string jsonRefusal(const std::string& text) {
    return refusalOf([&] { requireParsable(text, NestedSyntax::Json, "a.json"); });
}

TEST(NestedText, MayBeAsDeepAsAnyFileOfOurs) {
    EXPECT_EQ(
        tomlRefusal("a.b.c = [[1.5, 2.5], {x = 'y.z.z'}]\n[d.e]\nf = 1979-05-27T07:32:00.9\n"), "");
    EXPECT_EQ(jsonRefusal(R"({"a": [{"b": [1.5, "[[[["]}]})"), "");
    EXPECT_EQ(tomlRefusal("") + jsonRefusal(""), "");
}

TEST(NestedText, HasDotsThatAreNoDepth) {
    const std::string dots(40'000, '.');
    EXPECT_EQ(tomlRefusal("# " + dots + "\na = '" + dots + "'\nb = \"\\\"" + dots + "\"\nc = '''" +
                          dots + "\n'" + dots + "'''\nd = \"\"\"\n" + dots + "\\\"\"\"\"\n"),
              "");
    EXPECT_EQ(tomlRefusal("a = [" + repeated("0.5, ", 40'000) + "]"), "");
    EXPECT_EQ(jsonRefusal("[\"" + dots + "\\\"" + dots + "\"]"), "");
}

TEST(NestedText, IsRefusedWhereItIsTooDeep) {
    const std::string key = repeated("a.", 40'000) + "a";
    for (const std::string& text :
         {key + " = 1", "[" + key + "]", "x = {" + key + " = 1}", "x = " + repeated("[", 100),
          repeated("'a' . ", 40'000), repeated("\"a\".", 40'000)}) {
        EXPECT_THAT(tomlRefusal("# notes\n" + text),
                    HasSubstr("a.toml: line 2: values nested deeper than 64"));
    }
    for (const char* const open : {"[", "{\"a\":", "[{\"a\":["}) {
        EXPECT_THAT(jsonRefusal(repeated(open, 100'000)),
                    HasSubstr("a.json: line 1: values nested"));
    }
}

TEST(NestedText, IsRefusedWhereItHasTooManyValues) {
    EXPECT_THAT(tomlRefusal("a = [" + repeated("[],", 300'000) + "]"),
                HasSubstr("more than 262144 values"));
    EXPECT_THAT(tomlRefusal(repeated("a=1\n", 300'000)), HasSubstr("line 262145"));
    EXPECT_THAT(jsonRefusal("[" + repeated("1,", 3'000'000) + "1]"),
                HasSubstr("more than 2097152 values"));
    EXPECT_THAT(tomlRefusal("a = '" + std::string(1U << 24U, 'a') + "'"),
                HasSubstr("expected at most 16777216"));
}

/// The parser held a string of 100 MB four times.
TEST(NestedText, IsRefusedWhereAStringIsTooLong) {
    EXPECT_EQ(jsonRefusal("{\"a\": \"" + std::string(1'000'000, 'x') + "\"}"), "");
    const std::string longText = "\"" + std::string(1'100'000, 'x') + "\"";
    for (const std::string& text : {"{\n\"a\": " + longText + "}", "{\n" + longText + ": 1}",
                                    "\n" + longText.substr(0, longText.size() - 1)}) {
        EXPECT_THAT(jsonRefusal(text),
                    HasSubstr("a.json: line 2: a string of more than 1048576 bytes"));
    }
    EXPECT_THAT(jsonRefusal(std::string(51U << 20U, ' ')), HasSubstr("expected at most 50331648"));
}

/// The parser went down a level for each dot, until the stack was used up.
TEST(NestedText, IsCheckedBeforeAFileIsParsed) {
    const ScratchFolder scratch;
    const auto file = scratch.write("a.toml", "[" + repeated("a.", 40'000) + "a]\nb = 1\n");
    EXPECT_THAT(refusalOf([&] { (void)readToml(file); }),
                HasSubstr("a.toml: line 1: values nested"));
    EXPECT_THAT(refusalOf([&] { (void)readProbe(file); }), HasSubstr("values nested"));
    EXPECT_TRUE(readToml(scratch.write("empty.toml", "")).empty());
}

}  // namespace
}  // namespace asperity::test
