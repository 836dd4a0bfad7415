#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/FloatingPointTraps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::expectClose;
using test::ReferenceTable;

ASPERITY_TRAP_FLOATING_POINT();

MaugisPoint pointOfRow(const MaugisDugdale& law, const ReferenceTable& table, std::size_t row) {
    const double a = table.number(row, "a_bar");
    return a > 0.0 ? law.atContactRadius(a) : law.curve().noncontact(table.number(row, "c_bar"));
}

TEST(MaugisCurve, AgreesWithTheReferenceCurveAtGivenContactRadius) {
    const ReferenceTable table = test::referenceTable("T01_md_curve.csv");
    ASSERT_EQ(table.rows(), 816U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const MaugisPoint point = pointOfRow(law, table, row);
        expectClose(point.cohesiveRadius, table.number(row, "c_bar"), 1e-12);
        expectClose(point.force, table.number(row, "P_bar"), 1e-12, 1.0);
        expectClose(point.indentation, table.number(row, "delta_bar"), 1e-12, 1.0);
    }
}

/// The angle is known to full relative precision at neither end of its range from the radii alone.
TEST(MaugisCurve, KnowsTheAngleOfTheCohesiveZone) {
    const ReferenceTable table = test::referenceTable("T01_md_curve.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        expectClose(pointOfRow(law, table, row).angle, table.number(row, "phi"), 1e-13);
    }
}

TEST(MaugisCurve, HasTheReferenceStiffness) {
    const ReferenceTable table = test::referenceTable("T01_md_curve.csv");
    int compared = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double expected = table.number(row, "dPdd");
        // Rows that sit on a fold have a stiffness of 0 or infinity up to rounding.
        if (!std::isfinite(expected) || std::abs(expected) < 1e-20 || std::abs(expected) > 1e20) {
            continue;
        }
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const MaugisPoint point = pointOfRow(law, table, row);
        expectClose(point.forceRate / point.indentationRate, expected, 1e-9);
        ++compared;
    }
    EXPECT_GT(compared, 700);
}

TEST(MaugisCurve, PassesSmoothlyFromCohesionToContact) {
    for (const double lambda : {1e-12, 1e-4, 0.1, 0.937947457, 3.0, 1e3, 1e7}) {
        SCOPED_TRACE(lambda);
        const MaugisCurve curve(lambda);
        const MaugisPoint before = curve.noncontact(curve.touchRadius());
        const MaugisPoint after = curve.contact(0.0);
        expectClose(after.cohesiveRadius, before.cohesiveRadius, 1e-14);
        expectClose(after.force, before.force, 1e-14);
        expectClose(after.indentation, before.indentation, 1e-13, curve.range());
        EXPECT_NEAR(after.forceRate * before.indentationRate,
                    before.forceRate * after.indentationRate,
                    1e-13 * std::abs(after.forceRate) * (before.cohesiveRadius + lambda));
    }
}

TEST(MaugisCurve, RatesAreDerivatives) {
    test::checkProperty([] {
        const double lambda = *test::logUniform(1e-6, 1e6);
        const double coordinate = *test::logUniform(1e-2, 1e2) * (lambda + std::sqrt(lambda));
        const MaugisCurve curve(lambda);
        const double step = 1e-5 * coordinate;
        const MaugisPoint low = curve.contact(coordinate - step);
        const MaugisPoint high = curve.contact(coordinate + step);
        const MaugisPoint here = curve.contact(coordinate);
        // Two exact derivatives along the curve: their ratio is free of the parameter.
        const double byForce = (high.force - low.force) * here.indentationRate;
        const double byIndentation = (high.indentation - low.indentation) * here.forceRate;
        const double crossed = std::abs(here.forceRate * here.indentation) +
                               std::abs(here.indentationRate * here.force);
        const double size = std::abs(byForce) + std::abs(byIndentation) + (1e-5 * crossed);
        RC_ASSERT(std::abs(byForce - byIndentation) <= (1e-5 * size) + (4e-15 * crossed));
    });
}

