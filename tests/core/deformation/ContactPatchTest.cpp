#include "core/Units.h"
#include "core/contact/ContactState.h"
#include "core/deformation/ContactDeformation.h"
#include "core/scene/Scene.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace asperity {
namespace {

class ContactPatchOnAFlatSample : public ::testing::Test {
protected:
    [[nodiscard]] TipState indented() const {
        EquilibriumMemory memory;
        const BaseMotion base{.position = {64.0_nm, 64.0_nm, -2.0_nm}};
        return tipEquilibrium(scene.surface, scene.belief, base, memory);
    }

    Scene scene = buildScene(test::plainScene(), test::flatMap());
    PatchGrid grid{.halfWidth = 30.0_nm, .samples = 121};
};

TEST_F(ContactPatchOnAFlatSample, ClosedFormPushesTheSampleByItsShareOfTheIndentation) {
    const TipState state = indented();
    const SurfacePatch patch = exactPatch(scene, state, DeformationModel::ClosedForm, grid);
    const std::size_t middle = patch.index(patch.rows / 2, patch.columns / 2);
    const double share =
        sampleShare(scene.description.sample.material.elastic, scene.description.tip.elastic);
    EXPECT_NEAR(patch.points[middle].z(), -share * state.contact.indentation,
                1e-9 * state.contact.indentation);
    EXPECT_GT(share, 0.98) << "polystyrene under silicon takes nearly all";
}

/// The scene of a material of T08 under the law whose profiles it holds.
Scene sceneOfMaterial(const std::string& material) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Maugis;
    if (material == "SiO2") {
        description.sample.material.elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27};
        description.sample.material.workOfAdhesion = 0.2;
    }
    return buildScene(description, test::flatMap());
}

/// The state that a row of T08 describes, in the middle of the scan.
TipState stateOf(const test::ReferenceTable& table, std::size_t row) {
    TipState state;
    state.tip = {64.0_nm, 64.0_nm, -table.number(row, "delta_m")};
    state.closest.point = {64.0_nm, 64.0_nm, 0.0};
    state.contact.indentation = table.number(row, "delta_m");
    state.contact.contactRadius = table.number(row, "a_m");
    state.contact.cohesiveRadius = table.number(row, "c_m");
    state.contact.branch = ContactBranch::Bonded;
    return state;
}

TEST(ContactPatch, ClosedFormHasTheReferenceProfiles) {
    const test::ReferenceTable table = test::referenceTable("T08_surface_profiles.csv");
    std::size_t compared = 0;
    for (const char* material : {"PS", "SiO2"}) {
        const Scene scene = sceneOfMaterial(material);
        const double share =
            sampleShare(scene.description.sample.material.elastic, scene.description.tip.elastic);
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const double radius = table.number(row, "r_m");
            if (table.text(row, "model") != "MD" || table.text(row, "material") != material ||
                radius == 0.0 || radius > 60.0_nm) {
                continue;
            }
            const SurfacePatch patch =
                exactPatch(scene, stateOf(table, row), DeformationModel::ClosedForm,
                           {.halfWidth = radius, .samples = 3});
            const double depth = -patch.points[patch.index(1, 2)].z();
            // A ten thousandth of an atom: the positions of the patch are rounded in the scan.
            EXPECT_NEAR(depth, share * table.number(row, "u_z_m"), 1e-14) << "row " << row;
            ++compared;
        }
    }
    EXPECT_GT(compared, 150U);
}

TEST_F(ContactPatchOnAFlatSample, ContactRadiusLeavesTheSurfaceOutsideAlone) {
    const TipState state = indented();
    const SurfacePatch patch = exactPatch(scene, state, DeformationModel::ContactRadius, grid);
    double outside = 0.0;
    double inside = 0.0;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        const Vector3 flat = patch.rest[i] - state.closest.point;
        const double radius = std::hypot(flat.x(), flat.y());
        const double depth = std::abs(patch.points[i].z() - patch.rest[i].z());
        if (radius > 1.5 * state.contact.contactRadius) {
            outside = std::max(outside, depth);
        }
        if (radius < 0.1 * state.contact.contactRadius) {
            inside = std::max(inside, depth);
        }
    }
    EXPECT_LT(outside, 1e-15);
    EXPECT_NEAR(inside, state.contact.indentation, 0.02 * state.contact.indentation);
}

TEST(ContactPatch, SampleAndTipMeetInTheContactWhateverTheirShares) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 169.0_GPa, .poissonRatio = 0.27};
    const Scene scene = buildScene(description, test::flatMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -3.0_nm}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    const Vector3 closest = displacedPoint(scene, state, DeformationModel::ClosedForm);
    const double half = 0.5 * state.contact.indentation;  // two bodies of one material
    EXPECT_NEAR(state.closest.point.z() - closest.z(), half, 1e-9 * half);
    EXPECT_NEAR(deformation.tipDisplacement(0.0), half, 1e-9 * half);
    // The sphere, deformed by its share, touches the sample at the middle of the contact.
    EXPECT_NEAR(state.tip.z() + deformation.tipDisplacement(0.0), closest.z(), 1e-9 * half);
}

}  // namespace
}  // namespace asperity
