#include "core/scene/AttractionValidity.h"

#include "core/Units.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/Retardation.h"
#include "core/scene/LawRange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr ContactPair kGlassSphere{
    .tipRadius = 5.0_um, .reducedModulus = 53.39_GPa, .workOfAdhesion = 0.2};
constexpr double kSoftLever = 1.0 / 0.12;  // [m/N]

bool isRetarded(const ContactModel& model, const ContactState& state, double compliance) {
    return attractionValidity(model, state, compliance).has(Validity::RetardedAttraction);
}

/// Share of the attraction that light leaves. Source: Gregory (1981).
double shareLeft(double separation) { return 1.0 / (1.0 + 5.32 * separation / 100.0_nm); }

/// Distance of the base from touch where a rigid sphere snaps in, by Derjaguin's approximation: the
/// outermost one that no separation balances any more.
double snapInBase(double compliance, bool retarded) {
    const double strength =
        hamakerConstant(kGlassSphere.workOfAdhesion) * kGlassSphere.tipRadius / 6.0;
    double nearest = 1.0;
    for (double separation = 5.0_nm; separation < 50.0_nm; separation += 0.001_nm) {
        const double force =
            strength / (separation * separation) * (retarded ? shareLeft(separation) : 1.0);
        nearest = std::min(nearest, separation + (compliance * force));
    }
    return nearest - kContactSeparation;
}

/// A glass sphere of 5 um on a soft lever: the model's snap-in is 3 nm early.
TEST(AttractionValidity, ColloidsSnapInEarlyWithoutRetardation) {
    const ContactModel model(ContactLaw::Split, kGlassSphere);
    const ContactState last = model.lastFar(kSoftLever);
    const double base = last.indentation + (kSoftLever * last.force);
    EXPECT_NEAR(base, -21.1_nm, 0.2_nm);
    EXPECT_NEAR(base, -snapInBase(kSoftLever, false), 0.1_nm);
    EXPECT_NEAR(snapInBase(kSoftLever, true), 17.8_nm, 0.1_nm);
    EXPECT_TRUE(isRetarded(model, last, kSoftLever));
}

TEST(AttractionValidity, SharpTipsSnapInBeforeRetardationMatters) {
    const ContactPair sharp{
        .tipRadius = 15.0_nm, .reducedModulus = 53.39_GPa, .workOfAdhesion = 0.2};
    const ContactModel model(ContactLaw::Split, sharp);
    constexpr double kLever = 1.0 / 14.0;
    EXPECT_FALSE(isRetarded(model, model.lastFar(kLever), kLever));
}

TEST(AttractionValidity, RetardedIsAnAttractionThatMovesTheTipByATwentiethOfTheGapTooFar) {
    const ContactModel model(ContactLaw::Split, kGlassSphere);
    for (const double gap : {5.0_nm, 20.0_nm, 100.0_nm}) {
        const ContactState state = model.equilibrium(-gap, 0.0, {});
        const double separation = kContactSeparation + gap;
        const double lost = -state.force * (1.0 - shareLeft(separation));
        EXPECT_NEAR(retardedShare(separation), 1.0 - shareLeft(separation), 1e-15);
        const double limit = 0.05 * separation / lost;  // [m/N]
        EXPECT_FALSE(isRetarded(model, state, 0.98 * limit)) << gap;
        EXPECT_TRUE(isRetarded(model, state, 1.02 * limit)) << gap;
    }
    const ContactState touching = model.equilibrium(1.0_nm, 0.0, {});
    EXPECT_FALSE(isRetarded(model, touching, 1e3)) << "in contact";
    const ContactModel jkr(ContactLaw::Jkr, kGlassSphere);
    EXPECT_FALSE(isRetarded(jkr, jkr.equilibrium(-10.0_nm, 0.0, {}), 1e3)) << "has no tail";
}

/// A pair of this transition parameter: lambda goes as the inverse of E* to 2/3.
ContactPair pairOf(double lambda) {
    const ContactPair pair{
        .tipRadius = 15.0_nm, .reducedModulus = 2.35_GPa, .workOfAdhesion = 0.066};
    ContactPair wanted = pair;
    wanted.reducedModulus *=
        std::pow(pairLambda(ContactModel(ContactLaw::Maugis, pair)) / lambda, 1.5);
    return wanted;
}

TEST(AttractionValidity, StrengthLimitsPullOffWhereItIsNearerToDmtThanToJkr) {
    constexpr double kSoft = 1e5;  // [m/N]: under a load
    for (const double lambda : {0.01, 0.1, 0.41, 0.44, 1.0, 10.0}) {
        SCOPED_TRACE(lambda);
        const ContactPair pair = pairOf(lambda);
        const ContactModel model(ContactLaw::Maugis, pair);
        ASSERT_NEAR(model.lambda(), lambda, 1e-9 * lambda);
        const ContactState last = model.lastBonded(kSoft);
        const double unit = std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
        const ValidityFlags flags = attractionValidity(model, last, kSoft);
        EXPECT_EQ(flags.has(Validity::StrengthLimited), last.force < -1.75 * unit);
        const ContactState pressed = model.equilibrium(1.0_nm, 0.0, {});
        EXPECT_EQ(attractionValidity(model, pressed, kSoft).bits(), 0U) << "nobody pulls";
    }
}

}  // namespace
}  // namespace asperity
