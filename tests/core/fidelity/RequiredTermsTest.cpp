#include "core/fidelity/RequiredTerms.h"

#include "core/Units.h"
#include "core/fidelity/ModelRun.h"
#include "core/fidelity/SampledRuns.h"
#include "core/haptics/DevicePath.h"
#include "core/scene/Scene.h"
#include "core/words/ModelWords.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

const TermNeed& needOf(const RequiredTerms& needs, ModelTerm term) {
    return needs.terms.at(static_cast<std::size_t>(term));
}

TEST(RequiredTerms, PolystyreneNeedsItsAdhesionAndNoTermThatIsNotThere) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.probe.mountTilt = 0.0;
    Scene scene = buildScene(description, test::flatMap());
    const RequiredTerms needs = fitModel(scene);
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

TEST(RequiredTerms, ATipThatDoesNotFitItsHollowsLooksEverywhere) {
    Scene scene = buildScene(test::plainScene(), test::ridgedMap(25.0_nm));
    const RequiredTerms needs = fitModel(scene);
    EXPECT_TRUE(needOf(needs, ModelTerm::GlobalSearch).on);
    EXPECT_EQ(scene.model.closestPointSearch, SearchEffort::Certified);
}

TEST(RequiredTerms, WhatTheSceneSaysStays) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    description.choices.deformation = DeformationModel::FourPoint;
    description.choices.closestPointSearch = SearchEffort::Global;
    description.choices.torsion = true;
    description.choices.friction = false;
    Scene scene = buildScene(description, test::hillyMap());
    const RequiredTerms needs = fitModel(scene);
    EXPECT_EQ(scene.model.law, ContactLaw::Hertz);
    EXPECT_EQ(scene.model.deformation, DeformationModel::FourPoint);
    EXPECT_EQ(scene.model.closestPointSearch, SearchEffort::Global);
    EXPECT_TRUE(scene.model.torsion);
    EXPECT_FALSE(scene.model.friction);
    EXPECT_TRUE(needOf(needs, ModelTerm::Friction).overruled);
    EXPECT_FALSE(needOf(needs, ModelTerm::MountTilt).overruled);
}

TEST(RequiredTerms, WhatIsOverruledIsWeighedAllTheSame) {
    const HeightMap map = test::hillyMap();
    Scene free = buildScene(test::plainScene(), map);
    const RequiredTerms whole = fitModel(free);
    SceneDescription description = test::plainScene();
    description.choices = {.adhesion = false, .friction = false};
    Scene scene = buildScene(description, map);
    const RequiredTerms needs = fitModel(scene);
    for (const ModelTerm term : {ModelTerm::Adhesion, ModelTerm::Friction}) {
        EXPECT_FALSE(needOf(needs, term).on) << nameOf(term);
        EXPECT_TRUE(needOf(needs, term).overruled) << nameOf(term);
        EXPECT_GT(needOf(needs, term).effect, needs.tolerance) << nameOf(term);
    }
    EXPECT_EQ(needOf(needs, ModelTerm::Friction).fact, needOf(whole, ModelTerm::Friction).fact);
    ASSERT_TRUE(needOf(needs, ModelTerm::Adhesion).fact.has_value());
    EXPECT_GT(needOf(needs, ModelTerm::Adhesion).fact->amount, 0.0) << "the pull";
}

