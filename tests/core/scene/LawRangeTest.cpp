#include "core/scene/LawRange.h"

#include "core/Units.h"
#include "core/scene/ContactValidity.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// A tip that is pressed in without a lever from far away.
ContactState pressed(const ContactModel& model, double indentation) {
    return model.equilibrium(indentation, 0.0, {});
}

bool leaves(ContactLaw law, const ContactPair& pair, double indentation) {
    const ContactModel model(law, pair);
    return leavesLawsRange(model, pressed(model, indentation));
}

constexpr ContactPair kPolymer{
    .tipRadius = 100e-9, .reducedModulus = 2.35e9, .workOfAdhesion = 0.066};
constexpr ContactPair kHard{.tipRadius = 20e-9, .reducedModulus = 1e12, .workOfAdhesion = 1e-4};
constexpr ContactPair kSoft{.tipRadius = 10e-6, .reducedModulus = 1e8, .workOfAdhesion = 0.01};

TEST(LawRange, HertzHoldsWithoutAdhesionOrUnderALoadThatOutweighsIt) {
    EXPECT_TRUE(leaves(ContactLaw::Hertz, kPolymer, 1.0_nm));
    EXPECT_TRUE(leaves(ContactLaw::Sneddon, kPolymer, 1.0_nm));
    ContactPair bare = kPolymer;
    bare.workOfAdhesion = 0.0;
    EXPECT_FALSE(leaves(ContactLaw::Hertz, bare, 1.0_nm));
    const ContactModel hertz(ContactLaw::Hertz, kPolymer);
    const double unit = maugisUnits(kPolymer).force;
    EXPECT_TRUE(leavesLawsRange(hertz, {.force = 279.0 * unit}));
    EXPECT_FALSE(leavesLawsRange(hertz, {.force = 281.0 * unit}));
}

TEST(LawRange, DmtIsForStiffSamplesAndJkrForSoftOnes) {
    EXPECT_FALSE(leaves(ContactLaw::Dmt, kHard, 0.002_nm));
    EXPECT_TRUE(leaves(ContactLaw::Jkr, kHard, 0.002_nm));
    EXPECT_TRUE(leaves(ContactLaw::Dmt, kSoft, 10.0_nm));
    EXPECT_FALSE(leaves(ContactLaw::Jkr, kSoft, 10.0_nm));
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kHard, 0.002_nm));
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kSoft, 10.0_nm));
}

TEST(LawRange, LawsWithoutARangeDoNotKnowOfAttractionAcrossAGap) {
    EXPECT_TRUE(leaves(ContactLaw::Jkr, kSoft, -0.3_nm));
    EXPECT_FALSE(leaves(ContactLaw::Jkr, kSoft, -0.5_nm));
    EXPECT_TRUE(leaves(ContactLaw::Dmt, kHard, -0.3_nm));
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kHard, -0.3_nm));
}

TEST(LawRange, ATipAboutAsSharpAsItsAttractionIsLongIsNoParaboloid) {
    for (const double radius : {1.5_nm, 4.5_nm}) {
        const ContactPair sharp{
            .tipRadius = radius, .reducedModulus = 50.0_GPa, .workOfAdhesion = 0.05};
        EXPECT_TRUE(leaves(ContactLaw::Maugis, sharp, 0.1_nm)) << radius;
        EXPECT_TRUE(leaves(ContactLaw::Split, sharp, 0.1_nm)) << radius;
        EXPECT_TRUE(leaves(ContactLaw::Maugis, sharp, -1.0_nm)) << "apart, " << radius;
        EXPECT_FALSE(leaves(ContactLaw::SphereMaugis, sharp, 0.1_nm)) << radius;
    }
    const ContactPair blunt{
        .tipRadius = 30.0_nm, .reducedModulus = 50.0_GPa, .workOfAdhesion = 0.05};
    EXPECT_FALSE(leaves(ContactLaw::Maugis, blunt, 0.1_nm));
}

TEST(LawRange, AnAttractionUpToTheEquatorIsBeyondTheSphereToo) {
    const ContactPair needle{
        .tipRadius = 0.3_nm, .reducedModulus = 50.0_GPa, .workOfAdhesion = 0.05};
    EXPECT_TRUE(leaves(ContactLaw::SphereMaugis, needle, 0.05_nm));
}

bool isThin(ContactLaw law, double thickness, double contactRadius) {
    const ContactPair pair{.tipRadius = 1.0_um, .reducedModulus = 1.0_GPa};
    const ContactModel model(law, pair, {.filmThickness = thickness});
    return contactValidity(model, {.contactRadius = contactRadius}, {.filmThickness = thickness})
        .has(Validity::ThinFilm);
}

TEST(ContactValidity, AFilmIsThinBeforeItStiffensTheContactByFivePercent) {
    const ContactPair pair{.tipRadius = 1.0_um, .reducedModulus = 1.0_GPa};
    const double thickness = 100.0_nm;
    const ContactModel hertz(ContactLaw::Hertz, pair);
    const ContactModel film(ContactLaw::HertzFilm, pair, {.filmThickness = thickness});
    for (const double indentation : {0.001_nm, 0.01_nm, 0.015_nm, 0.02_nm, 0.1_nm, 1.0_nm}) {
        const ContactState state = pressed(hertz, indentation);
        const double stiffening = pressed(film, indentation).force / state.force;
        if (stiffening > 1.05) {
            EXPECT_TRUE(isThin(ContactLaw::Hertz, thickness, state.contactRadius)) << indentation;
        }
        if (stiffening < 1.03) {
            EXPECT_FALSE(isThin(ContactLaw::Hertz, thickness, state.contactRadius)) << indentation;
        }
    }
}

TEST(ContactValidity, TheFilmsSeriesHoldsForContactsNarrowerThanTheFilmIsThick) {
    EXPECT_FALSE(isThin(ContactLaw::HertzFilm, 100.0_nm, 99.0_nm));
    EXPECT_TRUE(isThin(ContactLaw::HertzFilm, 100.0_nm, 101.0_nm));
    EXPECT_FALSE(isThin(ContactLaw::Hertz, 0.0, 101.0_nm)) << "a half-space";
}

}  // namespace
}  // namespace asperity
