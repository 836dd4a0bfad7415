#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/contact/laws/ExpectedState.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace asperity {
namespace {

using test::expectClose;
using test::kLawTolerance;
using test::ReferenceTable;

constexpr double kFoldStateTolerance = 1e-11;  // a state where its force or indentation is least

/// The pairs and cohesive stresses of T16 by "material tag".
class PaperModels {
public:
    PaperModels() {
        const ReferenceTable table = test::referenceTable("T16_parameters.csv");
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const auto number = [&](const char* column) { return table.number(row, column); };
            const ContactPair pair{number("R"), number("Es"), number("w")};
            models_.emplace(
                table.text(row, "material") + " " + table.text(row, "tag"),
                ContactModel(ContactLaw::Maugis, pair, {.cohesiveStress = number("s0")}));
        }
    }

    [[nodiscard]] const ContactModel& of(const ReferenceTable& table, std::size_t row) const {
        return models_.at(table.text(row, "material") + " " + table.text(row, "tag"));
    }

private:
    std::map<std::string, ContactModel> models_;
};

const PaperModels& paperModels() {
    static const PaperModels models;
    return models;
}

double rangeOf(const ContactModel& model) {
    return model.pair().workOfAdhesion / model.cohesiveStress();
}

std::string kindOf(const ContactState& state) {
    switch (state.region()) {
    case TipRegion::Contact:
        return "contact";
    case TipRegion::Cohesive:
        return "noncontact";
    default:
        return "free";
    }
}

/// On the way in as on the way out, each state from the memory of the one before.
TEST(MaugisForceCurve, FollowsTheReferenceThereAndBack) {
    const ReferenceTable table = test::referenceTable("T06_md_dimensional_curves.csv");
    ASSERT_EQ(table.rows(), 396U);
    ContactState state;
    int jumps = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel& model = paperModels().of(table, row);
        const bool starts = row == 0 || (table.text(row, "direction") == "approach" &&
                                         table.text(row - 1, "direction") == "retract");
        const double indentation = table.number(row, "delta_m");
        state = model.equilibrium(indentation, 0.0, starts ? ContactMemory{} : state.memory());
        EXPECT_EQ(kindOf(state), table.text(row, "kind"));
        const ContactState expected{.force = table.number(row, "P_N"),
                                    .indentation = indentation,
                                    .contactRadius = table.number(row, "a_m"),
                                    .cohesiveRadius = table.number(row, "c_m")};
        const auto condition = test::rowCondition(
            model, {indentation, 0.0}, expected.contactRadius > 0.0 ? 0.0 : rangeOf(model));
        test::expectState(state, expected, condition, maugisUnits(model.pair()));
        jumps += state.jumped ? 1 : 0;
    }
    EXPECT_EQ(jumps, 12);  // two for each of three materials and two cohesive stresses
}

class MaugisForceCurveCriticalStates : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(table.rows(), 6U); }

    [[nodiscard]] double cell(std::size_t row, const std::string& column) const {
        return table.number(row, column);
    }
    /// A state of the row by the beginning of its columns' names.
    [[nodiscard]] ContactState state(std::size_t row, const std::string& name) const {
        return {.force = cell(row, name + "_P_N"),
                .indentation = cell(row, name + "_delta_m"),
                .contactRadius = cell(row, name + "_a_m"),
                .cohesiveRadius = cell(row, name + "_c_m")};
    }

    const ReferenceTable table = test::referenceTable("T06c_md_dimensional_critical.csv");
};

void expectFold(const ContactState& actual, const ContactState& expected,
                const MaugisUnits& units) {
    test::expectState(actual, expected, {.tolerance = kFoldStateTolerance}, units);
}

TEST_F(MaugisForceCurveCriticalStates, SnapInAndLandAsInTheReference) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel& model = paperModels().of(table, row);
        expectClose(model.lambda(), cell(row, "lambda"), kLawTolerance);
        const double jumpIn = cell(row, "in_delta_m");
        expectClose(model.jumpInApproach(0.0), jumpIn, kLawTolerance);
        const ContactState landed = model.equilibrium(jumpIn, 0.0, {ContactBranch::Bonded});
        ContactState expected{.force = cell(row, "land_P_N"),
                              .indentation = jumpIn,
                              .contactRadius = cell(row, "land_a_m"),
                              .cohesiveRadius = cell(row, "land_c_m")};
        test::expectState(landed, expected,
                          test::rowCondition(model, {jumpIn, 0.0}, rangeOf(model)),
                          maugisUnits(model.pair()));
        EXPECT_EQ(kindOf(landed), table.text(row, "land_kind"));
    }
}

TEST_F(MaugisForceCurveCriticalStates, BalanceWithoutLoadAsInTheReference) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel& model = paperModels().of(table, row);
        const double indentation = cell(row, "z_delta_m");
        const ContactState free = model.equilibrium(indentation, 0.0, {ContactBranch::Bonded});
        const ContactState expected{.force = 0.0,
                                    .indentation = indentation,
                                    .contactRadius = cell(row, "z_a_m"),
                                    .cohesiveRadius = cell(row, "z_c_m")};
        test::expectState(free, expected, test::rowCondition(model, {indentation, 0.0}, 0.0),
                          maugisUnits(model.pair()));
        expectClose(free.stiffness, cell(row, "z_k_N_m"), kLawTolerance);
        expectClose(free.contactRadius / model.pair().tipRadius, cell(row, "z_aR"), kLawTolerance);
    }
}

TEST_F(MaugisForceCurveCriticalStates, JumpOffAsInTheReference) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel& model = paperModels().of(table, row);
        const ContactState jumpOff = model.lastBonded(0.0);
        expectFold(jumpOff, state(row, "do"), maugisUnits(model.pair()));
        EXPECT_EQ(kindOf(jumpOff), table.text(row, "do_kind"));
        expectClose(model.pullOffApproach(0.0), cell(row, "do_delta_m"), kLawTolerance);
    }
}

/// Under load; the softest lever allowed is a spring still beside the softest contact.
TEST_F(MaugisForceCurveCriticalStates, PullOffAsInTheReference) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel& model = paperModels().of(table, row);
        const MaugisUnits units = maugisUnits(model.pair());
        const MaugisPoint fold = MaugisDugdale(model.lambda()).fold(MaugisControl::load());
        const ContactState actual{.force = fold.force * units.force,
                                  .indentation = fold.indentation * units.indentation,
                                  .contactRadius = fold.contactRadius * units.radius,
                                  .cohesiveRadius = fold.cohesiveRadius * units.radius};
        expectFold(actual, state(row, "po"), units);
    }
}

}  // namespace
}  // namespace asperity