TEST(MaugisCurve, EnergyIsTheWorkOfTheForce) {
    test::checkProperty([] {
        const double lambda = *test::logUniform(1e-4, 1e2);
        const double coordinate = *test::logUniform(1e-1, 1e1) * (lambda + std::sqrt(lambda));
        const MaugisCurve curve(lambda);
        const MaugisPoint low = curve.contact(0.9999 * coordinate);
        const MaugisPoint high = curve.contact(1.0001 * coordinate);
        const MaugisPoint here = curve.contact(coordinate);
        const double work = (high.indentation - low.indentation) *
                            (low.force + (4.0 * here.force) + high.force) / 6.0;
        const double gained = curve.energy(high) - curve.energy(low);
        // Where the indentation turns back its span is of second order, the error not.
        const double span = std::abs(high.indentation - low.indentation) +
                            (1e-4 * here.contactRadius * here.contactRadius);
        const double rounding = 1e-14 * (1.0 + lambda) * (1.0 + std::abs(curve.energy(here)));
        RC_ASSERT(std::abs(work - gained) <=
                  (1e-5 * (std::abs(here.force) + 1.0) * span) + rounding);
    });
}

TEST(MaugisCurve, DissipatesTheReferenceEnergies) {
    const ReferenceTable table = test::referenceTable("T02_md_critical.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const double lambda = table.number(row, "lambda");
        const double tolerance = 1e-12 + (1e-15 * lambda);
        const MaugisDugdale law(lambda);
        const MaugisCurve& curve = law.curve();
        const auto displacement = MaugisControl::displacement();
        const auto landing = law.stable(displacement, -curve.range());
        const auto unloaded = law.stable(MaugisControl::load(), 0.0);
        ASSERT_TRUE(landing && unloaded);
        expectClose(-curve.energy(*landing), table.number(row, "E_in"), tolerance);
        expectClose(curve.energy(law.fold(displacement)), table.number(row, "E_out"), tolerance);
        expectClose(-curve.energy(*unloaded), table.number(row, "W_sep0"), tolerance);
    }
}

/// Hertz's profile, the attraction 2 pi w R outside of it, and a rigid Dugdale gap before contact.
TEST(MaugisCurve, BecomesDmtForStiffSmallTips) {
    for (const double lambda : {1e-13, 1e-9, 1e-7}) {
        SCOPED_TRACE(lambda);
        const MaugisDugdale law(lambda);
        const double residual = 5.0 * std::sqrt(lambda);
        for (const double a : {0.01, 1.0, 30.0}) {
            const MaugisPoint point = law.atContactRadius(a);
            expectClose(point.force, (a * a * a) - 2.0, residual, 2.0);
            expectClose(point.indentation, a * a, residual, 1.0);
        }
        for (const double gap : {0.1, 0.5, 0.9}) {
            const auto point =
                law.stable(MaugisControl::displacement(), -gap * law.curve().range());
            ASSERT_TRUE(point);
            EXPECT_EQ(point->contactRadius, 0.0);
            expectClose(point->force, -2.0 * (1.0 - gap), residual);
        }
    }
}

TEST(MaugisCurve, BecomesJkrForSoftLargeTips) {
    const MaugisDugdale law(1e7);
    for (const double a : {0.6, 1.0, 1.8, 5.0, 100.0}) {
        SCOPED_TRACE(a);
        const MaugisPoint point = law.atContactRadius(a);
        expectClose(point.force, (a * a * a) - (a * std::sqrt(6.0 * a)), 1e-12, 1.0);
        expectClose(point.indentation, (a * a) - (2.0 / 3.0 * std::sqrt(6.0 * a)), 1e-12, 1.0);
    }
    expectClose(law.fold(MaugisControl::load()).force, -1.5, 1e-12);
    const MaugisPoint jumpOff = law.fold(MaugisControl::displacement());
    expectClose(jumpOff.force, -5.0 / 6.0, 1e-12);
    expectClose(jumpOff.indentation, -3.0 * std::pow(6.0, -2.0 / 3.0), 1e-12);
}

}  // namespace
}  // namespace asperity
