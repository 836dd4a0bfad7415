#include "core/Error.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectClose;
using test::expectPoint;
using test::ReferenceTable;

constexpr double kTolerance = 1e-12;

/// A row of T25: in units of the sphere's radius and E*.
struct ConeRow {
    double halfAngle;
    double radius;
    ContactPair pair;
    double indentation;
    double force;

    [[nodiscard]] SneddonLaw elastic() const { return SneddonLaw(pair, halfAngle); }
    [[nodiscard]] SphereJkrLaw adhesive() const { return SphereJkrLaw(pair, halfAngle); }
    /// What the adhesion takes from elastic indentation and force.
    [[nodiscard]] double lift() const { return std::sqrt(2.0 * pi * radius * pair.workOfAdhesion); }
    [[nodiscard]] double pull() const { return 2.0 * radius * lift(); }

    void expect(const LawPoint& point) const {
        expectPoint(point, indentation, force, {.force = pull(), .indentation = lift()},
                    kTolerance);
        expectClose(point.contactRadius, radius, kTolerance);
    }
};

std::vector<ConeRow> coneRows() {
    const ReferenceTable table = test::referenceTable("T25_cone_sphere.csv");
    std::vector<ConeRow> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rows.push_back({table.number(row, "alpha_deg") * pi / 180.0,
                        table.number(row, "a"),
                        {1.0, 1.0, table.number(row, "w")},
                        table.number(row, "delta"),
                        table.number(row, "P")});
    }
    return rows;
}

TEST(ConeTip, HasTheReferenceStates) {
    const std::vector<ConeRow> rows = coneRows();
    ASSERT_EQ(rows.size(), 476U);
    for (const ConeRow& row : rows) {
        SCOPED_TRACE(::testing::Message() << row.halfAngle << " rad, a " << row.radius << ", w "
                                          << row.pair.workOfAdhesion);
        if (row.pair.workOfAdhesion == 0.0) {
            row.expect(row.elastic().at(row.radius));
        }
        row.expect(row.adhesive().at(row.radius));
    }
}

TEST(ConeTip, FindsTheReferenceStatesByIndentation) {
    int found = 0;
    for (const ConeRow& row : coneRows()) {
        SCOPED_TRACE(::testing::Message() << row.halfAngle << " rad, a " << row.radius << ", w "
                                          << row.pair.workOfAdhesion);
        if (row.pair.workOfAdhesion == 0.0) {
            const auto state = row.elastic().stable(row.indentation, 0.0);
            ASSERT_TRUE(state);
            row.expect(*state);
            ++found;
        } else if (row.radius > 1.01 * row.adhesive().fold(0.0).contactRadius) {
            const auto state = row.adhesive().stable(row.indentation, 0.0);
            ASSERT_TRUE(state);
            row.expect(*state);
            ++found;
        }
    }
    EXPECT_GT(found, 300);
}

/// Indentation and force from their definition, for a tip of any shape: docs/theory.md 4.8.
TEST(ConeTip, AgreesWithTheIntegralsOverItsShape) {
    for (const double halfAngle : {0.1, 0.3, 0.7, 1.2, 1.5, 1.55}) {
        const double joint = std::cos(halfAngle);
        const double slope = joint / std::sin(halfAngle);
        for (const double a : {0.5 * joint, joint, 1.0001 * joint, 1.1 * joint, 3.0, 100.0}) {
            const auto integral = [&](double from, double to, int power) {
                constexpr int kPieces = 400;
                double sum = 0.0;
                for (int i = 0; i < kPieces; ++i) {
                    sum += gaussLegendre(
                        [&](double angle) {
                            const double r = a * std::sin(angle);
                            const double rise =
                                r < joint ? r / std::sqrt((1.0 - r) * (1.0 + r)) : slope;
                            return rise * std::pow(r, power);
                        },
                        from + ((to - from) * i / kPieces),
                        from + ((to - from) * (i + 1) / kPieces));
                }
                return sum;
            };
            const double turn = a > joint ? std::asin(joint / a) : pi / 2.0;
            const LawPoint point = SneddonLaw({1.0, 1.0, 0.0}, halfAngle).at(a);
            SCOPED_TRACE(::testing::Message() << halfAngle << " rad, a " << a);
            expectClose(point.indentation,
                        a * (integral(0.0, turn, 0) + integral(turn, pi / 2.0, 0)), 1e-10);
            expectClose(point.force, 2.0 * (integral(0.0, turn, 2) + integral(turn, pi / 2.0, 2)),
                        1e-10);
        }
    }
}

