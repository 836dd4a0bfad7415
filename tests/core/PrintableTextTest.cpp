#include "core/PrintableText.h"

#include "core/Error.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

using namespace std::string_literals;

TEST(PrintableText, KeepsWhatIsShown) {
    EXPECT_EQ(printable("25 µm \\*File list"), "25 µm \\*File list");
    EXPECT_EQ(printable(""), "");
}

TEST(PrintableText, EscapesWhatATerminalObeys) {
    EXPECT_EQ(printable("a\x1b[31mb\nc\r\td\a\x7f"), "a\\e[31mb\\nc\\r\\td\\x07\\x7f");
    EXPECT_EQ(printable("nul\0end"s), "nul\\x00end");
    EXPECT_EQ(printable("\u009B31m"), "\\xc2\\x9b31m");       // CSI as one character
    EXPECT_EQ(printable("\u202Efsg"), "\\xe2\\x80\\xaefsg");  // right-to-left override
    EXPECT_EQ(printable("sc\xB5n"), "sc\\xb5n");              // Latin-1
}

TEST(PrintableText, LinesStayLines) {
    EXPECT_EQ(printableLines("one\x1b\ntwo\n"), "one\\e\ntwo\n");
}

TEST(PrintableText, IsWhatEveryErrorSays) {
    EXPECT_STREQ(Error("a\nb").what(), "a\\nb");
    EXPECT_STREQ(InputError("x\x1b", "line 1", "found '\x07'").what(),
                 "x\\e: line 1: found '\\x07'");
}

}  // namespace
}  // namespace asperity
