#include "core/io/heightmap/HeaderFields.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace asperity::test {

namespace {

using Texts = std::map<std::string, std::string>;

constexpr TextQuota kTwoOfTen{.count = 2, .bytes = 10};

}  // namespace

TEST(BoundedTexts, KeepsTheFirstTextOrTheLast) {
    BoundedTexts texts;
    texts.add("first", "1");
    texts.add("first", "2");
    texts.set("last", "1");
    texts.set("last", "2");
    EXPECT_EQ(texts.all(), (Texts{{"first", "1"}, {"last", "2"}}));
    EXPECT_FALSE(texts.isCut());
}

TEST(BoundedTexts, LeavesOutWhatIsBeyondTheNumber) {
    BoundedTexts texts(kTwoOfTen);
    texts.add(Texts{{"a", "1"}, {"b", "2"}});
    texts.add("a", "3");
    EXPECT_FALSE(texts.isCut());
    texts.add("c", "3");
    EXPECT_EQ(texts.all(), (Texts{{"a", "1"}, {"b", "2"}}));
    EXPECT_TRUE(texts.isCut());
}

TEST(BoundedTexts, LeavesOutATextThatIsTooLongAndKeepsOthers) {
    BoundedTexts texts(kTwoOfTen);
    texts.add("long", "1234567");
    texts.add("exact", "12345");
    EXPECT_EQ(texts.all(), (Texts{{"exact", "12345"}}));
    EXPECT_TRUE(texts.isCut());
}

TEST(BoundedTexts, CountsWhatIsRemovedNoMore) {
    BoundedTexts texts(kTwoOfTen);
    texts.add("a", "123456789");
    texts.set("a", "987654321");
    texts.remove("a");
    texts.add("b", "123456789");
    EXPECT_EQ(texts.all(), (Texts{{"b", "123456789"}}));
    EXPECT_FALSE(texts.isCut());
}

TEST(BoundedTexts, KeepTheOldTextWhereTheNewOneIsTooLong) {
    BoundedTexts texts(kTwoOfTen);
    texts.set("a", "1234");
    texts.set("b", "1234");
    texts.set("a", "12345");
    EXPECT_EQ(texts.all(), (Texts{{"a", "1234"}, {"b", "1234"}}));
    EXPECT_TRUE(texts.isCut());
    texts.set("a", "1");
    texts.set("b", "1234567");
    EXPECT_EQ(texts.all(), (Texts{{"a", "1"}, {"b", "1234567"}}));
}

TEST(BoundedTexts, AreCutWhereThoseAreThatWereAdded) {
    BoundedTexts cut(kTwoOfTen);
    cut.add("long", "1234567");
    BoundedTexts texts;
    texts.add(cut);
    EXPECT_TRUE(texts.isCut());
}

/// However many images a file has, their texts together are bounded.
TEST(BoundedTexts, ShareAQuotaAmongManyImages) {
    constexpr TextQuota kOne;
    constexpr std::size_t kShares = TextQuota::kFullShares;
    for (const std::size_t images : {0U, 1U, 32U, 33U, 128U, 1024U}) {
        const TextQuota each = TextQuota::ofEach(images);
        EXPECT_LE(each.count, kOne.count);
        EXPECT_LE(each.count * images, kShares * kOne.count);
        EXPECT_LE(each.bytes * images, kShares * kOne.bytes);
        EXPECT_GE(each.count, images > kShares ? kShares * kOne.count / (images + 1) : kOne.count);
    }
}

/// A stack of images of an instrument that writes many texts with each.
TEST(BoundedTexts, OfAnInstrumentFitInEachOf512Images) {
    const TextQuota each = TextQuota::ofEach(512);
    EXPECT_GE(each.count, 1000U);
    EXPECT_GE(each.bytes, 40'000U);
}

}  // namespace asperity::test
