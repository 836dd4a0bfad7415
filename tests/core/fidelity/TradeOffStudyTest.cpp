#include "core/fidelity/TradeOffStudy.h"

#include "core/Units.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity {
namespace {

class TradeOffStudy : public ::testing::Test {
protected:
    static std::vector<TierResult> study(const SceneDescription& description) {
        const Scene scene = buildScene(description, test::flatMap());
        return studyTradeOff(
            scene, {.path = {.duration = 0.5}, .rounds = 1, .patches = 4, .patchSamples = 41});
    }

    static const TierResult& result(const std::vector<TierResult>& all, ContactLaw law,
                                    DeformationTier deformation) {
        return *std::find_if(all.begin(), all.end(), [=](const TierResult& r) {
            return r.tier.law == law && r.tier.deformation == deformation;
        });
    }
};

TEST_F(TradeOffStudy, ReferenceHasNoErrorAndEveryTierHasACost) {
    const auto results = study(test::plainScene());
    EXPECT_EQ(std::count_if(results.begin(), results.end(),
                            [](const TierResult& r) { return r.isReference; }),
              1);
    for (const TierResult& r : results) {
        EXPECT_GT(r.tickMedian, 0.0);
        EXPECT_GE(r.tickP99, r.tickMedian);
        EXPECT_GT(r.patchMedian, 0.0);
        EXPECT_EQ(r.isReference, r.surfaceErrorMax == 0.0) << r.tier.name();
    }
}

TEST_F(TradeOffStudy, HertzMissesTheAdhesionOfPolystyrene) {
    const auto results = study(test::plainScene());
    const auto& hertz = result(results, ContactLaw::Hertz, DeformationTier::FourPoint);
    const auto& maugis = result(results, ContactLaw::Split, DeformationTier::FourPoint);
    EXPECT_GT(hertz.forceErrorMax, 4.0_nN);  // the adhesive force before pull-off, physics.md 3.5
    EXPECT_LT(hertz.forceErrorMax, 8.0_nN);
    EXPECT_EQ(maugis.forceErrorMax, 0.0) << "the deformation tier does not touch the force";
}

TEST_F(TradeOffStudy, WithoutAdhesionHertzIsExact) {
    SceneDescription description = test::plainScene();
    description.sample.material.workOfAdhesion = 0.0;
    description.truth.material.workOfAdhesion = 0.0;
    const auto results = study(description);
    const auto& hertz = result(results, ContactLaw::Hertz, DeformationTier::ContactRadius);
    EXPECT_LT(hertz.forceErrorMax, 1e-9 * 20.0_nN);
    EXPECT_LT(hertz.contactRadiusError, 1e-9 * 5.0_nm);
}

TEST_F(TradeOffStudy, ContactRadiusMovesTheSurfaceBetterThanFourPoints) {
    const auto results = study(test::plainScene());
    const auto& four = result(results, ContactLaw::Split, DeformationTier::FourPoint);
    const auto& radius = result(results, ContactLaw::Split, DeformationTier::ContactRadius);
    EXPECT_LT(radius.surfaceErrorMax, four.surfaceErrorMax);
    EXPECT_GT(radius.surfaceErrorMax, 0.1_nm) << "it leaves out the surface outside the contact";
}

}  // namespace
}  // namespace asperity
