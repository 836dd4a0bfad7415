#include "core/studies/DeformationStudy.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {
namespace {

class DeformationStudy : public ::testing::Test {
protected:
    static const DeformationResult& result(const std::string& material, const std::string& surface,
                                           DeformationModel model) {
        static const std::vector<DeformationResult> all = studyDeformation(
            buildScene(test::plainScene(), test::hillyMap()), {.rounds = 1, .samples = 41});
        return *std::find_if(all.begin(), all.end(), [&](const DeformationResult& r) {
            return r.material == material && r.surface == surface && r.model == model;
        });
    }
};

TEST_F(DeformationStudy, ClosedFormIsExactOnAFlatSampleAndTheHalfSpaceNearlySo) {
    for (const char* material : {"silicon oxide", "polystyrene"}) {
        EXPECT_EQ(result(material, "flat", DeformationModel::ClosedForm).errorMax, 0.0);
        const auto& solved = result(material, "flat", DeformationModel::HalfSpace);
        EXPECT_LT(solved.errorMax, 0.02) << material;
        EXPECT_GT(solved.errorMax, 0.0) << material;
        EXPECT_NEAR(solved.ownForce, solved.lawForce, 0.05e-9) << material;
        EXPECT_GT(result(material, "flat", DeformationModel::ContactRadius).errorMax, 0.1)
            << "it leaves the surface outside of the contact where it was";
    }
}

TEST_F(DeformationStudy, OnHillsTheHalfSpaceSeesWhatTheClosedFormAverages) {
    const auto& closed = result("polystyrene", "scan", DeformationModel::ClosedForm);
    const auto& solved = result("polystyrene", "scan", DeformationModel::HalfSpace);
    ASSERT_TRUE(solved.compared);
    EXPECT_LT(solved.errorMax, closed.errorMax);
    EXPECT_LT(solved.errorMax, 0.03);
}

TEST_F(DeformationStudy, NoHalfSpaceHoldsForRubber) {
    const auto& solved = result("silicone rubber", "flat", DeformationModel::HalfSpace);
    EXPECT_GT(solved.contactRatio, 0.3);
    EXPECT_EQ(solved.errorMax, 0.0) << "the closed form stands in";
    ASSERT_TRUE(solved.halfSpace.has_value());
    EXPECT_EQ(solved.halfSpace->verdict, HalfSpaceVerdict::LargeContact);
    EXPECT_FALSE(result("silicone rubber", "scan", DeformationModel::HalfSpace).compared);
}

TEST_F(DeformationStudy, TakesItsOwnLawWhateverTheSceneSaysOfItsTerms) {
    SceneDescription description = test::plainScene();
    description.choices.adhesion = false;
    const std::vector<DeformationResult> all =
        studyDeformation(buildScene(description, test::flatMap()), {.rounds = 1, .samples = 9});
    EXPECT_EQ(all.size(), 24U);
}

}  // namespace
}  // namespace asperity