TEST(RequiredTerms, AThinFilmNeedsItsBaseAndAThickOneDoesNot) {
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

TEST(RequiredTerms, SaysWhatKeepsATermOutThatMatters) {
    SceneDescription description = test::plainScene();
    description.sample.material.filmThickness = 3.0_nm;
    description.sample.material.workOfAdhesion = 1e-3;
    description.truth.material = description.sample.material;
    Scene scene = buildScene(description, test::flatMap());
    const RequiredTerms needs = fitModel(scene);
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
std::vector<ModelTerm> missing(const RequiredTerms& needs, const SceneDescription& description) {
    std::vector<ModelTerm> terms;
    for (const TermNeed& need : needs.terms) {
        if (!has(needs.full, need.term) && isPossible(need.term, description) &&
            !isOfSurface(need.term)) {
            terms.push_back(need.term);
        }
    }
    return terms;
}

TEST(RequiredTerms, TheErrorCountsWhatTheLawHasNoRoomFor) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const RequiredTerms needs = fitModel(scene);
    ASSERT_TRUE(needs.measured);
    ASSERT_EQ(needs.full.law, ContactLaw::Split);
    EXPECT_EQ(missing(needs, scene.description), std::vector{ModelTerm::SphereCorrection});
    EXPECT_EQ(needs.lawMisses, std::vector{ModelTerm::SphereCorrection});
    EXPECT_GT(needs.lawErrors.worst(), 0.0);
    EXPECT_DOUBLE_EQ(needs.lawErrors.worst(), needOf(needs, ModelTerm::SphereCorrection).effect);
    EXPECT_EQ(needs.wholeErrors, needs.modelErrors);
    for (const JudgedQuantity quantity : kValues<JudgedQuantity>) {
        EXPECT_EQ(needs.totalErrors()[quantity],
                  needs.wholeErrors[quantity] + needs.lawErrors[quantity]);
    }
}

TEST(RequiredTerms, RubberOnHillsIsKnownNoBetterThanItsCurvature) {
    SceneDescription description = test::plainScene();
    SampleMaterial& material = description.sample.material;
    material.elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5};
    material.workOfAdhesion = 0.022;
    description.truth.material = material;
    Scene scene = buildScene(description, test::hillyMap());
    const RequiredTerms needs = fitModel(scene);
    EXPECT_EQ(scene.model.law, ContactLaw::SphereSplit);
    EXPECT_TRUE(needOf(needs, ModelTerm::VanDerWaalsTail).on);
    EXPECT_EQ(needs.lawMisses, std::vector{ModelTerm::SampleCurvature});
    EXPECT_EQ(needs.lawErrors.worst(), needOf(needs, ModelTerm::SampleCurvature).effect);
    EXPECT_GT(needs.lawErrors.worst(), needs.tolerance);
}

TEST(RequiredTerms, WhatTheSceneOverrulesIsAnErrorToo) {
    const auto errorOf = [](const auto& overrule) {
        SceneDescription description = test::plainScene();
        overrule(description);
        Scene scene = buildScene(description, test::hillyMap());
        const RequiredTerms needs = fitModel(scene);
        EXPECT_TRUE(needs.measured);
        EXPECT_LE(needs.modelErrors.worst(), needs.tolerance) << "what is left out automatically";
        return needs.totalErrors()[JudgedQuantity::RunForce];
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

/// Pull-off of the fitted model at the highest feature [N].
double fittedPullOff(const Scene& scene) {
    const Vector2 top = pathStart(scene, {}).head<2>();
    const auto cycle = sampleCycle(scene, top, scene.description.setpoint);
    return cycle ? cycle->pullOffForce : 0.0;
}

Scene oxideSphere() {
    SceneDescription description = test::plainScene();
    description.sample.shape = ShapeDescription{.kind = ShapeKind::Sphere, .radius = 100.0_nm};
    SampleMaterial& material = description.sample.material;
    material.elastic = {.youngsModulus = 70e9, .poissonRatio = 0.27};
    material.workOfAdhesion = 0.2;
    material.friction.coefficient = 0.2;
    description.truth.material = material;
    return buildScene(description);
}

/// The jump lay in ticks that did not count: "within 4.7 %" had a pull-off that was 14.7 % off.
TEST(RequiredTerms, ASphereThatIsNotMuchLargerThanTheTipNeedsItsCurvature) {
    Scene scene = oxideSphere();
    const RequiredTerms needs = fitModel(scene);
    EXPECT_TRUE(needOf(needs, ModelTerm::SampleCurvature).on);
    EXPECT_GT(needOf(needs, ModelTerm::SampleCurvature).effect, 0.14);
    EXPECT_NEAR(fittedPullOff(scene), 15.61_nN, 0.01 * 15.61_nN);
    EXPECT_LE(needs.modelErrors.worst(), needs.tolerance);
}

/// The model held the tip for seven ticks after the sample let it go, and pushed the device.
TEST(RequiredTerms, TheFittedModelReleasesTheTipWithTheSample) {
    Scene scene = oxideSphere();
    (void)fitModel(scene);
    constexpr double kDuration = 0.5;  // [s]
    const ModelInputs run =
        recordInputs(scene, slidePath(scene, {.duration = kDuration}), kDuration);
    const ModelRun model = runModel(scene, {run});
    const auto pulled = std::ranges::min_element(run.trueForces, {},
                                                 [](const Vector3& force) { return force.z(); });
    ASSERT_LT(pulled->z(), -10.0_nN);
    const auto release = static_cast<std::size_t>(pulled - run.trueForces.begin());
    for (std::size_t tick = release + 3; tick < model.states.size(); ++tick) {
        EXPECT_LT(model.states[tick].force.norm(), 1.0_nN) << tick - release;
    }
}

/// Adhesion was left out "within 4.9 %" since the sampled runs press hard.
TEST(RequiredTerms, AdhesionStaysHoweverHardTheRunsPress) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 2.0_nm;
    Scene scene = buildScene(description, test::flatMap());
    const RequiredTerms needs = fitModel(scene);
    EXPECT_TRUE(needOf(needs, ModelTerm::Adhesion).on);
    EXPECT_GT(fittedPullOff(scene), 0.5_nN);
    EXPECT_EQ(needOf(needs, ModelTerm::Adhesion).effect, 1.0) << "no pull-off without it";
}

TEST(RequiredTerms, AFitReportsProgressAndCanBeCanceled) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    test::CanceledAfter whole(1000000);
    EXPECT_TRUE(fitModel(scene, kLongestTick, &whole).measured);
    for (const int reports : {0, 1, 5, 10, 13}) {
        test::CanceledAfter early(reports);
        EXPECT_THROW((void)fitModel(scene, kLongestTick, &early), Canceled) << reports;
    }
}

