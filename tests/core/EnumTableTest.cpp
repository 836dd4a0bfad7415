#include "core/EnumTable.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {

enum class Weather { Dry, Wet };

template <>
inline constexpr auto kEnumTable<Weather> =
    std::to_array<EnumRow<Weather>>({{Weather::Wet, "wet", "rain or snow"}, {Weather::Dry, "dry"}});

enum class Season { Summer, Winter };

template <>
inline constexpr auto
    kEnumTable<Season> = std::to_array<EnumRow<Season>>({{Season::Summer, "summer"}});

namespace {

static_assert(HasEnumTable<Weather>);
static_assert(!HasEnumTable<int>);
static_assert(isNamed<Weather::Wet>() && !isNamed<static_cast<Weather>(2)>());
static_assert(isComplete<Weather>() && !isComplete<Season>());
static_assert(fromKey<Weather>("wet") == Weather::Wet);

TEST(EnumTable, KeysAndNamesComeFromTheTable) {
    EXPECT_STREQ(keyOf(Weather::Wet), "wet");
    EXPECT_STREQ(nameOf(Weather::Wet), "rain or snow");
    EXPECT_STREQ(nameOf(Weather::Dry), "dry") << "where there is nothing else to say";
    EXPECT_STREQ(keyOf(static_cast<Weather>(7)), "unknown");
}

TEST(EnumTable, KeysLeadBackToTheirValues) {
    for (const Weather weather : kValues<Weather>) {
        EXPECT_EQ(fromKey<Weather>(keyOf(weather)), weather);
    }
    EXPECT_EQ(fromKey<Weather>("rain or snow"), std::nullopt);
}

TEST(EnumTable, ListsAreInTheOrderOfTheTable) {
    EXPECT_EQ(keyList<Weather>(), "wet, dry");
    EXPECT_EQ(std::vector(kValues<Weather>.begin(), kValues<Weather>.end()),
              (std::vector{Weather::Wet, Weather::Dry}));
}

}  // namespace
}  // namespace asperity
