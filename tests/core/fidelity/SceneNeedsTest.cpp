#include "core/fidelity/SceneNeeds.h"

#include "core/Units.h"
#include "core/words/ModelWords.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

const TermNeed& needOf(const SceneNeeds& needs, ModelTerm term) {
    return needs.terms.at(static_cast<std::size_t>(term));
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
    EXPECT_EQ(scene.model.closestPointSearch, SearchEffort::Certified);
}

TEST(SceneNeeds, WhatTheSceneSaysStays) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    description.choices.deformation = DeformationModel::FourPoint;
    description.choices.closestPointSearch = SearchEffort::Global;
    description.choices.torsion = true;
    description.choices.friction = false;
    Scene scene = buildScene(description, test::hillyMap());
    const SceneNeeds needs = fitModel(scene);
    EXPECT_EQ(scene.model.law, ContactLaw::Hertz);
    EXPECT_EQ(scene.model.deformation, DeformationModel::FourPoint);
    EXPECT_EQ(scene.model.closestPointSearch, SearchEffort::Global);
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
    description.choices = {.adhesion = false, .friction = false};
    Scene scene = buildScene(description, map);
    const SceneNeeds needs = fitModel(scene);
    for (const ModelTerm term : {ModelTerm::Adhesion, ModelTerm::Friction}) {
        EXPECT_FALSE(needOf(needs, term).on) << nameOf(term);
        EXPECT_TRUE(needOf(needs, term).overruled) << nameOf(term);
        EXPECT_GT(needOf(needs, term).effect, needs.tolerance) << nameOf(term);
    }
    EXPECT_EQ(needOf(needs, ModelTerm::Friction).fact, needOf(whole, ModelTerm::Friction).fact);
    ASSERT_TRUE(needOf(needs, ModelTerm::Adhesion).fact.has_value());
    EXPECT_GT(needOf(needs, ModelTerm::Adhesion).fact->amount, 0.0) << "the pull";
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
        return scene.model.law;
    };
    EXPECT_EQ(film(5.0_nm, 0.0), ContactLaw::HertzFilm);
    EXPECT_EQ(film(10.0_um, 0.0), ContactLaw::Hertz);
    EXPECT_EQ(film(5.0_nm, 1e-4), ContactLaw::HertzFilm) << "matters more than its adhesion";
    EXPECT_EQ(film(10.0_um, 0.066), ContactLaw::Split);
}

TEST(SceneNeeds, SaysWhatKeepsATermOutThatMatters) {
    SceneDescription description = test::plainScene();
    description.sample.material.filmThickness = 3.0_nm;
    Scene scene = buildScene(description, test::flatMap());
    const SceneNeeds needs = fitModel(scene);
    ASSERT_EQ(scene.model.law, ContactLaw::HertzFilm);
    const TermNeed& adhesion = needOf(needs, ModelTerm::Adhesion);
    EXPECT_FALSE(adhesion.on);
    EXPECT_GT(adhesion.effect, needs.tolerance);
    EXPECT_NE(whyOf(adhesion, needs).find("no contact law combines it with the film's base"),
              std::string::npos)
        << whyOf(adhesion, needs);
    EXPECT_EQ(whyOf(needOf(needs, ModelTerm::Torsion), needs).find("no contact law"),
              std::string::npos);
}

/// By terms of the force that the sample has and the full model has not.
double errorOfMissing(const SceneNeeds& needs, const SceneDescription& description) {
    double sum = 0.0;
    for (const TermNeed& need : needs.terms) {
        const bool missing = !has(needs.full, need.term) && isPossible(need.term, description);
        sum += missing && !isOfSurface(need.term) ? need.effect * need.effect : 0.0;
    }
    return std::sqrt(sum);
}

TEST(SceneNeeds, TheErrorCountsWhatTheLawHasNoRoomFor) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const SceneNeeds needs = fitModel(scene);
    ASSERT_TRUE(needs.measured);
    ASSERT_EQ(needs.full.law, ContactLaw::Split);
    EXPECT_GT(needs.lawError, 0.0);
    EXPECT_DOUBLE_EQ(needs.lawError, errorOfMissing(needs, scene.description));
    EXPECT_EQ(needs.lawMisses, std::vector{ModelTerm::SphereCorrection});
    EXPECT_EQ(needs.wholeError, needs.forceError);
    EXPECT_EQ(needs.totalError(), needs.wholeError + needs.lawError);
}

TEST(SceneNeeds, RubberOnHillsIsKnownNoBetterThanItsCurvature) {
    SceneDescription description = test::plainScene();
    SampleMaterial& material = description.sample.material;
    material.elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5};
    material.workOfAdhesion = 0.022;
    description.truth.material = material;
    Scene scene = buildScene(description, test::hillyMap());
    const SceneNeeds needs = fitModel(scene);
    EXPECT_EQ(scene.model.law, ContactLaw::SphereSplit);
    EXPECT_TRUE(needOf(needs, ModelTerm::VanDerWaalsTail).on);
    EXPECT_EQ(needs.lawMisses, std::vector{ModelTerm::SampleCurvature});
    EXPECT_EQ(needs.lawError, needOf(needs, ModelTerm::SampleCurvature).effect);
    EXPECT_GT(needs.lawError, needs.tolerance);
}

TEST(SceneNeeds, WhatTheSceneOverrulesIsAnErrorToo) {
    const auto errorOf = [](const auto& overrule) {
        SceneDescription description = test::plainScene();
        overrule(description);
        Scene scene = buildScene(description, test::hillyMap());
        const SceneNeeds needs = fitModel(scene);
        EXPECT_TRUE(needs.measured);
        EXPECT_LE(needs.forceError, needs.tolerance) << "what is left out automatically";
        return needs.totalError();
    };
    const double hertz = errorOf([](SceneDescription& d) { d.choices.law = ContactLaw::Hertz; });
    const double jkr = errorOf([](SceneDescription& d) { d.choices.law = ContactLaw::Jkr; });
    const double slippery = errorOf([](SceneDescription& d) { d.choices.friction = false; });
    const double dry = errorOf([](SceneDescription& d) { d.choices.adhesion = false; });
    for (const double error : {hertz, jkr, slippery, dry}) {
        EXPECT_GT(error, 0.05);
    }
    EXPECT_GT(hertz, jkr);
}

TEST(SceneNeeds, AFitReportsProgressAndCanBeCanceled) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    test::CanceledAfter whole(1000000);
    EXPECT_TRUE(fitModel(scene, kLongestTick, &whole).measured);
    for (const int reports : {0, 1, 5, 10, 13}) {
        test::CanceledAfter early(reports);
        EXPECT_THROW((void)fitModel(scene, kLongestTick, &early), Canceled) << reports;
    }
}

TEST(SceneNeeds, WhereATickTakesTooLongAllStaysIn) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const SceneNeeds needs = fitModel(scene, 0.0);
    for (const TermNeed& need : needs.terms) {
        EXPECT_EQ(need.on, has(needs.full, need.term)) << nameOf(need.term);
        EXPECT_EQ(whyOf(need, needs).find("not measured: a tick takes "), 0U) << whyOf(need, needs);
    }
    EXPECT_FALSE(needs.measured);
    EXPECT_TRUE(scene.model.friction);
    EXPECT_TRUE(scene.model.torsion);
}

}  // namespace
}  // namespace asperity
