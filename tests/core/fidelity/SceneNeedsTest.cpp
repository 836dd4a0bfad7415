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

/// Terms of the force that the runs decide about.
bool isDecidedByRuns(const SceneNeeds& needs, ModelTerm term) {
    return !isOfSurface(term) && has(needs.full, term) && !needOf(needs, term).overruled;
}

/// The search for feet also stays by a bound, without any effect on the runs.
bool mayStayWithoutEffect(ModelTerm term) { return term == ModelTerm::GlobalSearch; }

void expectSurfaceDecided(const SceneNeeds& needs) {
    const TermNeed& outside = needOf(needs, ModelTerm::OutsideDisplacement);
    const TermNeed& halfSpace = needOf(needs, ModelTerm::HalfSpaceSolve);
    EXPECT_TRUE(outside.on || outside.effect <= needs.tolerance);
    EXPECT_TRUE(!halfSpace.on || halfSpace.effect > needs.tolerance);
    EXPECT_TRUE(!halfSpace.on || outside.on) << "it shares its displacement";
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
        SampledRuns runs(scene, 1.0);
        EXPECT_LE(runs.error(needs.model), needs.tolerance) << "all that is left out together";
        expectSurfaceDecided(needs);
        for (const ModelTerm term : kModelTerms) {
            if (!isDecidedByRuns(needs, term)) {
                continue;
            }
            if (has(needs.model, term)) {
                ++kept;
                const double effect =
                    std::max(needOf(needs, term).effect, runs.error(without(needs.model, term)));
                EXPECT_TRUE(effect > needs.tolerance || mayStayWithoutEffect(term))
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

TEST(SceneNeeds, WhatIsOverruledIsWeighedAllTheSame) {
    const HeightMap map = test::hillyMap();
    Scene free = buildScene(test::plainScene(), map);
    const SceneNeeds whole = fitModel(free);
    SceneDescription description = test::plainScene();
    description.terms = {.adhesion = false, .friction = false};
    Scene scene = buildScene(description, map);
    const SceneNeeds needs = fitModel(scene);
    for (const ModelTerm term : {ModelTerm::Adhesion, ModelTerm::Friction}) {
        EXPECT_FALSE(needOf(needs, term).on) << nameOf(term);
        EXPECT_TRUE(needOf(needs, term).overruled) << nameOf(term);
        EXPECT_GT(needOf(needs, term).effect, needs.tolerance) << nameOf(term);
    }
    EXPECT_EQ(needOf(needs, ModelTerm::Friction).why, needOf(whole, ModelTerm::Friction).why);
    EXPECT_NE(needOf(needs, ModelTerm::Adhesion).why.find("pulls with up to"), std::string::npos);
    EXPECT_EQ(needOf(needs, ModelTerm::Adhesion).why.find("pulls with up to 0 "), std::string::npos)
        << needOf(needs, ModelTerm::Adhesion).why;
}

TEST(SceneNeeds, AThinFilmNeedsItsBaseAndAThickOneDoesNot) {
    const auto film = [](double thickness, double adhesion) {
        SceneDescription description = test::plainScene();
        SampleMaterial& material = description.sample.material;
        material.filmThickness = thickness;
        material.workOfAdhesion = adhesion;
        description.truth.material = material;
        Scene scene = buildScene(description, test::flatMap());
        (void)fitModel(scene);
        return scene.model.law.law;
    };
    EXPECT_EQ(film(5.0_nm, 0.0), ContactLaw::HertzFilm);
    EXPECT_EQ(film(10.0_um, 0.0), ContactLaw::Hertz);
    EXPECT_EQ(film(5.0_nm, 1e-4), ContactLaw::HertzFilm) << "matters more than its adhesion";
    EXPECT_EQ(film(10.0_um, 0.066), ContactLaw::Split);
}

TEST(SceneNeeds, WhereATickTakesTooLongAllStaysIn) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const SceneNeeds needs = fitModel(scene, 0.0);
    for (const TermNeed& need : needs.terms) {
        EXPECT_EQ(need.on, has(needs.full, need.term)) << nameOf(need.term);
        EXPECT_EQ(need.why.find("not tried: a tick takes "), 0U) << need.why;
    }
    EXPECT_TRUE(scene.model.friction);
    EXPECT_TRUE(scene.model.torsion);
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
