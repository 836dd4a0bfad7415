#include "core/deformation/ContactDeformation.h"

#include "core/Units.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity {
namespace {

/// Largest distance between what is drawn and what the contact law says [m].
double farthestFromExact(const Scene& scene, const TipState& state, DeformationModel model) {
    const PatchGrid grid{.halfWidth = 40.0_nm, .samples = 81};
    const SurfacePatch drawn = drawnPatch(scene, ContactDeformation(scene, state, model), grid);
    const SurfacePatch exact = exactPatch(scene, state, model, grid);
    double farthest = 0.0;
    for (std::size_t i = 0; i < exact.points.size(); ++i) {
        farthest = std::max(farthest, (drawn.points[i] - exact.points[i]).norm());
    }
    return farthest;
}

TEST(ContactDeformation, FollowsEveryContactLawFromFarToDeep) {
    for (const ContactLaw law : {ContactLaw::Hertz, ContactLaw::Jkr, ContactLaw::Maugis,
                                 ContactLaw::Split, ContactLaw::SphereMaugis}) {
        SceneDescription description = test::plainScene();
        description.choices.law = law;
        const Scene scene = buildScene(description, test::flatMap());
        EquilibriumMemory memory;
        for (const double height : {2.0_nm, 0.2_nm, -1.0_nm, -2.0_nm, 0.5_nm}) {
            const BaseMotion base{.position = {64.0_nm, 64.0_nm, height}};
            const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
            ASSERT_EQ(rimRounding(state.contact, scene.belief.tipRadius()), 0.0);
            EXPECT_LT(farthestFromExact(scene, state, DeformationModel::ClosedForm), 1e-12)
                << static_cast<int>(law) << " at " << height;
        }
    }
}

TEST(ContactDeformation, IsThatOfItsModelOnHills) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -4.0_nm}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    for (const DeformationModel model :
         {DeformationModel::FourPoint, DeformationModel::ContactRadius}) {
        EXPECT_EQ(farthestFromExact(scene, state, model), 0.0);
        EXPECT_EQ(ContactDeformation(scene, state, model).tipDisplacement(0.0), 0.0);
    }
}

}  // namespace
}  // namespace asperity
