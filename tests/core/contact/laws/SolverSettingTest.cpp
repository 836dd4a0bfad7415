#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisTable.h"
#include "tests/core/contact/laws/AnyContact.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using test::AnyContact;
using test::kInfinity;
using test::kNan;

/// Whatever a memory may hold: a coordinate of this curve, of another, or garbage.
double anyCoordinate() {
    return *rc::gen::oneOf(
        test::logUniform(1e-3, 1e3), test::logUniform(1e-150, 1e150),
        rc::gen::element(0.0, -0.0, -1.0, kNan, kInfinity, -kInfinity, 5e-324, 1.7e308, -1.7e308));
}

AnyContact anyCohesiveContact() {
    AnyContact contact = test::anyDryContact();
    contact.law = *rc::gen::element(ContactLaw::Maugis, ContactLaw::Split);
    contact.pair.workOfAdhesion = std::max(contact.pair.workOfAdhesion, 1e-9);
    contact.options.filmThickness = 0.0;
    contact.options.cohesiveStress = 0.0;
    return contact;
}

ContactModel withSolver(AnyContact contact, SolverSetting solver) {
    contact.options.solver = solver;
    return contact.model();
}

/// An approach of bonded states, dense at the fold.
double bondedApproach(const ContactModel& model, double compliance) {
    const double end = model.pullOffApproach(compliance);
    const double depth = model.pair().tipRadius * *test::logUniform(1e-9, 10.0);
    return *rc::gen::oneOf(rc::gen::just(end), rc::gen::just(end + depth),
                           rc::gen::just(end - depth),
                           rc::gen::just(end + (1e-9 * std::abs(end) * *test::fraction())));
}

/// How far four roundings of the approach move the state, and rounding of what cancels in it.
ContactState allowance(const AnyContact& contact, const ContactModel& model, double approach) {
    const ContactMemory bonded{ContactBranch::Bonded};
    const auto at = [&](double position) {
        const ContactState state = model.equilibrium(position, contact.compliance, bonded);
        return state.branch == ContactBranch::Bonded ? state : model.lastBonded(contact.compliance);
    };
    const ContactState here = at(approach);
    const double nudge = 16.0 * std::numeric_limits<double>::epsilon() *
                         (std::abs(approach) + indentationSize(contact, model, here) +
                          (contact.compliance * forceSize(contact, model, here)));
    const ContactState low = at(approach - nudge);
    const ContactState high = at(approach + nudge);
    ContactState limit;
    limit.force = std::abs(high.force - low.force) + (1e-14 * forceSize(contact, model, here));
    limit.contactRadius = high.contactRadius - low.contactRadius + (1e-14 * here.contactRadius);
    limit.cohesiveRadius =
        std::abs(high.cohesiveRadius - low.cohesiveRadius) + (1e-14 * here.cohesiveRadius);
    return limit;
}

TEST(SolverSetting, NewtonsStateIsTheExactOneFromAnyMemory) {
    test::checkProperty([] {
        const AnyContact contact = anyCohesiveContact();
        RC_LOG() << contact << '\n';
        const ContactModel exact = withSolver(contact, SolverSetting::Exact);
        const ContactModel newton = withSolver(contact, SolverSetting::Newton);
        const double approach = bondedApproach(exact, contact.compliance);
        const double coordinate = anyCoordinate();
        RC_LOG() << "approach " << approach << " coordinate " << coordinate << '\n';
        const ContactState cold =
            exact.equilibrium(approach, contact.compliance, {ContactBranch::Bonded});
        const ContactState warm =
            newton.equilibrium(approach, contact.compliance, {ContactBranch::Bonded, coordinate});
        RC_ASSERT(cold.branch == warm.branch);
        const ContactState limit = allowance(contact, exact, approach);
        RC_ASSERT(std::abs(cold.force - warm.force) <= limit.force);
        RC_ASSERT(std::abs(cold.contactRadius - warm.contactRadius) <= limit.contactRadius);
        RC_ASSERT(std::abs(cold.cohesiveRadius - warm.cohesiveRadius) <= limit.cohesiveRadius);
    });
}

/// The exact solver has no memory but the branch.
TEST(SolverSetting, TheExactStateDoesNotDependOnMemory) {
    test::checkProperty([] {
        const AnyContact contact = anyCohesiveContact();
        const ContactModel exact = withSolver(contact, SolverSetting::Exact);
        const double approach = bondedApproach(exact, contact.compliance);
        const ContactState one =
            exact.equilibrium(approach, contact.compliance, {ContactBranch::Bonded});
        const ContactState other = exact.equilibrium(approach, contact.compliance,
                                                     {ContactBranch::Bonded, anyCoordinate()});
        RC_ASSERT(one.force == other.force);
        RC_ASSERT(one.contactRadius == other.contactRadius);
    });
}

