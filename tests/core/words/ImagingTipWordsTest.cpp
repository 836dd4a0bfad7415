#include "core/Units.h"
#include "core/scene/Scene.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/words/SceneWords.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Ridges 50 nm high and 60 nm apart, as recorded by a tip of 20 nm.
Scene scannedRidges(double imagingTip, bool erode) {
    SceneDescription description = test::plainScene();
    description.sample.imagingTipRadius = imagingTip;
    description.sample.erode = erode;
    return buildScene(description, dilated(test::ridgedMap(25.0_nm), 20.0_nm));
}

bool says(const std::string& note, const std::string& words) {
    return note.find(words) != std::string::npos;
}

TEST(ImagingTipWords, IsSpokenOfInEveryScene) {
    EXPECT_TRUE(says(imagingTipNote(scannedRidges(0.0, false)), kScanHoldsItsTip));
    EXPECT_TRUE(says(imagingTipNote(scannedRidges(20.0_nm, false)), kScanHoldsItsTip));
    EXPECT_TRUE(says(imagingTipNote(scannedRidges(20.0_nm, false)), "% of the pixels"));
    EXPECT_TRUE(says(imagingTipNote(scannedRidges(20.0_nm, true)), "removed by erosion"));
    EXPECT_TRUE(says(imagingTipNote(scannedRidges(1.0_nm, true)), "narrower than a pixel"));
    EXPECT_TRUE(
        says(imagingTipWords(scannedRidges(0.0, false)), "Contains the imaging tip's shape"));
    EXPECT_TRUE(says(imagingTipWords(scannedRidges(20.0_nm, true)), "removed"));
}

/// The window said of an exact sphere that it holds the shape of a tip.
TEST(ImagingTipWords, AnExactShapeHoldsNone) {
    SceneDescription description = test::plainScene();
    description.sample.shape = {.kind = ShapeKind::Sphere, .radius = 100e-9, .size = 110e-9};
    const Scene sphere = buildScene(description);
    EXPECT_EQ(imagingTipWords(sphere), "Exact shape, no imaging tip");
    EXPECT_FALSE(says(imagingTipNote(sphere), kScanHoldsItsTip));
    EXPECT_TRUE(says(imagingTipNote(sphere), "no tip recorded"));
}

}  // namespace
}  // namespace asperity
