#include "core/scene/ForceModelOptions.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ForceModelOptions, DeformationMovesNoForce) {
    const ForceModelOptions drawn{.deformation = DeformationModel::FourPoint};
    EXPECT_NE(drawn, ForceModelOptions{});
    EXPECT_EQ(ofForce(drawn), ForceModelOptions{});
}

TEST(ForceModelOptions, UnderTheExactSphereTheSampleIsFlatAnyway) {
    const ForceModelOptions sphere{.law = ContactLaw::SphereJkr};
    ForceModelOptions flat = sphere;
    flat.curvature = false;
    EXPECT_EQ(ofForce(flat), sphere);
    flat.law = ContactLaw::Jkr;
    EXPECT_NE(ofForce(flat), ofForce({.law = ContactLaw::Jkr}));
}

}  // namespace
}  // namespace asperity
