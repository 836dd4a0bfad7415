#include "core/scene/ForceModelOptions.h"

#include "core/scene/ModelTerm.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ForceModelOptions, AreNamedByWhatDiffersFromTheUsual) {
    EXPECT_EQ(nameOf(ForceModelOptions{.law = ContactLaw::Hertz}),
              std::string(nameOf(ContactLaw::Hertz)) + ", certified feet");
    EXPECT_EQ(nameOf({.law = ContactLaw::Jkr,
                      .solver = SolverTier::Table,
                      .closestPointSearch = SearchEffort::Local,
                      .decoupling = DecouplingTier::Planar,
                      .friction = false,
                      .curvature = false}),
              std::string(nameOf(ContactLaw::Jkr)) +
                  ", table, local feet, planar, without friction, sample curvature");
}

TEST(ForceModelOptions, DeformationMovesNoForce) {
    const ForceModelOptions drawn{.deformation = DeformationTier::FourPoint};
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