/// docs/theory.md 4.8: dP / d(indentation) = 2 a E*, across the joint, too.
TEST(ConeTip, IsAsStiffAsItsContactIsWide) {
    for (const double halfAngle : {0.1, 0.3, 0.7, 1.2}) {
        const SneddonLaw law({1.0, 1.0, 0.0}, halfAngle);
        const double joint = std::cos(halfAngle);
        for (const double a : {0.2 * joint, 0.999 * joint, joint, 1.001 * joint, 1.5, 10.0}) {
            const double step = 1e-5 * a;
            const LawPoint less = law.at(a - step);
            const LawPoint more = law.at(a + step);
            const double slope = (more.force - less.force) / (more.indentation - less.indentation);
            EXPECT_NEAR(slope, 2.0 * a, 1e-5 * a) << halfAngle << " rad, a " << a;
            EXPECT_EQ(law.at(a).stiffness, 2.0 * law.at(a).contactRadius);
        }
    }
}

TEST(ConeTip, BecomesSneddonsConeAndSphere) {
    for (const double halfAngle : {0.2, 0.6, 1.2}) {
        const ContactPair pair{1.0, 1.0, 0.0};
        const SneddonLaw law(pair, halfAngle);
        const double a = 1e7;
        const double slope = 1.0 / std::tan(halfAngle);
        expectClose(law.at(a).indentation, pi / 2.0 * a * slope, 1e-6);
        expectClose(law.at(a).force, pi / 2.0 * a * a * slope, 1e-6);
        const double within = 0.9 * std::cos(halfAngle);
        EXPECT_EQ(law.at(within).force, SneddonLaw(pair).at(within).force);
        const ContactPair sticky{1.0, 1.0, 1e-3};
        EXPECT_EQ(SphereJkrLaw(sticky, halfAngle).at(within).force,
                  SphereJkrLaw(sticky).at(within).force);
        EXPECT_EQ(SphereJkrLaw(sticky, 0.2).fold(0.0).force, SphereJkrLaw(sticky).fold(0.0).force);
    }
}

/// The work of the force along a curve is the difference of the energies at its ends.
TEST(ConeTip, EnergyIsTheWorkOfItsForce) {
    for (const double halfAngle : {0.1, 0.3, 0.7, 1.4}) {
        const SneddonLaw elastic({1.0, 1.0, 0.0}, halfAngle);
        const SphereJkrLaw adhesive({1.0, 1.0, 0.05}, halfAngle);
        for (const double a : {0.5 * std::cos(halfAngle), 1.2, 5.0, 300.0}) {
            const auto expectWork = [&](const auto& law) {
                const double step = 1e-3 * a;
                const LawPoint less = law.at(a - step);
                const LawPoint here = law.at(a);
                const LawPoint more = law.at(a + step);
                const double work = (less.force + (4.0 * here.force) + more.force) / 6.0 *
                                    (more.indentation - less.indentation);
                EXPECT_NEAR(law.energy(more) - law.energy(less), work,
                            1e-4 * std::abs(work) + 1e-9 * law.energy(more))
                    << halfAngle << " rad, a " << a;
            };
            expectWork(elastic);
            expectWork(adhesive);
        }
    }
}

