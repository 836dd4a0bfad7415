#include "core/io/Base64.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// The examples of RFC 4648, section 10.
TEST(Base64, EncodesTheExamplesOfItsStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, EncodesAnyByte) {
    EXPECT_EQ(base64(std::string("\0\xff\xfe", 3)), "AP/+");
    EXPECT_EQ(base64("\x89PNG\r\n\x1a\n"), "iVBORw0KGgo=");
}

std::string decoded(std::string_view letters) {
    std::string bytes;
    EXPECT_TRUE(appendBase64(bytes, letters)) << letters;
    return bytes;
}

TEST(Base64, IsThatOfRfc4648) {
    EXPECT_EQ(decoded(""), "");
    EXPECT_EQ(decoded("Zg=="), "f");
    EXPECT_EQ(decoded("Zm8="), "fo");
    EXPECT_EQ(decoded("Zm9v"), "foo");
    EXPECT_EQ(decoded("Zm9vYmFy"), "foobar");
    EXPECT_EQ(decoded("+/8A"), std::string("\xfb\xff\0", 3));
}

TEST(Base64, GoesOnBehindPadding) {
    EXPECT_EQ(decoded("Zg==Zm8=Zm9v"), "ffofoo");
    std::string letters;
    std::string bytes;
    for (int i = 0; i < 400'000; ++i) {
        letters += "Zm9v";
        bytes += "foo";
    }
    EXPECT_EQ(decoded(letters + "Zg=="), bytes + "f");
}

TEST(Base64, RefusesOtherLetters) {
    std::string bytes;
    EXPECT_FALSE(appendBase64(bytes, "Zm9"));
    EXPECT_FALSE(appendBase64(bytes, "Zm9!"));
    EXPECT_FALSE(appendBase64(bytes, "Z==="));
    EXPECT_FALSE(appendBase64(bytes, "=m9v"));
}

}  // namespace
}  // namespace asperity
