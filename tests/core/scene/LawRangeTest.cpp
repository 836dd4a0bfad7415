#include "core/Units.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/scene/TipValidity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
constexpr ContactPair kHardPair{.tipRadius = 20e-9, .reducedModulus = 1e12, .workOfAdhesion = 1e-4};
constexpr ContactPair kSoftPair{.tipRadius = 10e-6, .reducedModulus = 1e8, .workOfAdhesion = 0.01};

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
    EXPECT_FALSE(leaves(ContactLaw::Dmt, kHardPair, 0.002_nm));
    EXPECT_TRUE(leaves(ContactLaw::Jkr, kHardPair, 0.002_nm));
    EXPECT_TRUE(leaves(ContactLaw::Dmt, kSoftPair, 10.0_nm));
    EXPECT_FALSE(leaves(ContactLaw::Jkr, kSoftPair, 10.0_nm));
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kHardPair, 0.002_nm));
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kSoftPair, 10.0_nm));
}

TEST(LawRange, LawsWithoutARangeDoNotKnowOfAttractionAcrossAGap) {
    EXPECT_TRUE(leaves(ContactLaw::Jkr, kSoftPair, -0.3_nm));
    EXPECT_FALSE(leaves(ContactLaw::Jkr, kSoftPair, -0.5_nm));
    EXPECT_TRUE(leaves(ContactLaw::Dmt, kHardPair, -0.3_nm));
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kHardPair, -0.3_nm));
}

/// The same pair with attraction over this range, as a scene asks for.
ContactModel ranged(ContactLaw law, const ContactPair& pair, double range) {
    return {law, pair, {.cohesiveStress = pair.workOfAdhesion / range}};
}

TEST(LawRange, GoesByTheRangeOfTheScene) {
    const ContactModel jkr = ranged(ContactLaw::Jkr, kSoftPair, 1.0_nm);  // lambda 5.2
    EXPECT_DOUBLE_EQ(jkr.cohesiveRange(), 1.0_nm);
    EXPECT_TRUE(leavesLawsRange(jkr, pressed(jkr, -0.7_nm))) << "the adhesion reaches so far";
    EXPECT_FALSE(leavesLawsRange(jkr, pressed(jkr, -1.5_nm)));
    EXPECT_FALSE(leaves(ContactLaw::Jkr, kSoftPair, -0.7_nm)) << "beyond 0.36 nm";
    const ContactModel longRange = ranged(ContactLaw::Jkr, kSoftPair, 2.0_nm);
    EXPECT_TRUE(leavesLawsRange(longRange, pressed(longRange, 10.0_nm))) << "lambda 2.6";
    const ContactModel shortRange = ranged(ContactLaw::Jkr, kPolymer, 0.01_nm);
    EXPECT_TRUE(leaves(ContactLaw::Jkr, kPolymer, 1.0_nm)) << "lambda 1.4";
    EXPECT_FALSE(leavesLawsRange(shortRange, pressed(shortRange, 1.0_nm))) << "lambda 48";
    const ContactModel wide = ranged(ContactLaw::Maugis, kPolymer, 5.0_nm);
    EXPECT_TRUE(leavesLawsRange(wide, pressed(wide, -20.0_nm))) << "will reach beyond 0.3 R";
    EXPECT_FALSE(leaves(ContactLaw::Maugis, kPolymer, -20.0_nm));
}

TEST(LawRange, TheRangeOfASplitLawIsItsOwn) {
    for (const ContactLaw law : {ContactLaw::Split, ContactLaw::SphereSplit}) {
        EXPECT_NEAR(ranged(law, kPolymer, 5.0_nm).cohesiveRange(), kCohesiveRange,
                    1e-12 * kCohesiveRange);
    }
    ContactPair bare = kPolymer;
    bare.workOfAdhesion = 0.0;
    EXPECT_EQ(ContactModel(ContactLaw::Hertz, bare).cohesiveRange(), 0.0);
}

TEST(LawRange, ATipAboutAsSharpAsItsAttractionIsLongIsNoParaboloid) {
    for (const double radius : {1.5_nm, 4.5_nm}) {
        const ContactPair sharp{
            .tipRadius = radius, .reducedModulus = 50.0_GPa, .workOfAdhesion = 0.05};
        EXPECT_TRUE(leaves(ContactLaw::Maugis, sharp, 0.1_nm)) << radius;
        EXPECT_TRUE(leaves(ContactLaw::Split, sharp, 0.1_nm)) << radius;
        EXPECT_TRUE(leaves(ContactLaw::Maugis, sharp, -1.0_nm)) << "apart, " << radius;
        EXPECT_FALSE(leaves(ContactLaw::SphereMaugis, sharp, 0.1_nm)) << radius;
        EXPECT_FALSE(leaves(ContactLaw::SphereSplit, sharp, 0.1_nm)) << radius;
    }
    const ContactPair blunt{
        .tipRadius = 30.0_nm, .reducedModulus = 50.0_GPa, .workOfAdhesion = 0.05};
    EXPECT_FALSE(leaves(ContactLaw::Maugis, blunt, 0.1_nm));
}

