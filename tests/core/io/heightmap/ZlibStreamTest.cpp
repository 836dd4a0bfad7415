#include "core/io/heightmap/ZlibStream.h"

#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <zlib.h>

namespace asperity::test {

namespace {

using testing::HasSubstr;

std::string packed(const std::string& text) {
    uLongf size = compressBound(text.size());
    std::string bytes(size, '\0');
    compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
             reinterpret_cast<const Bytef*>(text.data()), text.size());
    bytes.resize(size);
    return bytes;
}

std::string unpacked(const std::string& bytes, std::uint64_t size) {
    std::string text;
    appendUnpacked(text, MemoryBytes(bytes, "scan"), {0, bytes.size()}, size, "image");
    return text;
}

std::string refusalOfStream(const std::string& bytes, std::uint64_t size) {
    return refusalOf([&] { (void)unpacked(bytes, size); });
}

}  // namespace

TEST(ZlibStream, GivesWhatWasPacked) {
    std::string text;
    for (int i = 0; i < 100000; ++i) {
        text += std::to_string(7919L * i);
    }
    EXPECT_EQ(unpacked(packed(text), text.size()), text);
    EXPECT_EQ(unpacked(packed(""), 0), "");
    const std::string constant(5000000, 'z');
    EXPECT_EQ(unpacked(packed(constant), constant.size()), constant);
}

TEST(ZlibStream, AnotherSizeThanExpectedIsRefused) {
    const std::string bytes = packed(std::string(1000, 'a') + "b");
    EXPECT_THAT(refusalOfStream(bytes, 1000), HasSubstr("more than 1000 bytes"));
    EXPECT_THAT(refusalOfStream(bytes, 1002), HasSubstr("1001 bytes of 1002"));
}

TEST(ZlibStream, DamageIsRefused) {
    const std::string bytes = packed("some heights, and some more heights");
    EXPECT_THAT(refusalOfStream(bytes.substr(0, 10), 35), HasSubstr("ends early"));
    std::string damaged = bytes;
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    EXPECT_THAT(refusalOfStream(damaged, 35), HasSubstr("cannot be unpacked"));
    EXPECT_THAT(refusalOfStream("no zlib", 35), HasSubstr("cannot be unpacked"));
}

TEST(ZlibStream, SizeThatNoStreamOfThatLengthHoldsIsRefusedBeforeMemoryIsTaken) {
    EXPECT_THAT(refusalOfStream(packed("x"), std::uint64_t{1} << 50U), HasSubstr("cannot hold"));
    EXPECT_TRUE(mayUnpackTo(1000, 1000000));
    EXPECT_FALSE(mayUnpackTo(1000, 2000000));
}

}  // namespace asperity::test
