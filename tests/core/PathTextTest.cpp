
#include "core/PrintableText.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(PathText, OfUtf8IsThePathItself) {
    for (const char* path : {"scan.gsf", "/data/25 µm 50%.gsf", "", "file:/x", "file://x"}) {
        EXPECT_EQ(pathText(path), path);
        EXPECT_EQ(pathFromText(path), path);
    }
}

TEST(PathText, OfOtherBytesIsAFileUri) {
    EXPECT_EQ(pathText("/data/25 \xB5m 50%.gsf"), "file:///data/25%20%B5m%2050%25.gsf");
    EXPECT_EQ(pathFromText("file:///data/25%20%b5m%2050%25.gsf"), "/data/25 \xB5m 50%.gsf");
}

TEST(PathText, CarriesEveryByteThatAFileSystemAllows) {
    std::string name = "/";
    for (int byte = 1; byte < 256; ++byte) {
        name += static_cast<char>(byte);
    }
    EXPECT_TRUE(isUtf8(pathText(name)));
    EXPECT_EQ(pathFromText(pathText(name)), name);
    // One that reads as a URI itself.
    EXPECT_EQ(pathFromText(pathText("file:///a%41")), std::filesystem::absolute("file:///a%41"));
}

TEST(PathText, OfARelativePathStaysFindable) {
    EXPECT_EQ(pathFromText(pathText("sc\xB5n.gsf")), std::filesystem::absolute("sc\xB5n.gsf"));
}

TEST(PathText, RefusesDamagedUris) {
    for (const char* text : {"file:///a%", "file:///a%4", "file:///a%4G", "file:///a%00b"}) {
        EXPECT_EQ(pathFromText(text), std::nullopt) << text;
    }
}

}  // namespace
}  // namespace asperity
