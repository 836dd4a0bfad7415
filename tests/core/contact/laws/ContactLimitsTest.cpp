#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/AnyContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::AnyContact;

/// Bonded states of two models at the same position, relative to `size` of the first.
struct Difference {
    double force;
    double contactRadius;
};

Difference differenceAt(const ContactModel& first, const ContactModel& second, double approach,
                        double compliance) {
    const ContactMemory bonded{ContactBranch::Bonded};
    const ContactState one = first.equilibrium(approach, compliance, bonded);
    const ContactState other = second.equilibrium(approach, compliance, bonded);
    const double pull = std::numbers::pi * first.pair().workOfAdhesion * first.pair().tipRadius;
    return {.force = std::abs(one.force - other.force) / (std::abs(one.force) + pull),
            .contactRadius = std::abs(one.contactRadius - other.contactRadius) /
                             (one.contactRadius + first.pair().tipRadius * 1e-12)};
}

/// The adhesion goes, and its part of force and contact with it.
TEST(ContactLimits, WithoutAdhesionEveryLawIsHertzOrSneddon) {
    test::checkProperty([] {
        AnyContact contact = test::anyDryContact();
        contact.pair.workOfAdhesion = *rc::gen::element(0.0, 1e-300, 1e-13);
        contact.options.cohesiveStress = 0.0;
        contact.options.filmThickness = 0.0;
        RC_PRE(contact.law != ContactLaw::HertzFilm);
        const bool sphere = isSphere(contact.law);
        const ContactModel model = contact.model();
        const ContactModel plain(sphere ? ContactLaw::Sneddon : ContactLaw::Hertz, contact.pair);
        const double approach = 10.0 * contact.pair.tipRadius * *test::fraction();
        const ContactState state = model.equilibrium(approach, contact.compliance, {});
        const ContactState expected = plain.equilibrium(approach, contact.compliance, {});
        RC_ASSERT(state.force == expected.force);
        RC_ASSERT(state.contactRadius == expected.contactRadius);
        RC_ASSERT(model.jumpInApproach(contact.compliance) == 0.0);
        RC_ASSERT(model.pullOffApproach(contact.compliance) == 0.0);
        RC_ASSERT(!state.jumped);
    });
}

/// Continuously so: with ever less adhesion the force comes ever closer.
TEST(ContactLimits, LittleAdhesionAddsLittle) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        const ContactOptions options{.filmThickness = law == ContactLaw::HertzFilm ? 1e-6 : 0.0};
        const ContactModel none(law, {15e-9, 1e9, 0.0}, options);
        const ContactModel little(law, {15e-9, 1e9, 1e-11}, options);
        const auto [force, radius] = differenceAt(none, little, 1e-9, 0.1);
        EXPECT_LT(force, 2e-5);  // as the square root of the adhesion for JKR
        EXPECT_LT(radius, 2e-5);
    }
}

/// Maugis-Dugdale with a stress of such range that lambda has this value.
ContactModel maugisOf(ContactLaw law, const ContactPair& pair, double lambda) {
    const MaugisUnits units = maugisUnits(pair);
    return {law, pair, {.cohesiveStress = lambda / transitionParameter(units, 1.0)}};
}

TEST(ContactLimits, MaugisDugdaleBecomesDmtWithAWeakWideStress) {
    const ContactPair pair{15e-9, 5e10, 0.2};
    const MaugisUnits units = maugisUnits(pair);
    const ContactModel dmt(ContactLaw::Dmt, pair);
    double before = 1.0;
    for (const double lambda : {1e-2, 1e-4, 1e-6}) {
        SCOPED_TRACE(lambda);
        const ContactModel maugis = maugisOf(ContactLaw::Maugis, pair, lambda);
        const double off = differenceAt(dmt, maugis, 3.0 * units.indentation, 0.1).force;
        EXPECT_LT(off, 3.0 * std::sqrt(lambda));
        EXPECT_LT(off, 0.2 * before);  // as the square root of lambda
        before = off;
    }
}

TEST(ContactLimits, MaugisDugdaleBecomesJkrWithAStrongNarrowStress) {
    const ContactPair pair{1e-6, 1e6, 0.05};
    const MaugisUnits units = maugisUnits(pair);
    const ContactModel jkr(ContactLaw::Jkr, pair);
    double before = 1.0;
    for (const double lambda : {1e1, 1e3, 1e5}) {
        SCOPED_TRACE(lambda);
        const ContactModel maugis = maugisOf(ContactLaw::Maugis, pair, lambda);
        const double off = differenceAt(jkr, maugis, units.indentation, 0.1).force;
        EXPECT_LT(off, 1.0 / lambda);
        EXPECT_LT(off, 1e-3 * before);  // as the inverse square of lambda
        before = std::max(off, 1e-10);
        const double fold = jkr.pullOffApproach(0.1);
        EXPECT_NEAR(maugis.pullOffApproach(0.1), fold, std::abs(fold) / lambda);
    }
}

