#include "core/Units.h"
#include "ui/view/TipLayer.h"
#include "ui/view/ViewFrame.h"
#include "vtkplugins/module/vtkAspTipSource.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

TEST(TipGear, DrawsOnlyTheLowestPartOfATipThatWouldFillTheFrame) {
    const GearScale usual{.halfWidth = 72.0_nm, .tipRadius = 30.0_nm};
    EXPECT_FALSE(usual.isCap());
    EXPECT_GT(usual.tipHeight(), usual.tipRadius);
    const GearScale blunt{.halfWidth = 72.0_nm, .tipRadius = 2.0_um};
    EXPECT_TRUE(blunt.isCap());
    EXPECT_FALSE(blunt.showsLever());
    const double width = TipOutline{{.radius = 2.0_um}}.radius(blunt.tipHeight());
    EXPECT_LT(width, 0.7 * blunt.halfWidth);
    EXPECT_GT(width, 0.5 * blunt.halfWidth);
    EXPECT_GT(blunt.headroom(), 0.5 * blunt.halfWidth) << "for the arrow";
}

TEST(TipGear, TheContactShowsThroughItsEndAndItFadesAwayAtTheTop) {
    const TipOpacity tip{.apex = 2.0_nm, .clear = 10.0_nm, .top = 62.0_nm};
    EXPECT_LT(tip.at(2.0_nm), 0.35);
    EXPECT_LT(tip.at(11.0_nm), 0.35);
    EXPECT_GT(tip.at(30.0_nm), 0.8);
    EXPECT_NEAR(tip.at(62.0_nm), 0.0, 1e-12);
    TipOpacity closed = tip;
    closed.isOpen = false;
    EXPECT_EQ(closed.at(62.0_nm), tip.at(30.0_nm)) << "it ends in its lever";
    TipOpacity cap = tip;
    cap.isCap = true;
    EXPECT_EQ(cap.at(2.0_nm), cap.at(30.0_nm));
    EXPECT_LT(cap.at(30.0_nm), 0.5);
}

TEST(TipGear, EndsWhereItWouldLeaveThePicture) {
    GearScale scale{.halfWidth = 72.0_nm, .tipRadius = 30.0_nm};
    const double usual = scale.tipHeight();
    scale.room = 0.5 * usual;
    EXPECT_EQ(scale.tipHeight(), 0.5 * usual);
    EXPECT_EQ(scale.headroom(), usual) << "the picture has room for all of it";
}

/// Widest position of a drawn tip at its end [m].
double drawnRadius(const RoundTip& tip, double reach, double height) {
    vtkNew<vtkAspTipSource> source;
    source->SetRadius(tip.radius);
    source->SetHalfAngle(tip.shankHalfAngle());
    source->SetParaboloidReach(reach);
    source->SetHeight(height);
    source->Update();
    double bounds[6];
    source->GetOutput()->GetBounds(bounds);
    return bounds[1];
}

TEST(TipGear, TheOutlineIsThatOfTheDrawnTip) {
    for (const RoundTip& tip : {RoundTip{15.0_nm}, RoundTip{15.0_nm, 0.5}}) {
        for (const double reach : {0.0, 40.0_nm}) {
            for (const double height : {1.0_nm, 9.0_nm, 30.0_nm, 130.0_nm}) {
                EXPECT_NEAR((TipOutline{tip, reach}.radius(height)),
                            drawnRadius(tip, reach, height), 1e-12)
                    << tip.coneHalfAngle << " " << reach << " " << height;
            }
        }
    }
    EXPECT_EQ(TipOutline{RoundTip{15.0_nm}}.frameAround(-1.0_nm), 0.0);
}

}  // namespace
}  // namespace asperity
