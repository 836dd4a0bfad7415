#include "core/Error.h"
#include "core/Units.h"
#include "core/scene/Scene.h"
#include "core/surface/imaging/TipErosion.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

/// A scene of ridges 50 nm high and 60 nm apart, as recorded by a tip of 20 nm, which does not fit
/// between them.
Scene scannedRidges(double imagingTip, bool erode) {
    SceneDescription description = test::plainScene();
    description.sample.imagingTipRadius = imagingTip;
    description.sample.erode = erode;
    return buildScene(description, dilated(test::ridgedMap(25.0_nm), 20.0_nm));
}

/// The ridge at its half height, 7.5 nm from the crest, must be met again.
TEST(ImagingTip, ErosionBringsTheSlopesOfRidgesBack) {
    const double there = test::ridgedMap(25.0_nm).at(32, 11);
    const double recorded = scannedRidges(20.0_nm, false).surface.at(23.0_nm, 63.0_nm).height;
    const double eroded = scannedRidges(20.0_nm, true).surface.at(23.0_nm, 63.0_nm).height;
    EXPECT_GT(recorded, there + 5.0_nm);
    EXPECT_NEAR(eroded, there, 1.0_nm);
}

TEST(ImagingTip, WithoutErosionTheMapStaysWhatItIs) {
    const Scene unknown = scannedRidges(0.0, false);
    const Scene stated = scannedRidges(20.0_nm, false);
    EXPECT_EQ(unknown.surface.grid().controlHeights, stated.surface.grid().controlHeights);
    EXPECT_FALSE(unknown.certainty.isKnown());
    EXPECT_TRUE(stated.certainty.isKnown());
}

TEST(ImagingTip, CrestsAreCertainAndGroovesAreNot) {
    const CertaintyMap certainty = scannedRidges(20.0_nm, true).certainty;
    EXPECT_FALSE(certainty.isUncertain(75.0_nm, 64.0_nm)) << "crest";
    EXPECT_TRUE(certainty.isUncertain(45.0_nm, 64.0_nm)) << "groove";
    EXPECT_GT(certainty.certainShare(), 0.1);
    EXPECT_LT(certainty.certainShare(), 0.7);
}

TEST(ImagingTip, AnotherMaterialKeepsTheCertainty) {
    const Scene scene = scannedRidges(20.0_nm, true);
    const SampleMaterial material = scene.description.sample.material;
    const Scene other = withMaterial(scene, material);
    EXPECT_EQ(other.certainty.certainShare(), scene.certainty.certainShare());
}

TEST(ImagingTip, IsRefusedWhereItMakesNoSense) {
    EXPECT_THROW((void)scannedRidges(-1.0_nm, false), Error);
    EXPECT_THROW((void)scannedRidges(NAN, false), Error);
    EXPECT_THROW((void)scannedRidges(2.0, false), Error);
    try {
        (void)scannedRidges(0.0, true);
        FAIL() << "erosion by a tip that nobody knows";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("imaging_tip_radius_m"), std::string::npos);
    }
}

}  // namespace
}  // namespace asperity
