#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/contact/laws/ExpectedState.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace asperity {
namespace {

using test::expectClose;
using test::kFoldTolerance;
using test::kLawTolerance;
using test::ReferenceTable;

/// Tip and sample whose Maugis units are all 1: R = 1 m, K = 1 Pa, pi w = 1 J/m^2.
ContactPair unitPair() { return {1.0, 0.75, 1.0 / std::numbers::pi}; }

/// Hertz, DMT and JKR of one pair.
struct ClassicLaws {
    explicit ClassicLaws(const ContactPair& pair) : hertz(pair), dmt(pair), jkr(pair) {}

    HertzLaw hertz;
    DmtLaw dmt;
    JkrLaw jkr;
};

/// The state of a law by a row; "nan" in its columns: there is none.
struct Row {
    const ReferenceTable& table;
    std::size_t row;

    [[nodiscard]] double number(const std::string& column) const {
        return table.number(row, column);
    }
    [[nodiscard]] bool has(const std::string& column) const {
        return std::isfinite(number(column));
    }
};

/// Contact radius, force and indentation, each relative to its size or to its Maugis unit.
void expectPoint(const LawPoint& point, const LawPoint& expected, const MaugisUnits& units,
                 double tolerance = kLawTolerance) {
    expectClose(point.contactRadius, expected.contactRadius, tolerance, units.radius);
    expectClose(point.cohesiveRadius, expected.contactRadius, tolerance, units.radius);
    test::expectPoint(point, expected.indentation, expected.force, units, tolerance);
}

TEST(ClassicLaws, AreTheReferenceAtAnyContactRadius) {
    const ReferenceTable table = test::referenceTable("T05a_classic_by_a.csv");
    ASSERT_EQ(table.rows(), 17U);
    const ClassicLaws laws(unitPair());
    const MaugisUnits units = maugisUnits(unitPair());
    for (std::size_t i = 0; i < table.rows(); ++i) {
        SCOPED_TRACE(i);
        const Row row{table, i};
        const double a = row.number("a_bar");
        const auto expected = [&](const char* force, const char* indentation) {
            return LawPoint{.force = row.number(force),
                            .indentation = row.number(indentation),
                            .contactRadius = a};
        };
        expectPoint(laws.hertz.atContactRadius(a), expected("hertz_P", "hertz_d"), units);
        expectPoint(laws.dmt.atContactRadius(a), expected("dmt_P", "dmt_d"), units);
        expectPoint(laws.jkr.atContactRadius(a), expected("jkr_P", "jkr_d"), units);
    }
}

TEST(ClassicLaws, AreTheReferenceUnderAnyLoadStableOrNot) {
    const ReferenceTable table = test::referenceTable("T05b_classic_by_load.csv");
    ASSERT_EQ(table.rows(), 18U);
    const ClassicLaws laws(unitPair());
    const MaugisUnits units = maugisUnits(unitPair());
    for (std::size_t i = 0; i < table.rows(); ++i) {
        SCOPED_TRACE(i);
        const Row row{table, i};
        const double force = row.number("P_bar");
        const auto expected = [&](const std::string& law) {
            return LawPoint{.force = force,
                            .indentation = row.number(law + "_d"),
                            .contactRadius = row.number(law + "_a")};
        };
        if (row.has("hertz_a")) {
            expectPoint(laws.hertz.atForce(force), expected("hertz"), units);
        }
        if (row.has("dmt_a")) {
            expectPoint(laws.dmt.atForce(force), expected("dmt"), units);
        }
        // At pull-off itself a rounding of the force moves the contact by its square root.
        const double tolerance =
            std::abs(force + 1.5) <= 1e-6 * 1.5 ? kFoldTolerance : kLawTolerance;
        const auto stable = laws.jkr.atForce(force);
        const auto unstable = laws.jkr.unstableAtForce(force);
        ASSERT_EQ(stable.has_value(), row.has("jkr_s_a"));
        ASSERT_EQ(unstable.has_value(), row.has("jkr_u_a"));
        if (stable) {
            expectPoint(*stable, expected("jkr_s"), units, tolerance);
        }
        if (unstable) {
            expectPoint(*unstable, expected("jkr_u"), units, tolerance);
        }
    }
}

TEST(ClassicLaws, AreTheReferenceAtAnyIndentationStableOrNot) {
    const ReferenceTable table = test::referenceTable("T05c_classic_by_delta.csv");
    ASSERT_EQ(table.rows(), 14U);
    const ClassicLaws laws(unitPair());
    const MaugisUnits units = maugisUnits(unitPair());
    for (std::size_t i = 0; i < table.rows(); ++i) {
        SCOPED_TRACE(i);
        const Row row{table, i};
        const double indentation = row.number("delta_bar");
        const auto expected = [&](const std::string& law) {
            return LawPoint{.force = row.number(law + "_P"),
                            .indentation = indentation,
                            .contactRadius = row.number(law + "_a")};
        };
        if (row.has("hertz_a")) {
            expectPoint(laws.hertz.atIndentation(indentation), expected("hertz"), units);
            expectPoint(laws.dmt.atIndentation(indentation), expected("dmt"), units);
        }
        // The first row lies above the fold by less than a rounding, which may put it below.
        const LawPoint fold = laws.jkr.fold(0.0);
        const bool atFold = i == 0;
        const double tolerance = atFold ? kFoldTolerance : kLawTolerance;
        const auto stable = laws.jkr.atIndentation(indentation);
        const auto unstable = laws.jkr.unstableAtIndentation(indentation);
        ASSERT_TRUE(stable || atFold);
        expectPoint(stable.value_or(fold), expected("jkr_s"), units, tolerance);
        if (row.has("jkr_u_a")) {
            ASSERT_TRUE(unstable || atFold);
            expectPoint(unstable.value_or(fold), expected("jkr_u"), units, tolerance);
        }
    }
}

/// Where the contact of the unstable state vanishes, its size is what counts, not its unit.
TEST(ClassicLaws, KeepTheSmallestUnstableContactToFullPrecision) {
    const ReferenceTable table = test::referenceTable("T05c_classic_by_delta.csv");
    const JkrLaw jkr(unitPair());
    for (std::size_t i = 1; i < table.rows(); ++i) {
        const Row row{table, i};
        if (!row.has("jkr_u_a")) {
            continue;
        }
        SCOPED_TRACE(i);
        const auto unstable = jkr.unstableAtIndentation(row.number("delta_bar"));
        ASSERT_TRUE(unstable);
        expectClose(unstable->contactRadius, row.number("jkr_u_a"), kLawTolerance);
        expectClose(unstable->force, row.number("jkr_u_P"), kLawTolerance);
    }
}

TEST(ClassicLaws, AreTheReferenceForThePapersMaterials) {
    const ReferenceTable table = test::referenceTable("T05d_classic_dimensional.csv");
    ASSERT_EQ(table.rows(), 24U);
    for (std::size_t i = 0; i < table.rows(); ++i) {
        SCOPED_TRACE(i);
        const Row row{table, i};
        const Elastic sample{row.number("E_Pa"), row.number("nu")};
        const ContactPair pair{row.number("R_m"), reducedModulus(sample, {169e9, 0.27}),
                               row.number("w_J_m2")};
        EXPECT_EQ(table.text(i, "material"), sample.youngsModulus > 1e10  ? "SiO2"
                                             : sample.youngsModulus > 1e8 ? "PS"
                                                                          : "rubber");
        expectClose(pair.reducedModulus, row.number("Es_Pa"), 1e-15);
        expectClose(4.0 / 3.0 * pair.reducedModulus, row.number("K_Pa"), 1e-15);
        const ClassicLaws laws(pair);
        const MaugisUnits units = maugisUnits(pair);
        const double force = row.number("P_N");
        const auto expected = [&](const std::string& law) {
            return LawPoint{.force = force,
                            .indentation = row.number(law + "_delta_m"),
                            .contactRadius = row.number(law + "_a_m")};
        };
        if (row.has("hertz_a_m")) {
            expectPoint(laws.hertz.atForce(force), expected("hertz"), units);
        }
        expectPoint(laws.dmt.atForce(force), expected("dmt"), units);
        const auto jkr = laws.jkr.atForce(force);
        ASSERT_TRUE(jkr);
        expectPoint(*jkr, expected("jkr"), units);
    }
}

}  // namespace
}  // namespace asperity
