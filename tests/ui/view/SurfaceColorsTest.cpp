#include "ui/view/SurfaceColors.h"

#include "core/Units.h"
#include "vtkplugins/pictures/Palette.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(SurfaceColors, ShowHeightAtRestAndDisplacementWhereItIsLarge) {
    SurfaceColors colors;
    EXPECT_TRUE(colors.fitRest(std::array{0.0, 10.0_nm}));
    EXPECT_TRUE(colors.fitDisplacement(1.5_nm));
    const Color rest = colors.ofDeformed(5.0_nm, 0.0);
    const Color pushed = colors.ofDeformed(5.0_nm, 1.5_nm);
    const Color pulled = colors.ofDeformed(5.0_nm, -1.5_nm);
    EXPECT_EQ(rest, colors.ofRest(5.0_nm));
    EXPECT_GT(pushed.blue, pushed.red + 60) << "pushed in: blue";
    EXPECT_GT(pulled.red, pulled.blue + 60) << "pulled out: orange";
    EXPECT_GT(rest.green, rest.red);
    EXPECT_EQ(colors.ofDeformed(5.0_nm, 0.01_nm), rest) << "hardly";
}

TEST(SurfaceColors, OfAnotherQuantityStayWhereTheTipHasMovedTheSurface) {
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Slope;
    SurfaceColors colors;
    colors.setLook(look, SurfaceField(SurfaceQuantity::Slope));
    colors.fitRest(std::array{0.0, 0.5});
    colors.fitDisplacement(1.5_nm);
    EXPECT_EQ(colors.ofDeformed(0.2, 1.5_nm), colors.ofRest(0.2));
    EXPECT_TRUE(colors.displacementScale().colors.empty()) << "no bar of what is not shown";
    EXPECT_EQ(colors.scale().quantity, QStringLiteral("slope"));
    EXPECT_EQ(colors.scale().unit, QStringLiteral("rad"));
}

TEST(SurfaceColors, RangesAreSteadyAndHoldTheValues) {
    SurfaceColors colors;
    colors.fitDisplacement(1.5_nm);
    EXPECT_FALSE(colors.fitDisplacement(1.3_nm));
    EXPECT_TRUE(colors.fitDisplacement(4.0_nm));
    const ColorScale scale = colors.displacementScale();
    EXPECT_GE(scale.high, 4.0_nm);
    EXPECT_DOUBLE_EQ(scale.low, -scale.high);
    EXPECT_EQ(scale.unit, QStringLiteral("m"));
    ASSERT_GE(scale.colors.size(), 2U);
    EXPECT_GT(scale.colors.front().red(), scale.colors.front().blue());
    EXPECT_GT(scale.colors.back().blue(), scale.colors.back().red());
    colors.fitRest(std::array{-3.0_nm, 8.0_nm});
    EXPECT_LE(colors.scale().low, -3.0_nm);
    EXPECT_GE(colors.scale().high, 8.0_nm);
    EXPECT_FALSE(colors.scale().clipsLow());
}

TEST(SurfaceColors, OfWhatHasNoValueAreNoneOfTheMap) {
    SurfaceColors colors;
    EXPECT_EQ(colors.ofRest(kNone), palette::kNoData);
    EXPECT_EQ(colors.ofLive(kNone), palette::kUndefined);
}

TEST(SurfaceColors, TakeTheMapThatIsChosen) {
    SurfaceColors colors;
    SurfaceLook look;
    look.of(SurfaceQuantity::Height).map = ColorMap::Gray;
    colors.setLook(look, SurfaceField());
    colors.fitRest(std::array{0.0, 10.0_nm});
    const Color middle = colors.ofRest(4.0_nm);
    EXPECT_EQ(middle.red, middle.green);
    EXPECT_EQ(middle.green, middle.blue);
}

TEST(SurfaceColors, SayWhyALiveQuantityHasNoValues) {
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Pressure;
    SurfaceColors colors;
    colors.setLook(look, SurfaceField(SurfaceQuantity::Pressure));
    EXPECT_EQ(colors.scale().note, QStringLiteral("no tip in the view"));
    colors.fitLive(std::array{0.0, 0.0});
    EXPECT_EQ(colors.scale().note, QStringLiteral("no contact"));
    EXPECT_TRUE(colors.fitLive(std::array{0.0, 3e9, -1e8}));
    EXPECT_TRUE(colors.scale().note.isEmpty());
    const double high = colors.scale().high;
    EXPECT_GE(high, 3e9);
    EXPECT_FALSE(colors.fitLive(std::array{0.0, 2.9e9, -1e8})) << "the same range";
    EXPECT_TRUE(colors.fitLive(std::array{0.0, 0.0})) << "the note changes";
    EXPECT_EQ(colors.scale().high, high) << "the range stays for the next contact";
}

TEST(SurfaceColors, TellWhenALiveValueLeavesAnOwnRange) {
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Pressure;
    look.of(SurfaceQuantity::Pressure).rule = RangeRule::Own;
    look.of(SurfaceQuantity::Pressure).low = 0.0;
    look.of(SurfaceQuantity::Pressure).high = 1e9;
    SurfaceColors colors;
    colors.setLook(look, SurfaceField(SurfaceQuantity::Pressure));
    colors.fitLive(std::array{0.0, 5e8});
    EXPECT_FALSE(colors.scale().clipsHigh());
    EXPECT_TRUE(colors.fitLive(std::array{0.0, 2e9}));
    EXPECT_TRUE(colors.scale().clipsHigh());
}

TEST(SurfaceColors, KeepThePinnedRangeOfAQuantityThatIsLeftAndChosenAgain) {
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Slope;
    look.of(SurfaceQuantity::Slope).pinned = true;
    SurfaceColors colors;
    colors.setLook(look, SurfaceField(SurfaceQuantity::Slope));
    colors.fitRest(std::array{0.0, 0.5});
    colors.setLook(look, SurfaceField());  // heights, while something is read
    colors.fitRest(std::array{0.0, 1e-8});
    colors.setLook(look, SurfaceField(SurfaceQuantity::Slope));
    colors.fitRest(std::array{0.0, 1.5});
    EXPECT_EQ(colors.scale().high, 0.5);
    EXPECT_TRUE(colors.scale().clipsHigh());
}

/// A flat scene after a grating was all one color.
TEST(SurfaceColors, OfAnotherSceneFollowItsValuesUnlessTheyArePinned) {
    for (const bool pinned : {false, true}) {
        SurfaceLook look;
        look.of(SurfaceQuantity::Height).pinned = pinned;
        SurfaceColors colors;
        colors.setLook(look, SurfaceField());
        colors.fitRest(std::array{-200.0_nm, 200.0_nm});
        colors.fitHeights(-200.0_nm, 200.0_nm);
        const double before = colors.scale().high;
        colors.forgetScene();
        colors.fitRest(std::array{-110.0_nm, 110.0_nm});
        colors.fitHeights(-110.0_nm, 110.0_nm);
        EXPECT_EQ(colors.scale().high == before, pinned);
        EXPECT_LT(colors.heightRange().high, 161.0_nm);
        if (!pinned) {
            EXPECT_LT(colors.scale().high, 161.0_nm);
        }
    }
}

}  // namespace
}  // namespace asperity