/// A few tables, because each takes a while to build: stiff, middle and soft, and one pair whose
/// lambda no table covers.
TEST(SolverSetting, TheTablesStateIsWithinItsBoundFromAnyMemory) {
    for (const ContactLaw law : {ContactLaw::Maugis, ContactLaw::Split}) {
        for (const ContactPair& pair :
             {ContactPair{15e-9, 5e10, 0.2}, ContactPair{15e-9, 2.35e9, 0.066},
              ContactPair{15e-9, 1.33e6, 0.022}, ContactPair{1e-3, 1e3, 100.0},
              ContactPair{1e-10, 1e13, 1e-6}}) {
            const ContactModel table(law, pair, {.solver = SolverSetting::Table});
            const ContactModel exact(law, pair, {.solver = SolverSetting::Exact});
            const MaugisUnits units = maugisUnits(pair);
            const double bound = table.table() != nullptr ? table.table()->errorBound() : 0.0;
            test::checkProperty([&] {
                AnyContact contact{.law = law, .pair = pair};
                contact.compliance =
                    *rc::gen::oneOf(rc::gen::just(0.0), test::logUniform(1e-6, 1e2));
                const double approach = bondedApproach(exact, contact.compliance);
                const ContactState cold =
                    exact.equilibrium(approach, contact.compliance, {ContactBranch::Bonded});
                const ContactState quick = table.equilibrium(
                    approach, contact.compliance, {ContactBranch::Bonded, anyCoordinate()});
                RC_ASSERT(cold.branch == quick.branch);
                const ContactState limit = allowance(contact, exact, approach);
                const auto allowed = [bound](double size, double unit, double rounding) {
                    return (bound * std::max(std::abs(size), unit)) + rounding;
                };
                RC_ASSERT(std::abs(cold.force - quick.force) <=
                          allowed(cold.force, units.force, limit.force));
                RC_ASSERT(std::abs(cold.contactRadius - quick.contactRadius) <=
                          allowed(cold.contactRadius, units.radius, limit.contactRadius));
                RC_ASSERT(std::abs(cold.cohesiveRadius - quick.cohesiveRadius) <=
                          allowed(cold.cohesiveRadius, units.radius, limit.cohesiveRadius));
            });
        }
    }
}

/// Also where the surface curves under the tip, and far outside of what the table covers.
TEST(SolverSetting, TheTableFollowsACurvedSurfaceWithinItsBound) {
    const ContactPair pair{15e-9, 2.35e9, 0.066};
    const ContactModel table(ContactLaw::Split, pair, {.solver = SolverSetting::Table});
    const ContactModel exact(ContactLaw::Split, pair, {.solver = SolverSetting::Exact});
    ASSERT_NE(table.table(), nullptr);
    const double bound = table.table()->errorBound();
    test::checkProperty([&] {
        const double radius = 15e-9 * *test::logUniform(1e-2, 1e2);
        const ContactModel curved = exact.withTipRadius(radius);
        const double approach = curved.pullOffApproach(0.07) + (radius * *test::fraction());
        const ContactMemory bonded{ContactBranch::Bonded, anyCoordinate()};
        const ContactState cold = curved.equilibrium(approach, 0.07, bonded);
        const ContactState quick = table.withTipRadius(radius).equilibrium(approach, 0.07, bonded);
        const MaugisUnits units = maugisUnits(curved.pair());
        RC_ASSERT(cold.branch == quick.branch);
        const AnyContact contact{
            .law = ContactLaw::Split, .pair = curved.pair(), .options = {}, .compliance = 0.07};
        const ContactState limit = allowance(contact, curved, approach);
        RC_ASSERT(std::abs(cold.force - quick.force) <=
                  (bound * std::max(std::abs(cold.force), units.force)) + limit.force);
    });
}

/// Else a setting that nobody asks would pass every comparison.
TEST(SolverSetting, TheTableAnswersForItself) {
    const ContactPair pair{15e-9, 2.35e9, 0.066};
    const ContactModel exact(ContactLaw::Split, pair, {.solver = SolverSetting::Exact});
    const ContactModel table(ContactLaw::Split, pair, {.solver = SolverSetting::Table});
    EXPECT_EQ(exact.table(), nullptr);
    ASSERT_NE(table.table(), nullptr);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        const double approach = 1e-10 + (i * 1e-11);
        const ContactMemory bonded{ContactBranch::Bonded};
        const double bound = table.table()->errorBound();
        const ContactState one = exact.equilibrium(approach, 0.0, bonded);
        const ContactState other = table.equilibrium(approach, 0.0, bonded);
        different += one.force != other.force ? 1 : 0;
        EXPECT_NEAR(one.force, other.force, bound * (std::abs(one.force) + 4e-9));
    }
    EXPECT_GT(different, 50) << "to the last bit they are not the same";
}

}  // namespace
}  // namespace asperity
