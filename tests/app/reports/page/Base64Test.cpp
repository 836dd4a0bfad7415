#include "app/reports/page/Base64.h"

#include <gtest/gtest.h>

#include <string>

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

}  // namespace
}  // namespace asperity
