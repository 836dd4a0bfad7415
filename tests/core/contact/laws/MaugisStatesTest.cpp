#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/contact/laws/ExpectedState.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace asperity {
namespace {

using test::expectClose;
using test::kLawTolerance;
using test::ReferenceTable;
using test::stiffnessOf;

constexpr double kRoundings = 4.0 * std::numeric_limits<double>::epsilon();

/// The state of a row by its radius, stable or not.
MaugisPoint pointAt(const MaugisDugdale& law, double contactRadius, double cohesiveRadius) {
    return contactRadius > 0.0 ? law.atContactRadius(contactRadius)
                               : law.curve().noncontact(cohesiveRadius);
}

/// c / a; infinite without contact.
double ratioOf(const MaugisPoint& point) { return 1.0 / std::cos(point.angle); }

/// Near first touch the angle is a right one but for the coordinate, which gives the ratio.
void expectRatio(const MaugisPoint& point, double expected) {
    if (std::isinf(expected)) {
        EXPECT_EQ(point.contactRadius, 0.0);
        return;
    }
    expectClose(point.cohesiveRadius / point.contactRadius, expected, kLawTolerance);
    if (expected < 10.0) {
        expectClose(ratioOf(point), expected, kLawTolerance);
    }
}

/// What four roundings of the contact radius do to the stiffness.
double stiffnessCondition(const MaugisDugdale& law, double contactRadius, double cohesiveRadius) {
    const MaugisPoint low =
        pointAt(law, contactRadius * (1.0 - kRoundings), cohesiveRadius * (1.0 - kRoundings));
    const MaugisPoint high =
        pointAt(law, contactRadius * (1.0 + kRoundings), cohesiveRadius * (1.0 + kRoundings));
    return std::abs(stiffnessOf(high) - stiffnessOf(low));
}

TEST(MaugisStates, HaveTheReferenceRatioOfRadii) {
    const ReferenceTable table = test::referenceTable("T01_md_curve.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        expectRatio(pointAt(law, table.number(row, "a_bar"), table.number(row, "c_bar")),
                    table.number(row, "m"));
    }
}

TEST(MaugisStates, HaveTheReferenceStiffnessToItsCondition) {
    const ReferenceTable table = test::referenceTable("T01_md_curve.csv");
    int compared = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double expected = table.number(row, "dPdd");
        if (!std::isfinite(expected) || std::abs(expected) < 1e-20 || std::abs(expected) > 1e20) {
            continue;  // on a fold
        }
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const double a = table.number(row, "a_bar");
        const double c = table.number(row, "c_bar");
        EXPECT_NEAR(stiffnessOf(pointAt(law, a, c)), expected,
                    std::max(kLawTolerance * std::abs(expected), stiffnessCondition(law, a, c)));
        ++compared;
    }
    EXPECT_GT(compared, 700);
}

/// Between the folds a state is stable under displacement control and not under load.
TEST(MaugisStates, AreStableWhereTheReferenceIs) {
    const ReferenceTable table = test::referenceTable("T01_md_curve.csv");
    int checked = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.number(row, "c_bar") == 0.0) {
            continue;  // free bodies, stable beside the curve
        }
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const MaugisPoint point =
            pointAt(law, table.number(row, "a_bar"), table.number(row, "c_bar"));
        const double indentationSize = point.cohesiveRadius + law.curve().lambda();
        if (std::abs(point.indentationRate) > 1e-9 * indentationSize * point.cohesiveRadius) {
            EXPECT_EQ(point.indentationRate > 0.0, table.number(row, "stable_disp") == 1.0);
            ++checked;
        }
        const double forceSize = law.curve().lambda() * point.cohesiveRadius;
        if (std::abs(point.forceRate) > 1e-9 * forceSize * point.cohesiveRadius) {
            EXPECT_EQ(point.forceRate > 0.0, table.number(row, "stable_load") == 1.0);
            ++checked;
        }
    }
    EXPECT_GT(checked, 1500);
}

/// The angle of every state under load or at an indentation, unstable ones and free ones too.
void expectAngles(const ReferenceTable& table) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "kind") == "free") {
            continue;
        }
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const MaugisPoint point =
            pointAt(law, table.number(row, "a_bar"), table.number(row, "c_bar"));
        expectClose(point.angle, table.number(row, "phi"), kLawTolerance);
        expectClose(point.cohesiveRadius, table.number(row, "c_bar"), kLawTolerance);
        const double unit = std::max(1.0, law.curve().range());
        expectClose(point.force, table.number(row, "P_bar"), kLawTolerance, 1.0);
        expectClose(point.indentation, table.number(row, "delta_bar"), kLawTolerance, unit);
    }
}

