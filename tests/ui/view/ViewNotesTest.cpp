#include "ui/view/ViewLabels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ViewNotes, SayWhatThePictureDoesNotShowAsItIs) {
    const ViewNoteFacts plain{.tipRadius = 15e-9, .pixel = 1e-9, .width = 80e-9};
    EXPECT_THAT(viewNotes(plain), IsEmpty());
    ViewNoteFacts facts = plain;
    facts.heightScale = 3.5;
    facts.hasPerspective = true;
    facts.missesTrueTip = true;
    EXPECT_THAT(viewNotes(facts), ElementsAre("perspective: lengths not to scale", "heights ×3.5",
                                              "true tip: the instrument does not know it"));
    facts = plain;
    facts.hidesDeformation = true;
    EXPECT_THAT(viewNotes(facts), ElementsAre("deformation is not drawn"));
    facts = plain;
    facts.isFromBelow = true;
    EXPECT_THAT(viewNotes(facts), ElementsAre("from below: hills are hollows"));
    facts = plain;
    facts.pixel = 24e-9;
    EXPECT_THAT(viewNotes(facts),
                ElementsAre("Scan pixel 24 nm: coarse for a tip radius of 15 nm"));
    facts = plain;
    facts.width = 2e-9;
    EXPECT_THAT(viewNotes(facts), ElementsAre("Scan pixel 1 nm: coarse for this view"));
    facts = plain;
    facts.showsCap = true;
    EXPECT_THAT(viewNotes(facts), ElementsAre("tip radius 15 nm: only its lowest part is drawn"));
    EXPECT_EQ(tipAboveNote(12e-9), "tip 12 nm above the surface");
}

TEST(LabelBounds, KeepLabelsOffTheScaleBars) {
    const PixelRect view{0.0, 0.0, 220.0, 160.0};
    const PixelRect bars{0.0, 0.0, 90.0, 60.0};
    const PixelRect wide{-40.0, 8.0, 240.0, 21.0};  // of a reading at the bottom
    const PixelRect above = labelBounds(wide, view, bars);
    EXPECT_EQ(above.bottom, bars.top());
    EXPECT_EQ(above.top(), view.top());
    const PixelRect short_{140.0, 8.0, 70.0, 21.0};
    EXPECT_EQ(labelBounds(short_, view, bars).bottom, 0.0) << "beside them";
    EXPECT_EQ(labelBounds(wide, view, {}).bottom, 0.0) << "there are none";
    const PixelRect outside{20.0, -50.0, 40.0, 21.0};  // it would be moved over them
    EXPECT_EQ(labelBounds(outside, view, bars).bottom, bars.top());
}

}  // namespace
}  // namespace asperity
