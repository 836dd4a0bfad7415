#include "ui/view/ColorScale.h"

#include "vtkplugins/pictures/ColorMaps.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace asperity {
namespace {

TEST(ColorScale, HoldsTheColorsOfItsTable) {
    const ColorTable table(ColorMap::Viridis, -1e-9, 3e-9);
    const ColorScale scale = scaleOf(table, QStringLiteral("height"), QStringLiteral("m"));
    EXPECT_EQ(scale.low, -1e-9);
    EXPECT_EQ(scale.high, 3e-9);
    ASSERT_GE(scale.colors.size(), 2U);
    const Color last = table.of(3e-9);
    EXPECT_EQ(scale.colors.back(), QColor(last.red, last.green, last.blue));
    EXPECT_FALSE(scale.clipsLow()) << "no data: nothing is clipped";
    EXPECT_FALSE(scale.clipsHigh());
}

TEST(ColorScale, ShowsEachUnitAsPeopleReadIt) {
    EXPECT_EQ(shownValue(1.234e-9, QStringLiteral("m")), QStringLiteral("1.23 nm"));
    EXPECT_EQ(shownValue(2.5e9, QStringLiteral("Pa")), QStringLiteral("2.5 GPa"));
    EXPECT_EQ(shownValue(std::numbers::pi / 4.0, QStringLiteral("rad")), QStringLiteral("45 °"));
    EXPECT_EQ(shownValue(1.692e-17, QStringLiteral("J")), QStringLiteral("16.9 aJ"));
    EXPECT_EQ(shownValue(-2.0, QStringLiteral("J")), QStringLiteral("-2 J"));
    EXPECT_EQ(shownValue(12.0, QStringLiteral("mV")), QStringLiteral("12 mV"))
        << "no prefix before a prefix";
    EXPECT_EQ(shownValue(0.012, QStringLiteral("V")), QStringLiteral("12 mV"));
    EXPECT_EQ(shownValue(0.5, QStringLiteral("1")), QStringLiteral("0.5"));
    EXPECT_EQ(shownValue(120.0, QStringLiteral("deg")), QStringLiteral("120 deg"));
    EXPECT_EQ(shownValue(-0.0, QStringLiteral("m")), QStringLiteral("0 m"));
    EXPECT_EQ(shownValue(std::numeric_limits<double>::quiet_NaN(), QStringLiteral("m")),
              QStringLiteral("–"));
}

}  // namespace
}  // namespace asperity
