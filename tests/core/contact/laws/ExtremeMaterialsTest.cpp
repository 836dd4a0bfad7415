#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/contact/laws/ExpectedState.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::expectClose;
using test::ReferenceTable;

/// All rows of T12: E 1 kPa .. 1 TPa, w 0 .. 10 J/m^2, R 1 nm .. 10 um, nu 0 .. 0.5, to a depth of
/// R, by Maugis-Dugdale in displacement control.
class ExtremeMaterials : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(table.rows(), 1120U); }

    [[nodiscard]] double cell(std::size_t row, const char* column) const {
        return table.number(row, column);
    }
    [[nodiscard]] ContactPair pair(std::size_t row) const {
        const Elastic sample{cell(row, "E_Pa"), cell(row, "nu")};
        const Elastic tip{cell(row, "E_tip_Pa"), 0.27};
        return {cell(row, "R_m"), reducedModulus(sample, tip), cell(row, "w")};
    }

    const ReferenceTable table = test::referenceTable("T12_extremes.csv");
};

TEST_F(ExtremeMaterials, HaveTheReferenceParameters) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model(ContactLaw::Maugis, pair(row));
        expectClose(model.pair().reducedModulus, cell(row, "Es_Pa"), 1e-14);
        expectClose(model.cohesiveStress(), cell(row, "s0_Pa"), 1e-14);
        expectClose(model.lambda(), cell(row, "lambda"), 1e-13);
    }
}

TEST_F(ExtremeMaterials, HaveTheReferenceStates) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model(ContactLaw::Maugis, pair(row));
        const double indentation = cell(row, "delta_m");
        const ContactState state = model.equilibrium(indentation, 0.0, {ContactBranch::Bonded});
        const ContactState expected{.force = cell(row, "P_N"),
                                    .indentation = indentation,
                                    .contactRadius = cell(row, "a_m"),
                                    .cohesiveRadius = cell(row, "c_m")};
        const bool contact = table.text(row, "kind") == "contact";
        const auto condition =
            test::rowCondition(model, {indentation, 0.0}, contact ? 0.0 : kCohesiveRange);
        if (state.branch != ContactBranch::Bonded) {
            // Only on the fold itself may rounding put the row beyond it.
            EXPECT_EQ(table.text(row, "state"), "jumpoff_disp");
            EXPECT_EQ(condition.tolerance, test::kFoldTolerance);
            continue;
        }
        test::expectState(state, expected, condition, maugisUnits(model.pair()));
        EXPECT_EQ(state.contactRadius > 0.0, contact && expected.contactRadius > 0.0);
    }
}

TEST_F(ExtremeMaterials, BreakWhereTheReferenceDoes) {
    int broken = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "state") != "jumpoff_disp") {
            continue;
        }
        SCOPED_TRACE(row);
        const ContactModel model(ContactLaw::Maugis, pair(row));
        expectClose(model.pullOffApproach(0.0), cell(row, "delta_m"), test::kLawTolerance);
        const ContactState last = model.lastBonded(0.0);
        expectClose(last.force, cell(row, "P_N"), 1e-11);
        expectClose(last.cohesiveRadius, cell(row, "c_m"), 1e-11);
        ++broken;
    }
    EXPECT_GT(broken, 100);
}

}  // namespace
}  // namespace asperity
