#include "core/words/TermWords.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TermNeed factAbout(ModelTerm term, double amount, double other = 0.0) {
    return {.term = term, .reason = NeedReason::Fact, .fact = {amount, other}};
}

TEST(TermWords, NameTheQuantityThatDecides) {
    EXPECT_EQ(whyOf(factAbout(ModelTerm::Adhesion, 6.2e-9, 0.05e-9), {}),
              "it pulls with up to 6.2 nN, pressed by up to 0.05 nN");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::VanDerWaalsTail, 0.5), {}),
              "attraction reaches across the gap; transition parameter 0.5");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::SphereCorrection, 0.26), {}),
              "the contact is up to 0.26 tip radii wide");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::FilmBase, 1.5), {}),
              "the contact is up to 1.5 film thicknesses wide");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::SampleCurvature, 0.2), {}),
              "the sample is curved by up to 0.2 of the tip's own curvature");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::Friction, 0.3, 2e6), {}),
              "friction coefficient 0.3, shear strength 2 MPa");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::Torsion, 0.04), {}),
              "across the lever the tip yields 0.04 times as much as along z");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::MountTilt, 0.2), {}),
              "the lever is tilted by 11.5 degrees");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::GlobalSearch, 1.2), {}),
              "hollows are curved by up to 1.2 of the tip's own curvature");
}

TEST(TermWords, TakeTheWordOfTheHalfSpace) {
    EXPECT_EQ(whyOf(factAbout(ModelTerm::OutsideDisplacement, 0.0), {}),
              "a sample yields beyond the rim of the contact, too");
    EXPECT_EQ(whyOf(factAbout(ModelTerm::HalfSpaceSolve, 0.0),
                    {.halfSpace = {HalfSpaceVerdict::Valid, 1e-9, 2e-9}}),
              "half-space: normal force 1 nN, the contact law 2 nN");
}

TEST(TermWords, SayWhyThereIsNoSuchQuantity) {
    const auto why = [](ModelTerm term, NeedReason reason) {
        return whyOf({.term = term, .reason = reason}, {.fullTick = 0.012});
    };
    EXPECT_EQ(why(ModelTerm::Friction, NeedReason::Unknown), "");
    EXPECT_EQ(why(ModelTerm::Friction, NeedReason::NotTried),
              "not tried: a tick takes 12 ms here");
    EXPECT_EQ(why(ModelTerm::FilmBase, NeedReason::Impossible), "the sample is no film");
    EXPECT_EQ(why(ModelTerm::Adhesion, NeedReason::Impossible), "the materials do not adhere");
    EXPECT_EQ(why(ModelTerm::GlobalSearch, NeedReason::AnyShape),
              "a shape may come near at several places");
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve, NeedReason::NoContact),
              "the sampled runs touch nothing");
    EXPECT_EQ(why(ModelTerm::HalfSpaceSolve, NeedReason::NotEverywhere),
              "it does not hold at every contact");
}

TEST(TermWords, NameWhatTookThePlaceOfATermThatMatters) {
    SceneNeeds needs{.full = {.law = ContactLaw::HertzFilm}, .tolerance = 0.05};
    TermNeed adhesion = factAbout(ModelTerm::Adhesion, 6e-9, 1e-9);
    adhesion.effect = 0.3;
    EXPECT_EQ(whyOf(adhesion, needs), "it pulls with up to 6 nN, pressed by up to 1 nN; no contact "
                                      "law has it beside the film's base");
    adhesion.effect = 0.01;
    EXPECT_EQ(whyOf(adhesion, needs), "it pulls with up to 6 nN, pressed by up to 1 nN");
    adhesion.effect = 0.3;
    needs.full.law = ContactLaw::Split;
    EXPECT_EQ(whyOf(adhesion, needs), "it pulls with up to 6 nN, pressed by up to 1 nN");
}

}  // namespace
}  // namespace asperity