TEST(LawRange, AnAttractionUpToTheEquatorIsBeyondTheSphereToo) {
    const ContactPair needle{
        .tipRadius = 0.3_nm, .reducedModulus = 50.0_GPa, .workOfAdhesion = 0.05};
    EXPECT_TRUE(leaves(ContactLaw::SphereMaugis, needle, 0.05_nm));
    EXPECT_TRUE(leaves(ContactLaw::SphereSplit, needle, 0.05_nm));
}

TEST(ContactValidity, ASampleYieldsBelowTheSurfaceBeforeThePressureIsItsHardness) {
    const ContactPair pair{.tipRadius = 15.0_nm, .reducedModulus = 50.0_GPa};
    const ContactModel model(ContactLaw::Hertz, pair);
    const SampleMaterial material{.elastic = {.youngsModulus = 50.0_GPa, .poissonRatio = 0.3},
                                  .hardness = 9.0_GPa};
    const auto yieldsAt = [&](double pressure) {  // p0 = 2 E* a / (pi R)
        const double a = pressure * std::numbers::pi * pair.tipRadius / (2.0 * pair.reducedModulus);
        const ContactState state = pressed(model, a * a / pair.tipRadius);
        return contactValidity(model, state, material).has(Validity::ElasticLimit);
    };
    EXPECT_FALSE(yieldsAt(0.56 * material.hardness));
    EXPECT_TRUE(yieldsAt(0.59 * material.hardness)) << "1.61 Y, Y = H / 2.8";
}

/// A tip of 15 nm pressed 0.5 nm into oxide, 11.5 GPa in the middle, of which no hardness is given.
TEST(ContactValidity, YieldIsJudgedByTheModulusWhereNoHardnessIsGiven) {
    const ContactPair pair{.tipRadius = 15.0_nm, .reducedModulus = 53.4_GPa};
    const ContactModel model(ContactLaw::Hertz, pair);
    const ContactState state = pressed(model, 1.7_nm);
    SampleMaterial oxide{.elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27}};
    EXPECT_TRUE(contactValidity(model, state, oxide).has(Validity::ElasticLimit));
    EXPECT_FALSE(
        contactValidity(model, pressed(model, 0.01_nm), oxide).has(Validity::ElasticLimit));
    oxide.yields = false;
    EXPECT_FALSE(contactValidity(model, state, oxide).has(Validity::ElasticLimit));
}

constexpr ContactPair kFilmPair{.tipRadius = 1.0_um, .reducedModulus = 1.0_GPa};

bool isThin(ContactLaw law, double thickness, double contactRadius, double poissonRatio = 0.5) {
    const ContactModel model(law, kFilmPair,
                             {.filmThickness = thickness, .film = {.poissonRatio = poissonRatio}});
    return contactValidity(model, {.contactRadius = contactRadius}, {.filmThickness = thickness})
        .has(Validity::ThinFilm);
}

/// By the exact solution for the film's own Poisson ratio.
TEST(ContactValidity, AFilmIsThinWhereItStiffensTheContactByFivePercent) {
    const double thickness = 100.0_nm;
    const ContactModel hertz(ContactLaw::Hertz, kFilmPair);
    for (const double nu : {0.0, 0.3, 0.4, 0.5}) {
        SCOPED_TRACE(nu);
        const ContactModel film(ContactLaw::HertzFilm, kFilmPair,
                                {.filmThickness = thickness, .film = {.poissonRatio = nu}});
        int thin = 0;
        for (int i = 0; i < 60; ++i) {
            const double indentation = 0.005_nm * std::pow(1.05, i);
            const ContactState state = pressed(hertz, indentation);
            const bool stiffer = pressed(film, indentation).force > 1.05 * state.force;
            EXPECT_EQ(isThin(ContactLaw::Hertz, thickness, state.contactRadius, nu), stiffer);
            EXPECT_EQ(isThin(ContactLaw::Split, thickness, state.contactRadius, nu), stiffer);
            thin += stiffer ? 1 : 0;
        }
        EXPECT_GT(thin, 10);
        EXPECT_LT(thin, 50);
    }
}

TEST(ContactValidity, TheFilmsLawHoldsUpToContactsTwoThicknessesWide) {
    for (const double nu : {0.0, 0.5}) {
        EXPECT_FALSE(isThin(ContactLaw::HertzFilm, 100.0_nm, 199.0_nm, nu));
        EXPECT_TRUE(isThin(ContactLaw::HertzFilm, 100.0_nm, 201.0_nm, nu));
    }
    EXPECT_FALSE(isThin(ContactLaw::Hertz, 0.0, 101.0_nm)) << "a half-space";
}

/// The film's contact is wider than the root of R times the indentation: that is what counts.
TEST(ContactValidity, TheTrueContactRadiusDecides) {
    const double thickness = 100.0_nm;
    const ContactModel film(ContactLaw::HertzFilm, kFilmPair, {.filmThickness = thickness});
    const double indentation = 20.0_nm;  // root 141 nm, contact radius 210 nm
    const ContactState state = pressed(film, indentation);
    EXPECT_GT(state.contactRadius, 1.4 * std::sqrt(1.0_um * indentation));
    EXPECT_TRUE(contactValidity(film, state, {}).has(Validity::ThinFilm));
}

}  // namespace
}  // namespace asperity
