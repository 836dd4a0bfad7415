#include "core/words/ModelWords.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

QuantityErrors errorOf(JudgedQuantity quantity, double error) {
    QuantityErrors errors;
    errors[quantity] = error;
    return errors;
}

TEST(ModelErrorText, NamesTheWorstQuantityAndWhatTheLawMisses) {
    RequiredTerms needs{.measured = true,
                        .wholeErrors = errorOf(JudgedQuantity::PullOffForce, 0.002),
                        .lawErrors = errorOf(JudgedQuantity::PullOffForce, 0.052)};
    needs.wholeErrors[JudgedQuantity::Stiffness] = 0.05;
    needs.lawMisses = {ModelTerm::SphereCorrection};
    EXPECT_EQ(
        modelErrorText(needs),
        "within 5.4 % (pull-off force): 0.2 % by omitted terms, 5.2 % by terms that no contact "
        "law combines (sphere correction)");
    needs.wholeErrors[JudgedQuantity::Stiffness] = 0.06;
    EXPECT_EQ(modelErrorText(needs), "within 6 % (contact stiffness)");
}

TEST(ModelErrorText, SaysWhereNothingWasMeasured) {
    EXPECT_EQ(modelErrorText({}), "error not measured");
    EXPECT_EQ(modelErrorText({.pending = true}), "error not measured yet");
}

TEST(ModelErrorText, DoesNotRoundAnErrorToNone) {
    const auto textOf = [](double error) {
        return modelErrorText(
            {.measured = true, .wholeErrors = errorOf(JudgedQuantity::RunForce, error)});
    };
    EXPECT_EQ(textOf(0.0), "no error by omitted terms");
    EXPECT_EQ(textOf(1e-7), "within 0.01 % (rms force of a run)");
    EXPECT_EQ(textOf(2.96), "within 300 % (rms force of a run)");
}

TEST(ModelErrorText, RoundsUp) {
    const auto textOf = [](double error) {
        return modelErrorText(
            {.measured = true, .wholeErrors = errorOf(JudgedQuantity::Stiffness, error)});
    };
    EXPECT_EQ(textOf(0.03101), "within 3.2 % (contact stiffness)");
    EXPECT_EQ(textOf(0.0995), "within 10 % (contact stiffness)");
    EXPECT_EQ(textOf(0.9901), "within 100 % (contact stiffness)");
    EXPECT_EQ(textOf(0.2), "within 20 % (contact stiffness)");
}

TEST(ModelNote, ListsWhatIsLeftOutButForWhatTheLawMisses) {
    RequiredTerms needs{.tolerance = 0.05, .lawMisses = {ModelTerm::SphereCorrection}};
    EXPECT_EQ(modelNote(needs), "model: error not measured (tolerance 5 %), nothing left out");
    needs.terms = {{.term = ModelTerm::SphereCorrection, .on = false},
                   {.term = ModelTerm::Friction, .on = false},
                   {.term = ModelTerm::Torsion},
                   {.term = ModelTerm::MountTilt, .on = false}};
    EXPECT_EQ(modelNote(needs),
              "model: error not measured (tolerance 5 %); left out: friction, mount tilt");
}

TEST(ForceModelOptions, AreNamedByWhatDiffersFromTheUsual) {
    EXPECT_EQ(nameOf(ForceModelOptions{.law = ContactLaw::Hertz}),
              std::string(nameOf(ContactLaw::Hertz)) + ", certified search");
    EXPECT_EQ(nameOf({.law = ContactLaw::Jkr,
                      .solver = SolverSetting::Table,
                      .closestPointSearch = SearchEffort::Local,
                      .decoupling = DecouplingModel::Planar,
                      .friction = false,
                      .curvature = false}),
              std::string(nameOf(ContactLaw::Jkr)) +
                  ", table, local search, planar, without friction, sample curvature");
    EXPECT_EQ(nameOf({.law = ContactLaw::Split, .torsion = false, .bodyAttraction = true}),
              std::string(nameOf(ContactLaw::Split)) +
                  ", certified search, with body attraction, without lever torsion");
}

TEST(LawWords, SayWhyALawWasTaken) {
    EXPECT_EQ(whyOf({ContactLaw::Jkr, LawReason::AskedFor}), "as requested");
    EXPECT_EQ(whyOf({ContactLaw::Jkr, LawReason::TermsOfScene}), "set by the scene's terms");
    EXPECT_EQ(whyOf({ContactLaw::Hertz, LawReason::NoAdhesion}), "auto: no adhesion");
    EXPECT_EQ(whyOf({ContactLaw::HertzFilm, LawReason::FilmWithoutAdhesion}),
              "auto: a film, no adhesion");
}

TEST(LawWords, NameTheWidthThatDecided) {
    EXPECT_EQ(whyOf({ContactLaw::Split, LawReason::NarrowContact, 0.26}),
              "auto: contact radius over tip radius is 0.26 without load, below 0.3: "
              "Maugis-Dugdale, exact from DMT to JKR, with its van der Waals tail before contact");
    EXPECT_EQ(whyOf({ContactLaw::SphereSplit, LawReason::WideContact, 2.5}),
              "auto: contact radius over tip radius is 2.5 without load, above 0.3: paraboloid "
              "not valid, exact sphere used");
}

