#include "core/scene/BelievedModel.h"

#include "core/Units.h"
#include "core/contact/laws/FilmTable.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

SceneDescription tiltedScene() {
    SceneDescription description = test::plainScene();
    description.probe.mountTilt = 0.2;
    description.sample.material.friction = {.coefficient = 0.3, .shearStrength = 1e6};
    return description;
}

ProbeSystem less(ModelTerm term) {
    const SceneDescription description = tiltedScene();
    return believedSystem(description, without(usualModel(description), term));
}

TEST(BelievedModel, WithoutFrictionThereIsNone) {
    EXPECT_EQ(less(ModelTerm::Friction).friction, Friction{});
    EXPECT_EQ(less(ModelTerm::Torsion).friction, tiltedScene().sample.material.friction);
}

TEST(BelievedModel, WithoutTiltTheLeverIsLevel) {
    EXPECT_EQ(less(ModelTerm::MountTilt).cantilever.geometry().mountTilt, 0.0);
    EXPECT_EQ(less(ModelTerm::Friction).cantilever.geometry().mountTilt, 0.2);
}

TEST(BelievedModel, WithoutTorsionTheLeverOnlyBendsAcross) {
    const Cantilever whole(tiltedScene().probe);
    const Cantilever rigid = less(ModelTerm::Torsion).cantilever;
    const CantileverGeometry& g = rigid.geometry();
    const double ratio = g.thickness / g.width;
    const Matrix3& left = rigid.complianceInCantileverFrame();
    // docs/theory.md 5.1: of c_yy only (t/w)^2 / k_z stays.
    EXPECT_NEAR(left(1, 1), ratio * ratio / whole.stiffness(), 1e-12 / whole.stiffness());
    EXPECT_LT(left(1, 1), 0.5 * whole.complianceInCantileverFrame()(1, 1));
    EXPECT_EQ(left(0, 0), whole.complianceInCantileverFrame()(0, 0));
    EXPECT_EQ(left(2, 2), whole.complianceInCantileverFrame()(2, 2));
    EXPECT_EQ(rigid.torsionPerFy(), whole.torsionPerFy()) << "the signal is still read";
    EXPECT_TRUE(
        rigid.compliance().isApprox(rigid.rotation().transpose() * left * rigid.rotation(), 1e-14));
}

TEST(BelievedModel, WithoutCurvatureEveryClosestPointIsFlat) {
    Scene scene = buildScene(test::plainScene(), test::ridgedMap(5.0_nm));
    const auto radiusOnTheCrest = [&] {
        return heldTip(scene.believedSurface(), scene.belief,
                       {.position = {15.0_nm, 60.0_nm, 5.0_nm}}, {})
            .effectiveRadius;
    };
    EXPECT_LT(radiusOnTheCrest(), 0.95 * scene.belief.tipRadius());
    setModel(scene, without(scene.model, ModelTerm::SampleCurvature));
    EXPECT_EQ(radiusOnTheCrest(), scene.belief.tipRadius());
}

TEST(BelievedModel, TermsOfTheLawChooseTheLaw) {
    const auto lawOf = [](const ModelChoices& terms) {
        SceneDescription description = test::plainScene();
        description.choices = terms;
        return usualModel(description).law;
    };
    EXPECT_EQ(lawOf({}), ContactLaw::Split);
    EXPECT_EQ(lawOf({.vanDerWaalsTail = false}), ContactLaw::Maugis);
    EXPECT_EQ(lawOf({.adhesion = false}), ContactLaw::Hertz);
    EXPECT_EQ(lawOf({.sphereCorrection = true}), ContactLaw::SphereSplit);
    EXPECT_EQ(lawOf({.vanDerWaalsTail = false, .sphereCorrection = true}),
              ContactLaw::SphereMaugis);
    EXPECT_EQ(lawOf({.adhesion = false, .sphereCorrection = true}), ContactLaw::Sneddon);
}

TEST(BelievedModel, AFilmWithoutAdhesionHasItsBase) {
    SceneDescription description = test::plainScene();
    description.sample.material.filmThickness = 20.0_nm;
    EXPECT_EQ(usualModel(description).law, ContactLaw::Split) << "no law has both";
    description.choices.filmBase = true;
    EXPECT_EQ(usualModel(description).law, ContactLaw::HertzFilm);
    description.choices = {};
    description.sample.material.workOfAdhesion = 0.0;
    EXPECT_EQ(usualModel(description).law, ContactLaw::HertzFilm);
    description.choices.filmBase = false;
    EXPECT_EQ(usualModel(description).law, ContactLaw::Hertz);
    description.choices = {.sphereCorrection = true};
    EXPECT_EQ(usualModel(description).law, ContactLaw::Sneddon);
}

TEST(BelievedModel, ATermThatIsTakenOutIsOutAndComesBack) {
    const ForceModelOptions usual = usualModel(tiltedScene());
    for (const ModelTerm term : kModelTerms) {
        ForceModelOptions model = with(usual, term);
        EXPECT_TRUE(has(model, term)) << nameOf(term);
        model = without(model, term);
        EXPECT_FALSE(has(model, term)) << nameOf(term);
        EXPECT_TRUE(has(with(model, term), term)) << nameOf(term);
    }
}

/// The film's Poisson ratio is the sample's; a tip of the same stuff takes half of 1 / E*.
TEST(BelievedModel, AFilmIsAsElasticAsItsSample) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::HertzFilm;
    SampleMaterial& material = description.sample.material;
    material.filmThickness = 20.0_nm;
    material.elastic = {.youngsModulus = 1.0_GPa, .poissonRatio = 0.42};
    description.truth.material = material;
    description.truth.material.elastic.poissonRatio = 0.3;
    description.tip.elastic = material.elastic;
    const Scene scene = buildScene(description, test::flatMap());
    const FilmElasticity believed = scene.belief.contact.film()->elasticity();
    EXPECT_EQ(believed.poissonRatio, 0.42);
    EXPECT_NEAR(believed.share, 0.5, 1e-15);
    EXPECT_EQ(truthOf(scene).system.contact.film()->elasticity().poissonRatio, 0.3);
}

TEST(BelievedModel, ASettledDescriptionSaysEveryTerm) {
    const SceneDescription open = tiltedScene();
    for (const ModelTerm term : kModelTerms) {
        const ForceModelOptions less = without(usualModel(open), term);
        const SceneDescription said = settled(open, less);
        const ForceModelOptions again = usualModel(said);
        for (const ModelTerm each : kModelTerms) {
            EXPECT_TRUE(isSettled(each, said.choices)) << nameOf(each);
            EXPECT_EQ(has(again, each), has(less, each)) << nameOf(each);
        }
        EXPECT_NO_THROW(checkScene(said)) << nameOf(term);
    }
}

TEST(BelievedModel, AGivenLawSettlesItsTerms) {
    SceneDescription description = test::plainScene();
    EXPECT_FALSE(isSettled(ModelTerm::Adhesion, description.choices));
    description.choices.law = ContactLaw::Jkr;
    for (const ModelTerm term : kModelTerms) {
        EXPECT_EQ(isSettled(term, description.choices), isOfLaw(term)) << nameOf(term);
    }
}

}  // namespace
}  // namespace asperity
