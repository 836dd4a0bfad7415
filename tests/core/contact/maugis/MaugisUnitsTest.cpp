#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

using test::expectClose;

TEST(MaugisUnits, OfThePapersMaterials) {
    const test::ReferenceTable table = test::referenceTable("T16_parameters.csv");
    ASSERT_EQ(table.rows(), 9U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const Elastic sample{table.number(row, "E"), table.number(row, "nu")};
        const Elastic tip{table.number(row, "E_tip"), table.number(row, "nu_tip")};
        const ContactPair pair{table.number(row, "R"), reducedModulus(sample, tip),
                               table.number(row, "w")};
        const MaugisUnits units = maugisUnits(pair);
        expectClose(pair.reducedModulus, table.number(row, "Es"), 1e-14);
        expectClose(units.radius, table.number(row, "ua"), 1e-14);
        expectClose(units.force, table.number(row, "uP"), 1e-14);
        expectClose(units.indentation, table.number(row, "ud"), 1e-14);
        expectClose(transitionParameter(units, table.number(row, "s0")),
                    table.number(row, "lambda"), 1e-14);
        expectClose(4.0 / 3.0 * pair.reducedModulus, table.number(row, "K"), 1e-14);
        expectClose(pair.workOfAdhesion / table.number(row, "s0"), table.number(row, "h0"), 1e-14);
        expectClose(hamakerConstant(pair.workOfAdhesion), table.number(row, "H"), 1e-14);
    }
}

/// Tabor's parameter of a Lennard-Jones spacing z0, beside lambda = 1.157 of it where the cohesive
/// stress is that potential's largest. Source: docs/theory.md 1.
TEST(MaugisUnits, FollowTaborsParameter) {
    const test::ReferenceTable table = test::referenceTable("T16_parameters.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const ContactPair pair{cell("R"), cell("Es"), cell("w")};
        const double strain = pair.workOfAdhesion / (pair.reducedModulus * cell("z0"));
        const double tabor = std::cbrt(pair.tipRadius / cell("z0") * strain * strain);
        expectClose(tabor, cell("mu"), 1e-14);
        if (table.text(row, "tag") == "H357") {
            expectClose(cell("h0"), kCohesiveRange, 1e-15);
            continue;
        }
        const double peak = 16.0 / (9.0 * std::sqrt(3.0)) * pair.workOfAdhesion / cell("z0");
        const double lambda = transitionParameter(maugisUnits(pair), peak);
        expectClose(peak, cell("s0"), 1e-14);
        expectClose(lambda, cell("lambda"), 1e-14);
        EXPECT_NEAR(lambda / tabor, 1.1570, 5e-5);
    }
}

TEST(Material, SharesTheDisplacementByCompliance) {
    const Elastic silicon{169e9, 0.27};
    const Elastic rubber{1e6, 0.5};
    const Elastic rigid{std::numeric_limits<double>::infinity(), 0.3};
    EXPECT_DOUBLE_EQ(sampleShare(silicon, silicon), 0.5);
    EXPECT_DOUBLE_EQ(sampleShare(rubber, rigid), 1.0);
    EXPECT_DOUBLE_EQ(reducedModulus(rubber, rigid), 1e6 / 0.75);
    EXPECT_NEAR(sampleShare({70e9, 0.27}, silicon), 0.70, 0.01);  // docs/theory.md 4.3
    EXPECT_DOUBLE_EQ(sampleShare(rubber, silicon) + sampleShare(silicon, rubber), 1.0);
}

}  // namespace
}  // namespace asperity
