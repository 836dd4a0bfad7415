#include "ui/view/ColorScale.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace asperity {
namespace {

std::vector<double> upTo(int count, double step) {
    std::vector<double> values;
    for (int i = 0; i <= count; ++i) {
        values.push_back(step * i);
    }
    return values;
}

TEST(ColorRange, IsThatOfItsRule) {
    ColorRange range(SurfaceQuantity::Height);
    const std::vector<double> values = upTo(1000, 1e-9);
    EXPECT_TRUE(range.fit(values, {}));
    EXPECT_EQ(range.range().low, 0.0);
    EXPECT_DOUBLE_EQ(range.range().high, 1e-6);
    range.fit(values, {.colors = {.rule = RangeRule::Percent}});
    EXPECT_DOUBLE_EQ(range.range().low, 1e-8);
    EXPECT_DOUBLE_EQ(range.range().high, 9.9e-7);
    range.fit(values, {.colors = {.rule = RangeRule::Permille}});
    EXPECT_DOUBLE_EQ(range.range().high, 9.99e-7);
    range.fit(values, {.colors = {.rule = RangeRule::Own, .low = -5e-9, .high = 7e-9}});
    EXPECT_EQ(range.range().low, -5e-9);
    EXPECT_EQ(range.range().high, 7e-9);
    EXPECT_FALSE(
        range.fit(values, {.colors = {.rule = RangeRule::Own, .low = -5e-9, .high = 7e-9}}));
}

TEST(ColorRange, StaysWhileItIsPinned) {
    ColorRange range(SurfaceQuantity::Height);
    range.fit(upTo(10, 1e-9), {});
    const ColorRange::Wish pinned{.colors = {.pinned = true}};
    EXPECT_TRUE(range.fit(upTo(10, 5e-9), pinned)) << "the data are others";
    EXPECT_DOUBLE_EQ(range.range().high, 1e-8);
    EXPECT_DOUBLE_EQ(range.data().high, 5e-8);
    range.fit(upTo(10, 5e-9), {});
    EXPECT_DOUBLE_EQ(range.range().high, 5e-8);
}

/// A flat scene after a grating was all one color, of the grating's range.
TEST(ColorRange, IsThatOfAnotherSceneThoughItIsFlat) {
    ColorRange range(SurfaceQuantity::Height);
    const ColorRange::Wish steady{.colors = {}, .isSteady = true};
    range.fit(upTo(10, 1e-9), steady);
    const std::vector<double> flat(10, 0.0);
    range.fit(flat, steady);
    EXPECT_GE(range.range().high, 1e-8) << "far from the tip of the same scene";
    range.forget();
    range.fit(flat, steady);
    EXPECT_LT(range.range().high, 1e-9);
    ColorRange first(SurfaceQuantity::Height);
    first.fit(flat, steady);
    EXPECT_LT(first.range().high, 1e-9) << "the bar of a flat scene ended at 1 m";
}

TEST(ColorRange, SaysWhatItClipsAndHowItWasChosen) {
    ColorRange range(SurfaceQuantity::Height);
    const QuantityColors own{.rule = RangeRule::Own, .low = 2e-9, .high = 5e-9};
    range.fit(upTo(10, 1e-9), {.colors = own});
    ColorScale scale{.quantity = QStringLiteral("height"), .low = 2e-9, .high = 5e-9};
    range.describe(scale, own);
    EXPECT_TRUE(scale.clipsLow());
    EXPECT_TRUE(scale.clipsHigh());
    EXPECT_EQ(scale.rule, QStringLiteral("own range"));
    range.describe(scale, {.rule = RangeRule::Percent});
    EXPECT_EQ(scale.rule, QStringLiteral("1–99 %"));
    range.describe(scale, {.rule = RangeRule::Percent, .pinned = true});
    EXPECT_EQ(scale.rule, QStringLiteral("pinned"));
}

TEST(ColorRange, HasZeroInTheMiddleOfTheDivergingMap) {
    ColorRange range(SurfaceQuantity::Residual);
    const QuantityColors diverging{.map = ColorMap::Diverging};
    range.fit(std::array{-1e-9, 3e-9}, {.colors = diverging, .isSigned = true});
    EXPECT_EQ(range.range().low, -3e-9);
    EXPECT_EQ(range.range().high, 3e-9);
    range.fit(std::array{-1e-9, 3e-9}, {.colors = {}, .isSigned = true});
    EXPECT_EQ(range.range().low, -1e-9) << "another map needs no middle";
}

TEST(ColorRange, OfEqualValuesIsNotEmptyAndNoNumbersChangeNothing) {
    ColorRange range(SurfaceQuantity::Height);
    range.fit(std::array{2e-9, 2e-9}, {});
    EXPECT_LT(range.range().low, 2e-9);
    EXPECT_GT(range.range().high, 2e-9);
    const ValueRange before = range.range();
    range.fit(std::array{std::numeric_limits<double>::quiet_NaN()}, {});
    EXPECT_EQ(range.range().low, before.low);
    EXPECT_FALSE(range.hasData());
}

}  // namespace
}  // namespace asperity
