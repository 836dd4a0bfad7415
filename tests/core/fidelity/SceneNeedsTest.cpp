#include "core/fidelity/SceneNeeds.h"

#include "core/Units.h"
#include "core/fidelity/SampledRuns.h"
#include "tests/core/fidelity/RandomScene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity {
namespace {

const TermNeed& needOf(const SceneNeeds& needs, ModelTerm term) {
    return needs.terms.at(static_cast<std::size_t>(term));
}

/// Terms of the force that the runs decide about: the search for feet stays by a bound, and the
/// tail and the exact sphere exclude each other.
bool isDecidedByRuns(const SceneNeeds& needs, ModelTerm term) {
    const bool sphere = has(needs.full, ModelTerm::SphereCorrection);
    return !isOfSurface(term) && term != ModelTerm::GlobalSearch && has(needs.full, term) &&
           !(sphere && term == ModelTerm::VanDerWaalsTail);
}

TEST(SceneNeeds, KeepsWhatMovesTheForceAndLeavesOutWhatDoesNot) {
    constexpr int kScenes = 200;
    Random random(20261122);
    int kept = 0;
    int leftOut = 0;
    for (int i = 0; i < kScenes; ++i) {
        SCOPED_TRACE(i);
        Scene scene = test::randomScene(random);
        const SceneNeeds needs = fitModel(scene);
        ASSERT_EQ(needs.terms.size(), kModelTerms.size());
        setModel(scene, needs.full);
        SampledRuns runs(scene);
        EXPECT_LE(runs.error(needs.model), needs.tolerance) << "all that is left out together";
        for (const ModelTerm term : kModelTerms) {
            if (!isDecidedByRuns(needs, term)) {
                continue;
            }
            if (has(needs.model, term)) {
                ++kept;
                EXPECT_GT(
                    std::max(needOf(needs, term).effect, runs.error(without(needs.model, term))),
                    needs.tolerance)
                    << nameOf(term) << " was kept";
            } else {
                ++leftOut;
                EXPECT_LE(runs.error(without(needs.full, term)), needs.tolerance)
                    << nameOf(term) << " was left out";
            }
        }
    }
    EXPECT_GT(kept, kScenes);
    EXPECT_GT(leftOut, kScenes);
}

TEST(SceneNeeds, TwiceTheSame) {
    Random first(3);
    Random second(3);
    Scene one = test::randomScene(first);
    Scene other = test::randomScene(second);
    const SceneNeeds a = fitModel(one);
    const SceneNeeds b = fitModel(other);
    EXPECT_EQ(a.forceError, b.forceError);
    for (std::size_t i = 0; i < a.terms.size(); ++i) {
        EXPECT_EQ(a.terms[i].on, b.terms[i].on) << nameOf(a.terms[i].term);
        EXPECT_EQ(a.terms[i].effect, b.terms[i].effect) << nameOf(a.terms[i].term);
        EXPECT_EQ(a.terms[i].why, b.terms[i].why);
    }
}

TEST(SceneNeeds, PolystyreneNeedsItsAdhesionAndNoTermThatIsNotThere) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.probe.mountTilt = 0.0;
    Scene scene = buildScene(description, test::flatMap());
    const SceneNeeds needs = fitModel(scene);
    EXPECT_TRUE(needOf(needs, ModelTerm::Adhesion).on);
    EXPECT_GT(needOf(needs, ModelTerm::Adhesion).effect, 0.05);
    for (const ModelTerm term : {ModelTerm::Friction, ModelTerm::MountTilt,
                                 ModelTerm::SampleCurvature, ModelTerm::GlobalSearch}) {
        EXPECT_FALSE(needOf(needs, term).on) << nameOf(term);
        EXPECT_EQ(needOf(needs, term).effect, 0.0) << nameOf(term);
    }
    EXPECT_TRUE(needOf(needs, ModelTerm::OutsideDisplacement).on);
    EXPECT_EQ(scene.model.friction, false) << "the scene has what was found";
}

TEST(SceneNeeds, ATipThatDoesNotFitItsHollowsLooksEverywhere) {
    Scene scene = buildScene(test::plainScene(), test::ridgedMap(25.0_nm));
    const SceneNeeds needs = fitModel(scene);
    EXPECT_TRUE(needOf(needs, ModelTerm::GlobalSearch).on);
    EXPECT_EQ(scene.model.footSearch, FootEffort::Certified);
}

TEST(SceneNeeds, WhatTheSceneSaysStays) {
    SceneDescription description = test::plainScene();
    description.law = ContactLaw::Hertz;
    description.deformation = DeformationTier::FourPoint;
    description.footSearch = FootEffort::Global;
    description.terms.torsion = true;
    description.terms.friction = false;
    Scene scene = buildScene(description, test::hillyMap());
    const SceneNeeds needs = fitModel(scene);
    EXPECT_EQ(scene.model.law.law, ContactLaw::Hertz);
    EXPECT_EQ(scene.model.deformation, DeformationTier::FourPoint);
    EXPECT_EQ(scene.model.footSearch, FootEffort::Global);
    EXPECT_TRUE(scene.model.torsion);
    EXPECT_FALSE(scene.model.friction);
    EXPECT_TRUE(needOf(needs, ModelTerm::Friction).overruled);
    EXPECT_FALSE(needOf(needs, ModelTerm::MountTilt).overruled);
}

TEST(SceneNeeds, TheSettledDescriptionGivesTheSameModelAgain) {
    Random random(11);
    for (int i = 0; i < 20; ++i) {
        Scene scene = test::randomScene(random);
        (void)fitModel(scene);
        const SceneModel found = scene.model;
        scene.description = settled(scene.description, found);
        (void)fitModel(scene);
        EXPECT_EQ(scene.model.law.law, found.law.law);
        for (const ModelTerm term : kModelTerms) {
            EXPECT_EQ(has(scene.model, term), has(found, term)) << nameOf(term);
        }
    }
}

TEST(SceneNeeds, AWiderToleranceLeavesOutNoLess) {
    Random random(5);
    for (int i = 0; i < 10; ++i) {
        Scene scene = test::randomScene(random);
        const auto count = [&](double tolerance) {
            scene.description.tolerance = tolerance;
            const SceneNeeds needs = fitModel(scene);
            return std::ranges::count_if(needs.terms, &TermNeed::on);
        };
        EXPECT_GE(count(0.0), count(0.5));
    }
}

}  // namespace
}  // namespace asperity