TEST(ContactLimits, TheSphereOfMaugisDugdaleBecomesThatOfJkr) {
    const ContactPair pair{1e-8, 1e6, 0.005};
    const ContactModel jkr(ContactLaw::SphereJkr, pair);
    for (const double lambda : {1e2, 1e4}) {
        SCOPED_TRACE(lambda);
        const ContactModel maugis = maugisOf(ContactLaw::SphereMaugis, pair, lambda);
        EXPECT_LT(differenceAt(jkr, maugis, 5e-9, 0.1).force, 10.0 / lambda);
        EXPECT_LT(differenceAt(jkr, maugis, 5e-9, 0.1).contactRadius, 10.0 / lambda);
    }
}

/// A sphere that touches over little of itself is the paraboloid that osculates it, to the square
/// of a / R.
TEST(ContactLimits, SmallContactsOfASphereAreThoseOfTheParaboloid) {
    struct Twins {
        ContactLaw sphere;
        ContactLaw paraboloid;
    };
    for (const Twins twins : {Twins{ContactLaw::Sneddon, ContactLaw::Hertz},
                              Twins{ContactLaw::SphereJkr, ContactLaw::Jkr},
                              Twins{ContactLaw::SphereMaugis, ContactLaw::Maugis},
                              Twins{ContactLaw::SphereSplit, ContactLaw::Split}}) {
        SCOPED_TRACE(nameOf(twins.sphere));
        const double work = twins.sphere == ContactLaw::Sneddon ? 0.0 : 1e-3;
        for (const double radius : {1e-6, 1e-3}) {
            const ContactPair pair{radius, 1e11, work};
            const ContactModel sphere(twins.sphere, pair);
            const ContactModel paraboloid(twins.paraboloid, pair);
            const double approach = 1e-5 * radius;
            const ContactState state =
                paraboloid.equilibrium(approach, 0.0, {ContactBranch::Bonded});
            const double ratio = state.cohesiveRadius / radius;
            const auto [force, contact] = differenceAt(sphere, paraboloid, approach, 0.0);
            EXPECT_LT(force, 2.0 * ratio * ratio);
            EXPECT_LT(contact, 2.0 * ratio * ratio);
            EXPECT_GT(contact, 0.0);
        }
    }
}

TEST(ContactLimits, AThickFilmIsAHalfSpace) {
    const ContactPair pair{15e-9, 1e6, 0.0};
    const ContactModel hertz(ContactLaw::Hertz, pair);
    double before = 1.0;
    for (const double thickness : {1e-6, 1e-4, 1e-2}) {
        const ContactModel film(ContactLaw::HertzFilm, pair, {.filmThickness = thickness});
        const double off = differenceAt(hertz, film, 1e-9, 0.0).force;
        EXPECT_LT(off, 1.2 * std::sqrt(15e-9 * 1e-9) / thickness);
        EXPECT_LT(off, 0.02 * before);
        before = off;
    }
}

TEST(ContactLimits, AMeniscusWithoutTensionIsNone) {
    test::checkProperty([] {
        AnyContact contact = test::anyDryContact();
        const ContactModel dry = contact.model();
        contact.options.meniscus = test::anyMeniscus();
        contact.options.meniscus.surfaceTension = 0.0;
        const ContactModel without = contact.model();
        const double approach = test::anyApproach(dry, contact.compliance);
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            const ContactState state = dry.equilibrium(approach, contact.compliance, {branch});
            const ContactState same = without.equilibrium(approach, contact.compliance, {branch});
            RC_ASSERT(state.force == same.force);
            RC_ASSERT(state.energyLost == same.energyLost);
            RC_ASSERT(state.branch == same.branch);
        }
    });
}

/// And one of almost none almost so, but for approaches where it decides between two branches.
TEST(ContactLimits, AMeniscusOfLittleTensionAddsItsPull) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        ContactOptions options{.filmThickness = law == ContactLaw::HertzFilm ? 1e-6 : 0.0};
        const ContactPair pair{15e-9, 1e9, 0.05};
        const ContactModel dry(law, pair, options);
        options.meniscus = {.surfaceTension = 1e-9, .contactAngle = 0.3, .range = 2e-9};
        const ContactModel wet(law, pair, options);
        const ContactMemory bonded{ContactBranch::Bonded};
        const double pull = options.meniscus.pull(pair.tipRadius);
        EXPECT_NEAR(wet.equilibrium(2e-9, 0.0, bonded).force,
                    dry.equilibrium(2e-9, 0.0, bonded).force - pull, 1e-6 * pull);
        EXPECT_NEAR(wet.pullOffApproach(0.1), dry.pullOffApproach(0.1) - (0.1 * pull), 1e-22);
    }
}

}  // namespace
}  // namespace asperity
