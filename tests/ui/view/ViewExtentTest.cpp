#include "core/Units.h"
#include "ui/view/ViewCamera.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

const FramedSurface kSurface{.heights = {.low = -4.0_nm, .high = 6.0_nm}, .halfWidth = 40.0_nm};

TEST(ViewExtent, HoldsTheSurfaceAndTheTipAboveIt) {
    ViewExtent extent;
    EXPECT_TRUE(extent.isFitWanted());
    extent.fit(kSurface, 30.0_nm);
    EXPECT_FALSE(extent.isFitWanted());
    const FrameBox box = extent.box(kSurface, {100.0_nm, 50.0_nm});
    EXPECT_NEAR(box.middle.z(), 1.0_nm, 1e-20);
    EXPECT_NEAR(box.middle.x(), 100.0_nm, 1e-20);
    EXPECT_NEAR(box.above, 5.0_nm, 1e-20);
    EXPECT_NEAR(box.tipTop, 35.0_nm, 1e-20);
    EXPECT_LT(extent.bottom(kSurface), -4.0_nm);
    EXPECT_NEAR(box.middle.z() - box.below, extent.bottom(kSurface), 1e-20);
}

TEST(ViewExtent, MakesRoomForADentAndKeepsIt) {
    ViewExtent extent;
    extent.fit(kSurface, 30.0_nm);
    const double before = extent.bottom(kSurface);
    EXPECT_FALSE(extent.makeRoomFor(-5.0_nm, kSurface)) << "there is room";
    EXPECT_TRUE(extent.makeRoomFor(-20.0_nm, kSurface));
    const double deep = extent.bottom(kSurface);
    EXPECT_LT(deep, -20.0_nm);
    EXPECT_FALSE(extent.makeRoomFor(-5.0_nm, kSurface));
    EXPECT_EQ(extent.bottom(kSurface), deep) << "it does not shrink";
    extent.forget();
    EXPECT_EQ(extent.bottom(kSurface), before);
}

/// The block stayed thick after a deep dent.
TEST(ViewExtent, IsAsThickAsBeforeOnceTheTipHasLeft) {
    for (const double usualDent : {0.0, 12.0_nm}) {
        ViewExtent extent;
        extent.fit(kSurface, 30.0_nm, usualDent);
        const double before = extent.bottom(kSurface);
        const double middle = extent.box(kSurface, Vector2::Zero()).middle.z();
        EXPECT_FALSE(extent.release());
        EXPECT_TRUE(extent.makeRoomFor(-40.0_nm, kSurface));
        extent.lower(3.0_nm);
        EXPECT_TRUE(extent.release());
        EXPECT_EQ(extent.bottom(kSurface), before);
        EXPECT_EQ(extent.box(kSurface, Vector2::Zero()).middle.z(), middle);
        EXPECT_FALSE(extent.release());
    }
}

/// A dent nearly as deep as the frame is wide had the lower edge of the block out of the view.
TEST(ViewExtent, HoldsADentOfTheUsualDepthFromTheFirst) {
    ViewExtent extent;
    extent.fit(kSurface, 30.0_nm);
    const double shallow = extent.bottom(kSurface);
    extent.fit(kSurface, 30.0_nm, 0.5_nm);
    EXPECT_EQ(extent.bottom(kSurface), shallow) << "the block has room for that";
    extent.fit(kSurface, 30.0_nm, 35.0_nm);
    const double deep = extent.bottom(kSurface);
    EXPECT_LT(deep, -4.0_nm - 35.0_nm);
    const FrameBox box = extent.box(kSurface, Vector2::Zero());
    EXPECT_NEAR(box.middle.z() - box.below, deep, 1e-20) << "in the view";
    EXPECT_FALSE(extent.makeRoomFor(-4.0_nm - 35.0_nm, kSurface)) << "it is there already";
}

TEST(ViewExtent, StretchesWithTheHeights) {
    FramedSurface stretched = kSurface;
    stretched.heightScale = 5.0;
    ViewExtent extent;
    extent.fit(stretched, 30.0_nm);
    EXPECT_NEAR(extent.box(stretched, Vector2::Zero()).above, 25.0_nm, 1e-20);
    EXPECT_GT(extent.bottom(stretched), extent.bottom(kSurface)) << "as deep in the picture";
}

}  // namespace
}  // namespace asperity
