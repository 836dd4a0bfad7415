#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/contact/laws/ExpectedState.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::expectClose;
using test::kLeverFoldTolerance;
using test::paperPair;
using test::ReferenceTable;

ContactModel maugisModel(const ReferenceTable& table, std::size_t row) {
    return {ContactLaw::Maugis, paperPair(table.text(row, "material"))};
}

TEST(MaugisOnALever, FollowsTheReferenceOutOfContact) {
    const ReferenceTable table = test::referenceTable("T14_quasistatic_curve.csv");
    ASSERT_EQ(table.rows(), 81U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model = maugisModel(table, row);
        const double compliance = 1.0 / table.number(row, "k");
        const double approach = table.number(row, "x_base_m");
        const ContactState state = model.equilibrium(approach, compliance, {ContactBranch::Bonded});
        const ContactState expected{.force = table.number(row, "P_N"),
                                    .indentation = table.number(row, "delta_m"),
                                    .contactRadius = table.number(row, "a_m"),
                                    .cohesiveRadius = table.number(row, "c_m")};
        const auto condition = test::rowCondition(model, {approach, compliance}, 0.0);
        const MaugisUnits units = maugisUnits(model.pair());
        test::expectState(state, expected, condition, units);
        EXPECT_EQ(state.contactRadius > 0.0, table.text(row, "kind") == "contact");
        EXPECT_NEAR(compliance * state.force, table.number(row, "deflection_m"),
                    compliance * std::max(condition.tolerance *
                                              std::max(std::abs(expected.force), units.force),
                                          condition.force));
    }
}

class MaugisOnALeverCritical : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(table.rows(), 3U); }

    [[nodiscard]] double cell(std::size_t row, const char* column) const {
        return table.number(row, column);
    }

    const ReferenceTable table = test::referenceTable("T14c_quasistatic_critical.csv");
};

TEST_F(MaugisOnALeverCritical, PullsOffAtTheReferenceState) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model = maugisModel(table, row);
        const double compliance = 1.0 / cell(row, "k");
        const ContactState last = model.lastBonded(compliance);
        const ContactState expected{.force = cell(row, "off_P_N"),
                                    .indentation = cell(row, "off_delta_m"),
                                    .contactRadius = cell(row, "off_a_m"),
                                    .cohesiveRadius = cell(row, "off_c_m")};
        test::expectState(last, expected, {.tolerance = kLeverFoldTolerance},
                          maugisUnits(model.pair()));
        EXPECT_EQ(last.contactRadius > 0.0, table.text(row, "off_kind") == "contact");
        expectClose(model.pullOffApproach(compliance), cell(row, "off_xb_m"), test::kLawTolerance);
    }
}

TEST_F(MaugisOnALeverCritical, SnapsInToTheReferenceState) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model = maugisModel(table, row);
        const double compliance = 1.0 / cell(row, "k");
        expectClose(model.jumpInApproach(compliance), cell(row, "in_xb_m"), test::kLawTolerance);
        const double approach = cell(row, "in_xb_m");
        const ContactState landed =
            model.equilibrium(approach * (1.0 - 1e-15), compliance, {ContactBranch::Far});
        EXPECT_TRUE(landed.jumped);
        EXPECT_EQ(landed.contactRadius > 0.0, table.text(row, "land_kind") == "contact");
        expectClose(landed.force, cell(row, "land_P_N"), test::kLawTolerance);
        expectClose(landed.indentation, cell(row, "land_delta_m"), test::kLawTolerance,
                    maugisUnits(model.pair()).indentation);
        expectClose(landed.contactRadius, cell(row, "land_a_m"), test::kLawTolerance);
    }
}

/// The jump of a rigid sphere near a plane, F' = k: Derjaguin's force H R / (6 D^2) is what the
/// exact attraction becomes for large spheres.
TEST_F(MaugisOnALeverCritical, KnowsTheRigidJumpToContact) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactPair pair = paperPair(table.text(row, "material"));
        const double compliance = 1.0 / cell(row, "k");
        const double hamaker = hamakerConstant(pair.workOfAdhesion);
        const double distance = cell(row, "vdw_Dj_m");
        const double large = 1e6 * distance;  // so that D / R is rounding beside Derjaguin's limit
        const VanDerWaals attraction(hamaker * pair.tipRadius / large, large);
        expectClose(attraction.force(distance), cell(row, "vdw_Fj_N"), 2e-6);
        expectClose(attraction.gradient(distance) * compliance, 1.0, 3e-6);
        const double derjaguin = -hamaker * pair.tipRadius / (6.0 * distance * distance);
        expectClose(derjaguin, cell(row, "vdw_Fj_N"), test::kLawTolerance);
        expectClose(std::cbrt(hamaker * pair.tipRadius * compliance / 3.0), distance,
                    test::kLawTolerance);
        expectClose(distance - (compliance * derjaguin), cell(row, "vdw_base_m"),
                    test::kLawTolerance);
    }
}

}  // namespace
}  // namespace asperity
