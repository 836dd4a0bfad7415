#include "core/io/hdf5/Hdf5Content.h"

#include "tests/core/io/hdf5/ContentText.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace asperity::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Kind = Hdf5Item::Kind;

Hdf5Content handedOver(const std::string& text) {
    return {std::make_shared<OwnedBytes>(text, "content"), "a.h5"};
}

std::string refusal(const std::string& text) {
    return refusalOf([&] { (void)handedOver(text); });
}

std::string smallContent() {
    ContentText text;
    text.start('g', "/");
    text.start('a', "/@name")
        .values(Hdf5Type::Text, 4, {}, true)
        .add(std::string_view("a\0\0\0", 4));
    text.start('d', "/z").values(Hdf5Type::Signed, 2, {2, 3}, true);
    for (const std::int16_t number : {-1, 2, 3, 4, 5, 6}) {
        text.put(number);
    }
    text.start('d', "/far").values(Hdf5Type::Real, 8, {1'000'000}, false);
    return text.ended();
}

TEST(Hdf5Content, HasWhatWasHandedOver) {
    const Hdf5Content content = handedOver(smallContent());
    ASSERT_EQ(content.items().size(), 4U);
    EXPECT_EQ(content.text(Kind::Attribute, "/@name"), "a");
    EXPECT_EQ(content.text(Kind::Dataset, "/z"), "") << "these are numbers";
    const Hdf5Item* const item = content.find(Kind::Dataset, "/z");
    ASSERT_NE(item, nullptr);
    EXPECT_THAT(item->shape, ElementsAre(2U, 3U));
    std::array<double, 3> numbers{};
    content.read(*item, 3, numbers);
    EXPECT_THAT(numbers, ElementsAre(4.0, 5.0, 6.0));
    content.read(*item, 0, std::span(numbers).first(1));
    EXPECT_EQ(numbers[0], -1.0);
    EXPECT_EQ(content.find(Kind::Group, "/z"), nullptr);
}

TEST(Hdf5Content, RefusesValuesThatAreNotThere) {
    const Hdf5Content content = handedOver(smallContent());
    std::array<double, 4> numbers{};
    const auto reading = [&](const char* path, std::uint64_t first) {
        return refusalOf([&] { content.read(*content.find(Kind::Dataset, path), first, numbers); });
    };
    EXPECT_EQ(reading("/z", 2), "");
    EXPECT_THAT(reading("/z", 3), HasSubstr("a.h5: /z: expected 4 values from number 3 on"));
    EXPECT_THAT(reading("/z", 1ULL << 63U), HasSubstr("expected 4 values"));
    EXPECT_THAT(reading("/far", 0), HasSubstr("expected 4 values"));
}

TEST(Hdf5Content, RefusesAnythingThatIsNotWhole) {
    const std::string whole = smallContent();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_THAT(refusal(whole.substr(0, length)), HasSubstr("a.h5: it is damaged")) << length;
    }
    EXPECT_THAT(refusal(whole + "x"), HasSubstr("it is damaged"));
    for (std::size_t offset = 0; offset < whole.size(); ++offset) {
        for (const int bit : {0, 3, 7}) {
            std::string damaged = whole;
            damaged[offset] = static_cast<char>(damaged[offset] ^ (1 << bit));
            (void)refusal(damaged);  // read or refused
        }
    }
    ContentText huge;
    huge.start('d', "/z").values(Hdf5Type::Real, 8, {1ULL << 62U, 1ULL << 62U}, false);
    EXPECT_THAT(refusal(huge.ended()), HasSubstr("it is damaged")) << "more values than numbers";
}

}  // namespace
}  // namespace asperity::test
