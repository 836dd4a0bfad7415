#include "core/PrintableText.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(Utf8, TakesWhatTheStandardAllowsAndNothingElse) {
    for (const char* text : {"", "plain", "µm", "\u07FF\u0800\uD7FF\uE000\uFFFF", "\U0010FFFF"}) {
        EXPECT_TRUE(isUtf8(text)) << text;
    }
    // Latin-1; cut off; a lone continuation; overlong; a surrogate; beyond U+10FFFF.
    for (const char* text : {"\xB5m", "cut \xE2\x82", "\x80", "\xC0\x80", "\xE0\x80\x80",
                             "\xF0\x80\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"}) {
        EXPECT_FALSE(isUtf8(text)) << text;
    }
}

TEST(Utf8, TellsCodePointAndLength) {
    EXPECT_EQ(firstCharacter("µm").codePoint, U'µ');
    EXPECT_EQ(firstCharacter("µm").length, 2U);
    EXPECT_EQ(firstCharacter("\U0001F52C").codePoint, U'\U0001F52C');
    EXPECT_EQ(firstCharacter("\xB5m").length, 0U);
}

TEST(Utf8, CutsBetweenCharacters) {
    EXPECT_EQ(utf8Start("aµm", 4), "aµm");
    EXPECT_EQ(utf8Start("aµm", 3), "aµ");
    EXPECT_EQ(utf8Start("aµm", 2), "a");
    EXPECT_EQ(utf8Start("aµm", 0), "");
    EXPECT_EQ(utf8Start("\x80\x80", 1), "");
}

TEST(Utf8, ShortensToStartAndEnd) {
    EXPECT_EQ(shortened("a short text", 100), "a short text");
    std::string text = "a.sxm: SCAN_RANGE: found '";
    for (int i = 0; i < 1000; ++i) {
        text += "µ";
    }
    text += "', expected two numbers";
    for (const std::size_t most : {100U, 101U, 102U, 103U, 1000U}) {
        const std::string shorter = shortened(text, most);
        EXPECT_LE(shorter.size(), most);
        EXPECT_GE(shorter.size(), most - 2);
        EXPECT_TRUE(isUtf8(shorter)) << shorter;
        EXPECT_TRUE(shorter.starts_with("a.sxm: SCAN_RANGE: found 'µµ")) << shorter;
        EXPECT_TRUE(shorter.ends_with("expected two numbers")) << shorter;
        EXPECT_NE(shorter.find("µ … "), std::string::npos) << shorter;
    }
}

}  // namespace
}  // namespace asperity
