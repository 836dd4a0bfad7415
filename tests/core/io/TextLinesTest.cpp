#include "core/io/TextLines.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> linesOf(std::string_view bytes) {
    const MemoryBytes source(bytes, "text");
    TextLines lines(source);
    std::vector<std::string> all;
    while (const auto line = lines.next()) {
        all.emplace_back(*line);
        EXPECT_EQ(lines.number(), static_cast<long long>(all.size()));
    }
    return all;
}

std::string asUtf16(std::string_view ascii, bool little) {
    std::string bytes = little ? "\xFF\xFE" : "\xFE\xFF";
    for (const char c : ascii) {
        bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
    }
    return bytes;
}

}  // namespace

TEST(TextLines, EndWithAnyOfTheThreeLineEnds) {
    for (const char* text : {"a\nb\n\nc", "a\r\nb\r\n\r\nc", "a\rb\r\rc", "a\nb\n\nc\n"}) {
        EXPECT_THAT(linesOf(text), ElementsAre("a", "b", "", "c")) << text;
    }
    EXPECT_TRUE(linesOf("").empty());
    EXPECT_THAT(linesOf("\n"), ElementsAre(""));
}

TEST(TextLines, ByteOrderMarksSayTheEncoding) {
    EXPECT_THAT(linesOf("\xEF\xBB\xBF"
                        "a\nb"),
                ElementsAre("a", "b"));
    EXPECT_THAT(linesOf(asUtf16("a\r\nb", true)), ElementsAre("a", "b"));
    EXPECT_THAT(linesOf(asUtf16("a\r\nb", false)), ElementsAre("a", "b"));
    EXPECT_THAT(linesOf("\xB5m\n"), ElementsAre("\xB5m"));
}

TEST(TextLines, LongTextsAreReadInParts) {
    std::string text;
    for (int i = 0; i < 100000; ++i) {
        text += "line " + std::to_string(i) + "\r\n";
    }
    const std::vector<std::string> lines = linesOf(asUtf16(text, true));
    ASSERT_EQ(lines.size(), 100000U);
    EXPECT_EQ(lines[77777], "line 77777");
    EXPECT_EQ(linesOf(text), lines);
}

TEST(TextLines, PairsOfSurrogatesStayWholeBetweenTheParts) {
    for (std::size_t blanks : {131070U, 131071U, 131072U}) {
        std::string bytes = asUtf16(std::string(blanks, ' '), true);
        bytes += "\x3D\xD8\x2C\xDD";  // U+1F52C
        EXPECT_THAT(linesOf(bytes).at(0), testing::EndsWith(" \xF0\x9F\x94\xAC")) << blanks;
    }
}

TEST(TextLines, RefusesALineWithoutEnd) {
    const std::string text = "1\n" + std::string((std::size_t{1} << 23U) + 1000000, ' ');
    EXPECT_THAT(refusalOf([&] { (void)linesOf(text); }), HasSubstr("text: line 2: "));
}

TEST(Utf16, HalfAPairBecomesTheReplacement) {
    EXPECT_EQ(utf16ToUtf8(std::string_view("\x3D\xD8\x41\x00\x00", 5), std::endian::little),
              "\xEF\xBF\xBD"
              "A");
    EXPECT_EQ(utf16ToUtf8(std::string_view("\x00\xB5\x20\xAC", 4), std::endian::big), "µ€");
}

}  // namespace asperity::test
