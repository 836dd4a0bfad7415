#include "core/Units.h"
#include "core/scene/SampleMaterials.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

SampleMaterial ofModulus(double modulus) { return {.elastic = {.youngsModulus = modulus}}; }

TEST(SampleHardness, IsTheStatedOneOrEstimatedFromAModulusOfAGigapascalOrMore) {
    SampleMaterial glass = ofModulus(70.0_GPa);
    EXPECT_EQ(hardnessOf(glass).source, HardnessSource::Estimated);
    EXPECT_DOUBLE_EQ(hardnessOf(glass).value, 3.5_GPa);
    glass.hardness = 9.0_GPa;
    EXPECT_EQ(hardnessOf(glass).source, HardnessSource::Stated);
    EXPECT_EQ(hardnessOf(glass).value, 9.0_GPa);
    EXPECT_EQ(hardnessOf(ofModulus(1.0_GPa)).source, HardnessSource::Estimated);
}

TEST(SampleHardness, IsUnknownOfSoftMaterialsAndOfSeveral) {
    EXPECT_EQ(hardnessOf(ofModulus(0.99_GPa)).source, HardnessSource::Unknown);
    EXPECT_EQ(hardnessOf(ofModulus(0.99_GPa)).value, 0.0);
    SampleMaterial mapped = ofModulus(70.0_GPa);
    mapped.maps.mask.emplace();
    EXPECT_EQ(hardnessOf(mapped).source, HardnessSource::Unknown);
}

/// Two values: a rubber whose hardness nobody knows, and one that does not yield.
TEST(SampleHardness, OfASampleThatDoesNotYieldThereIsNone) {
    SampleMaterial rubber = ofModulus(1.0_MPa);
    EXPECT_EQ(hardnessOf(rubber).source, HardnessSource::Unknown);
    rubber.yields = false;
    EXPECT_EQ(hardnessOf(rubber).source, HardnessSource::DoesNotYield);
    rubber.elastic.youngsModulus = 3.0_GPa;
    rubber.hardness = 1.0_GPa;
    EXPECT_EQ(hardnessOf(rubber).source, HardnessSource::DoesNotYield);
    EXPECT_EQ(hardnessOf(rubber).value, 0.0);
}

}  // namespace
}  // namespace asperity