/// A blunt tip on an asperity of 40 nm radius: low above the plane, and high above it.
Scene bluntTipOn(double height) {
    HeightMap map{.columns = 129, .rows = 129, .pitchX = 4.0_nm, .pitchY = 4.0_nm};
    for (int i = 0; i < 129 * 129; ++i) {
        const double away = std::hypot(i % 129 - 64, i / 129 - 64) * 4.0_nm;
        map.heights.push_back(height * std::exp(-away * away / (80.0_nm * height)));
    }
    SceneDescription description = test::plainScene();
    description.tip.radius = 2.0_um;
    description.sample.material.friction = {};
    description.truth.material = description.sample.material;
    return buildScene(description, map);
}

TEST(RequiredTerms, ABluntTipOnALowAsperityNeedsWhatAttractsBesideIt) {
    Scene low = bluntTipOn(4.0_nm);
    const RequiredTerms needs = fitModel(low);
    const TermNeed& need = needOf(needs, ModelTerm::BodyAttraction);
    EXPECT_TRUE(need.on);
    EXPECT_GT(need.effect, needs.tolerance);
    EXPECT_TRUE(low.belief.attractsBeside());
    ASSERT_TRUE(need.fact.has_value());
    EXPECT_GT(need.fact->amount, 0.1_nN);
}

/// What is left out stands in the stated error.
TEST(RequiredTerms, AttractionBesideThatIsTurnedOffIsPartOfTheError) {
    Scene scene = bluntTipOn(4.0_nm);
    SceneDescription description = scene.description;
    description.choices.bodyAttraction = false;
    Scene less = withDescription(scene, description);
    const double effect = needOf(fitModel(scene), ModelTerm::BodyAttraction).effect;
    const RequiredTerms needs = fitModel(less);
    EXPECT_FALSE(needOf(needs, ModelTerm::BodyAttraction).on);
    EXPECT_TRUE(needOf(needs, ModelTerm::BodyAttraction).overruled);
    EXPECT_GT(needs.statedError(), 0.9 * effect);
}

TEST(RequiredTerms, WhereATickTakesTooLongAllStaysIn) {
    Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const RequiredTerms needs = fitModel(scene, 0.0);
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