TEST(LawWords, TellOfTheTableWhereThereIsOne) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    EXPECT_EQ(lawNote(buildScene(description, test::flatMap())),
              "contact law: hertz (as requested)");
    description.choices = {.law = ContactLaw::Maugis, .solver = SolverSetting::Table};
    EXPECT_NE(lawNote(buildScene(description, test::flatMap()))
                  .find("(as requested); tabulated, error at most "),
              std::string::npos);
}

TEST(HalfSpaceWords, TellBothForcesWhereTheAnswerIsUsed) {
    HalfSpaceAnswer answer;
    answer.verdict = HalfSpaceVerdict::Valid;
    answer.force = 1.5e-9;
    answer.state.normalForce = 1.25e-9;
    EXPECT_EQ(sentenceOf(answer), "half-space: normal force 1.5 nN, the contact law 1.25 nN");
}

TEST(HalfSpaceWords, TellWhyTheClosedFormIsShown) {
    EXPECT_EQ(sentenceOf({.verdict = HalfSpaceVerdict::NoZone}),
              "half-space not valid (the contact law's adhesion has no cohesive zone): closed form "
              "shown");
    EXPECT_EQ(sentenceOf({.verdict = HalfSpaceVerdict::LargeContact}),
              "half-space not valid (contact radius above 0.3 effective radii): closed form shown");
}

TermNeed factAbout(ModelTerm term, double amount, double other = 0.0) {
    return {.term = term, .fact = TermFact{amount, other}};
}

TEST(TermWords, NameTheQuantityThatDecides) {
    EXPECT_EQ(whyOf(factAbout(ModelTerm::Adhesion, 6.2e-9, 0.05e-9), {}),
              "adhesive force up to 6.2 nN, load up to 0.05 nN in sampled runs");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::VanDerWaalsTail, 0.5), {}),
              "attraction reaches across the gap; transition parameter 0.5");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::SphereCorrection, 0.26), {}),
              "contact radius up to 0.26 tip radii");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::FilmBase, 1.5), {}),
              "contact radius up to 1.5 film thicknesses");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::SampleCurvature, 0.2), {}),
              "sample curvature up to 0.2 of the tip's curvature");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::Friction, 0.3, 2e6), {}),
              "friction coefficient 0.3, shear strength 2 MPa");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::Torsion, 0.04), {}),
              "lateral compliance is 0.04 times that along z");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::MountTilt, 0.2), {}), "lever tilt 11.5 degrees");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::GlobalSearch, 1.2), {}),
              "valley curvature up to 1.2 of the tip's curvature");
}

TEST(TermWords, SayWhyThereIsNoSuchQuantity) {
    const auto why = [](ModelTerm term, bool measured) {
        return whyOf({.term = term}, {.measured = measured, .fullTick = 0.012});
    };
    EXPECT_EQ(why(ModelTerm::Friction, false), "not measured: a tick takes 12 ms here");
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve, false), "not measured: a tick takes 12 ms here");
    EXPECT_EQ(why(ModelTerm::FilmBase, true), "the sample is no film");
    EXPECT_EQ(why(ModelTerm::Adhesion, true), "the materials do not adhere");
    EXPECT_EQ(
        whyOf(factAbout(ModelTerm::GlobalSearch, std::numeric_limits<double>::infinity()), {}),
        "a shape may have several contact points");
}

TEST(TermWords, TellOfTheSurfaceWhatTheContactsShowed) {
    RequiredTerms needs{.measured = true};
    const auto why = [&needs](ModelTerm term) { return whyOf({.term = term}, needs); };
    EXPECT_EQ(why(ModelTerm::OutsideDisplacement), "no contact in the sampled runs");
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve), "no contact in the sampled runs");
    needs.surface = {.touches = true, .deepest = {.verdict = HalfSpaceVerdict::Film}};
    EXPECT_EQ(why(ModelTerm::OutsideDisplacement),
              "the surface is displaced outside the contact, too");
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve), sentenceOf(needs.surface.deepest));
    needs.surface.halfSpace = 0.1;
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve), "not valid at every contact");
    needs.surface.halfSpaceHolds = true;
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve), sentenceOf(needs.surface.deepest));
}

TEST(TermWords, NameWhatTookThePlaceOfATermThatMatters) {
    RequiredTerms needs{.full = {.law = ContactLaw::HertzFilm}, .tolerance = 0.05};
    TermNeed adhesion = factAbout(ModelTerm::Adhesion, 6e-9, 1e-9);
    adhesion.effect = 0.3;
    EXPECT_EQ(whyOf(adhesion, needs),
              "adhesive force up to 6 nN, load up to 1 nN in sampled runs; no contact law "
              "combines it with the film's base");
    adhesion.effect = 0.01;
    EXPECT_EQ(whyOf(adhesion, needs), "adhesive force up to 6 nN, load up to 1 nN in sampled runs");
    adhesion.effect = 0.3;
    needs.full.law = ContactLaw::Split;
    EXPECT_EQ(whyOf(adhesion, needs), "adhesive force up to 6 nN, load up to 1 nN in sampled runs");
}

}  // namespace
}  // namespace asperity