TEST(MaugisStates, UnderAnyLoadLieOnTheCurve) {
    expectAngles(test::referenceTable("T03_md_by_load.csv"));
}

TEST(MaugisStates, AtAnyIndentationLieOnTheCurve) {
    expectAngles(test::referenceTable("T04_md_by_delta.csv"));
}

/// Free bodies: their gap is beyond the range, and nothing is there to be found at them.
TEST(MaugisStates, AreFreeBeyondTheRangeOfTheStress) {
    const ReferenceTable table = test::referenceTable("T04_md_by_delta.csv");
    int found = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "kind") != "free") {
            continue;
        }
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const double indentation = table.number(row, "delta_bar");
        EXPECT_EQ(table.number(row, "P_bar"), 0.0);
        EXPECT_LE(indentation, -law.curve().range() * (1.0 - 1e-14));
        ++found;
    }
    EXPECT_EQ(found, 156);
}

class MaugisCriticalStates : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(table.rows(), 16U); }

    [[nodiscard]] double cell(std::size_t row, const char* column) const {
        return table.number(row, column);
    }
    [[nodiscard]] MaugisDugdale law(std::size_t row) const {
        return MaugisDugdale(cell(row, "lambda"));
    }

    const ReferenceTable table = test::referenceTable("T02_md_critical.csv");
};

TEST_F(MaugisCriticalStates, HaveTheReferenceFirstTouch) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisPoint touch = law(row).curve().contact(0.0);
        expectClose(touch.cohesiveRadius, cell(row, "cc"), kLawTolerance);
        expectClose(touch.force, cell(row, "touch_P"), kLawTolerance);
        expectClose(touch.indentation, cell(row, "touch_d"), kLawTolerance, 1.0);
        expectClose(law(row).curve().range(), -cell(row, "in_d"), kLawTolerance);
    }
}

TEST_F(MaugisCriticalStates, HaveTheReferenceAnglesAtTheirFolds) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisPoint pullOff = law(row).fold(MaugisControl::load());
        expectClose(pullOff.angle, cell(row, "po_phi"), 1e-11);
        expectClose(pullOff.cohesiveRadius / pullOff.contactRadius, cell(row, "po_m"), 1e-11);
        const MaugisPoint jumpOff = law(row).fold(MaugisControl::displacement());
        expectClose(jumpOff.angle, cell(row, "do_phi"), 1e-11);
        if (std::isinf(cell(row, "do_m"))) {
            EXPECT_EQ(jumpOff.contactRadius, 0.0);
        } else {
            expectClose(jumpOff.cohesiveRadius / jumpOff.contactRadius, cell(row, "do_m"), 1e-11);
        }
    }
}

TEST_F(MaugisCriticalStates, BalanceWithoutLoadAsInTheReference) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto free = law(row).stable(MaugisControl::load(), 0.0);
        ASSERT_TRUE(free);
        expectClose(free->contactRadius, cell(row, "z_a"), kLawTolerance);
        expectClose(free->cohesiveRadius, cell(row, "z_c"), kLawTolerance);
        expectClose(free->indentation, cell(row, "z_d"), kLawTolerance);
        expectClose(stiffnessOf(*free), cell(row, "z_k"), kLawTolerance);
    }
}

TEST_F(MaugisCriticalStates, PullWhereTheUndeformedBodiesTouchAsInTheReference) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto level = law(row).stable(MaugisControl::displacement(), 0.0);
        ASSERT_TRUE(level);
        expectClose(level->force, cell(row, "d0_P"), kLawTolerance);
        expectClose(level->contactRadius, cell(row, "d0_a"), kLawTolerance);
        EXPECT_EQ(level->contactRadius > 0.0, table.text(row, "d0_kind") == "contact");
    }
}

/// Both jumps together lose the area of the hysteresis loop.
TEST_F(MaugisCriticalStates, LoseTheReferenceLoop) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisDugdale maugis = law(row);
        const auto displacement = MaugisControl::displacement();
        const auto landing = maugis.stable(displacement, -maugis.curve().range());
        ASSERT_TRUE(landing);
        const double lost =
            maugis.curve().energy(maugis.fold(displacement)) - maugis.curve().energy(*landing);
        expectClose(lost, cell(row, "E_loop"), kLawTolerance + (1e-15 * maugis.curve().lambda()));
    }
}

}  // namespace
}  // namespace asperity
