#include "core/scene/ModelChoices.h"

#include "core/Error.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/SceneDescription.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <optional>

namespace asperity {
namespace {

TEST(ModelChoices, WhatIsChosenOfATermIsWhatTheSceneSays) {
    for (const ModelTerm term : kModelTerms) {
        for (const std::optional<bool> on : {std::optional(true), std::optional(false), {}}) {
            const ModelChoices choices = withChoice({}, term, on);
            EXPECT_EQ(choiceOf(term, choices), on) << nameOf(term);
            EXPECT_EQ(isSettled(term, choices), on.has_value()) << nameOf(term);
        }
    }
}

TEST(ModelChoices, AChoiceFreesWhatContradictsIt) {
    SceneDescription scene = test::plainScene();
    ModelChoices& choices = scene.choices;
    choices.law = ContactLaw::Jkr;
    choices = withChoice(choices, ModelTerm::VanDerWaalsTail, true);
    EXPECT_FALSE(choices.law.has_value());
    choices = withChoice(choices, ModelTerm::SphereCorrection, true);
    EXPECT_TRUE(choices.vanDerWaalsTail.has_value()) << "split_sphere has both";
    choices = withChoice(choices, ModelTerm::Adhesion, false);
    EXPECT_FALSE(choices.vanDerWaalsTail.has_value());
    choices = withChoice(choices, ModelTerm::VanDerWaalsTail, true);
    EXPECT_FALSE(choices.adhesion.has_value());
    EXPECT_NO_THROW(checkScene(scene));
    choices = withChoice(choices, ModelTerm::BodyAttraction, true);
    choices = withChoice(choices, ModelTerm::VanDerWaalsTail, false);
    EXPECT_FALSE(choices.bodyAttraction.has_value()) << "it is a part of the tail's";
    choices = withChoice(choices, ModelTerm::BodyAttraction, true);
    EXPECT_FALSE(choices.vanDerWaalsTail.has_value());
    EXPECT_NO_THROW(checkScene(scene));
    choices.vanDerWaalsTail = false;
    EXPECT_THROW(checkScene(scene), Error);
}

TEST(ModelChoices, AHalfSpaceSharesItsDisplacementAlready) {
    ModelChoices choices = withChoice({}, ModelTerm::HalfSpaceSolve, true);
    choices = withChoice(choices, ModelTerm::OutsideDisplacement, true);
    EXPECT_EQ(choices.deformation, DeformationModel::HalfSpace);
    choices = withChoice(choices, ModelTerm::OutsideDisplacement, false);
    EXPECT_EQ(choices.deformation, DeformationModel::ContactRadius);
    choices = withChoice(choices, ModelTerm::HalfSpaceSolve, false);
    EXPECT_EQ(choices.deformation, DeformationModel::ContactRadius);
}

TEST(ModelChoices, AForceThatIsTakenLeavesDeformationAndDecouplingAlone) {
    const ModelChoices before{.solver = SolverSetting::Table,
                              .decoupling = DecouplingModel::Planar,
                              .deformation = DeformationModel::FourPoint,
                              .adhesion = true};
    const ModelChoices taken = withForce(before, {.law = ContactLaw::Jkr, .friction = false});
    EXPECT_EQ(taken.law, ContactLaw::Jkr);
    EXPECT_EQ(taken.solver, SolverSetting::Newton);
    EXPECT_EQ(taken.closestPointSearch, SearchEffort::Certified);
    EXPECT_EQ(taken.friction, false);
    EXPECT_EQ(taken.curvature, true);
    EXPECT_FALSE(taken.adhesion.has_value()) << "the law says it";
    EXPECT_EQ(taken.decoupling, DecouplingModel::Planar);
    EXPECT_EQ(taken.deformation, DeformationModel::FourPoint);
    EXPECT_FALSE(withForce(before, {.law = ContactLaw::SphereJkr}).curvature.has_value())
        << "that law takes the sample as flat";
}

TEST(ModelChoices, AutomaticLeavesNothingSettled) {
    const ModelChoices open = allAutomatic({.law = ContactLaw::Jkr,
                                            .solver = SolverSetting::Table,
                                            .closestPointSearch = SearchEffort::Local,
                                            .decoupling = DecouplingModel::Planar,
                                            .deformation = DeformationModel::FourPoint,
                                            .torsion = false});
    for (const ModelTerm term : kModelTerms) {
        EXPECT_FALSE(isSettled(term, open)) << nameOf(term);
    }
    EXPECT_EQ(open.solver, SolverSetting::Newton);
    EXPECT_EQ(open.decoupling, DecouplingModel::Planar);
}

}  // namespace
}  // namespace asperity
