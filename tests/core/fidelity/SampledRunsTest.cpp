#include "core/fidelity/SampledRuns.h"

#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {
namespace {

TipState pulledBy(double force) {
    TipState state;
    state.force = Vector3(0.0, 0.0, -force);
    state.contact.contactRadius = force > 0.0 ? 1.0_nm : 0.0;
    return state;
}

/// Ten ticks that pull with 1 nN, up to a release.
std::vector<TipState> runUntil(int release, double force = 1.0_nN) {
    std::vector<TipState> run;
    for (int tick = 0; tick < 10; ++tick) {
        run.push_back(pulledBy(tick < release ? force : 0.0));
    }
    return run;
}

TEST(ForceShare, IsTheRootMeanSquareOverThatOfTheReference) {
    EXPECT_NEAR(forceShare(runUntil(5, 1.1_nN), runUntil(5)), 0.1, 1e-12);
    EXPECT_EQ(forceShare(runUntil(0), runUntil(0)), 0.0) << "no force";
}

TEST(ForceShare, CountsAJumpByItsShareOfTheMeanSquare) {
    EXPECT_NEAR(forceShare(runUntil(3), runUntil(5)), 2.0 / 5.0, 1e-12);
    EXPECT_NEAR(forceShare(runUntil(7), runUntil(5)), 2.0 / 5.0, 1e-12);
}

TEST(ForceShare, LeavesASingleTickToTheCycles) {
    EXPECT_EQ(forceShare(runUntil(4), runUntil(5)), 0.0);
}

TEST(SampledRuns, ComputeEachModelOnce) {
    Scene scene = buildScene(test::plainScene(), test::flatMap());
    SampledRuns runs(scene, 1.0);
    const ForceModelOptions model = usualModel(scene.description);
    const ModelSample& first = runs.of(model);
    ForceModelOptions drawn = model;
    drawn.deformation = DeformationModel::FourPoint;
    EXPECT_EQ(&runs.of(without(model, ModelTerm::Friction)).run,
              &runs.of(without(drawn, ModelTerm::Friction)).run)
        << "the same force";
    EXPECT_EQ(&runs.of(model), &first);
    EXPECT_EQ(runs.errors(model, model), QuantityErrors{});
    EXPECT_FALSE(scene.model.deformation == DeformationModel::FourPoint);
}

}  // namespace
}  // namespace asperity