/// Strong adhesion on a soft lever leaves a stretch of stable states on the sphere and one on the
/// cone; a tip stays on its own until that ends. The ends are those of the curve of
/// docs/theory.md 4.8, sampled.
TEST(ConeTip, HasTwoStretchesOfStableStates) {
    constexpr double kSoft = 1e3;
    constexpr double kStep = 1.0;
    const double halfAngle = 17.5 * pi / 180.0;
    constexpr double kBetween = 1.3;  // contact radius between the two stretches
    const SphereJkrLaw law({1.0, 1.0, 3.0}, halfAngle);
    const LawPoint last = law.fold(kSoft);
    const double end = last.indentation + (kSoft * last.force);
    EXPECT_FALSE(law.stable(end - kStep, kSoft));
    EXPECT_NEAR(end, -5658.1, 0.1);
    double coordinate = 0.0;  // from the apex on
    double changed = 0.0;
    const auto follow = [&](double approach) {
        const auto state = law.stable(approach, kSoft, coordinate);
        ASSERT_TRUE(state);
        expectClose(state->indentation + (kSoft * state->force), approach, 1e-9, 1e4);
        const bool wasOut = coordinate > law.at(kBetween).coordinate;
        if (wasOut != (state->contactRadius > kBetween)) {
            changed = approach;
        }
        coordinate = state->coordinate;
    };
    for (double approach = end + kStep; approach < end + 1e3; approach += kStep) {
        follow(approach);
    }
    EXPECT_NEAR(changed, -5281.9, 2.0 * kStep);
    for (double approach = end + 1e3; approach > end + kStep; approach -= kStep) {
        follow(approach);
    }
    EXPECT_NEAR(changed, -5571.9, 2.0 * kStep);
}

/// Any cone, adhesion and lever: above the fold there is a state that balances the lever, and it
/// grows with the approach.
TEST(ConeTip, HasAStableStateAboveItsFold) {
    test::checkProperty([] {
        const double halfAngle = *test::logUniform(0.01, 1.55);
        const ContactPair pair{1.0, 1.0, *test::logUniform(1e-9, 1e3)};
        const double soft = *rc::gen::element(0.0, 1e-3, 1.0, 1e3, 1e6);
        const SphereJkrLaw law(pair, halfAngle);
        const LawPoint fold = law.fold(soft);
        const double end = fold.indentation + (soft * fold.force);
        const double above = *test::logUniform(1e-6, 1e6);
        const double size = std::abs(end) + above;
        RC_ASSERT(std::isfinite(end));
        RC_ASSERT(!law.stable(end - (1e-9 * size), soft));
        const auto state = law.stable(end + above, soft);
        RC_ASSERT(state.has_value());
        const double held = state->indentation + (soft * state->force);
        const double pulled = std::sqrt(2.0 * pi * state->contactRadius * pair.workOfAdhesion);
        const double parts = pulled * (1.0 + (2.0 * state->contactRadius * soft));
        RC_ASSERT(std::abs(held - (end + above)) <= 1e-12 * (size + parts));
        const auto next = law.stable(end + above + (1e-3 * size), soft, state->coordinate);
        RC_ASSERT(next.has_value());
        RC_ASSERT(next->contactRadius >= state->contactRadius);
    });
}

TEST(ConeTip, IsPartOfAContactModel) {
    const ContactPair pair{30e-9, 1.33e6, 0.022};
    const ContactOptions options{.coneHalfAngle = 0.3};
    const ContactModel jkr(ContactLaw::SphereJkr, pair, options);
    const ContactState wide = jkr.equilibrium(200e-9, 0.0, kBondedMemory);
    EXPECT_GT(wide.contactRadius, pair.tipRadius);
    EXPECT_EQ(wide.force, SphereJkrLaw(pair, 0.3).stable(200e-9, 0.0)->force);
    const ContactModel other = jkr.withTipRadius(10e-9);
    EXPECT_GT(other.equilibrium(200e-9, 0.0, kBondedMemory).contactRadius, 10e-9);
    EXPECT_THROW(ContactModel(ContactLaw::SphereJkr, pair, {.coneHalfAngle = 1.6}), Error);
    EXPECT_THROW(ContactModel(ContactLaw::Sneddon, pair, {.coneHalfAngle = NAN}), Error);
}

TEST(ConeTip, AllocatesNothing) {
    const SphereJkrLaw law({1.0, 1.0, 4.0}, 0.3);
    const std::size_t before = test::allocationCount();
    const auto state = law.stable(2.0, 10.0);
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(state);
}

}  // namespace
}  // namespace asperity
