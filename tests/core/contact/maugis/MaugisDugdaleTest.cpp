#include "core/contact/maugis/MaugisDugdale.h"

#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace asperity {

/// Lets RapidCheck print a counter-example.
void showValue(const MaugisControl& control, std::ostream& stream) {
    stream << control.perIndentation << " indentation + " << control.perForce << " force";
}

namespace {

using test::expectClose;
using test::kEpsilon;
using test::kInfinity;
using test::kNan;
using test::ReferenceTable;

/// What four roundings of the held value do to the state: the row's condition number in units.
struct Sensitivity {
    double contactRadius = 0.0;
    double cohesiveRadius = 0.0;
    double other = 0.0;
    bool atFold = false;
};

Sensitivity sensitivityAt(const MaugisDugdale& law, const MaugisControl& control, double value) {
    const double unit = control.perIndentation > 0.0 ? std::max(1.0, law.curve().range()) : 1.0;
    const double nudge = 4.0 * kEpsilon * std::max(std::abs(value), unit);
    const MaugisPoint fold = law.fold(control);
    const MaugisPoint low = law.stable(control, value - nudge).value_or(fold);
    const MaugisPoint high = law.stable(control, value + nudge).value_or(fold);
    const MaugisControl other{control.perForce, control.perIndentation};
    return {.contactRadius = high.contactRadius - low.contactRadius,
            .cohesiveRadius = std::abs(high.cohesiveRadius - low.cohesiveRadius),
            .other = std::abs(other.held(high) - other.held(low)),
            .atFold = value - control.held(fold) < 1e-6 * std::abs(value)};
}

void expectState(const MaugisDugdale& law, const MaugisControl& control, double value,
                 const MaugisPoint& expected) {
    const auto state = law.stable(control, value);
    const Sensitivity limit = sensitivityAt(law, control, value);
    if (!state) {
        EXPECT_TRUE(limit.atFold) << "no stable state";
        return;
    }
    const double tolerance = limit.atFold ? 1e-7 : 1e-12;
    const MaugisControl other{control.perForce, control.perIndentation};
    EXPECT_NEAR(state->contactRadius, expected.contactRadius,
                std::max(tolerance * expected.contactRadius, limit.contactRadius));
    EXPECT_NEAR(state->cohesiveRadius, expected.cohesiveRadius,
                std::max(tolerance * expected.cohesiveRadius, limit.cohesiveRadius));
    EXPECT_NEAR(other.held(*state), other.held(expected),
                std::max(tolerance * std::max(1.0, std::abs(other.held(expected))), limit.other));
}

MaugisPoint pointOf(double a, double c, double force, double indentation) {
    MaugisPoint point;
    point.contactRadius = a;
    point.cohesiveRadius = c;
    point.force = force;
    point.indentation = indentation;
    return point;
}

TEST(MaugisDugdale, FoldsWhereTheReferenceDoes) {
    const ReferenceTable table = test::referenceTable("T02_md_critical.csv");
    ASSERT_EQ(table.rows(), 16U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const MaugisPoint pullOff = law.fold(MaugisControl::load());
        expectClose(pullOff.force, table.number(row, "po_P"), 1e-13);
        expectClose(pullOff.indentation, table.number(row, "po_d"), 1e-12, 1.0);
        expectClose(pullOff.contactRadius, table.number(row, "po_a"), 1e-12);
        expectClose(pullOff.cohesiveRadius, table.number(row, "po_c"), 1e-12);
        const MaugisPoint jumpOff = law.fold(MaugisControl::displacement());
        expectClose(jumpOff.force, table.number(row, "do_P"), 1e-12);
        expectClose(jumpOff.indentation, table.number(row, "do_d"), 1e-13);
        expectClose(jumpOff.contactRadius, table.number(row, "do_a"), 1e-12);
        expectClose(jumpOff.cohesiveRadius, table.number(row, "do_c"), 1e-12);
        EXPECT_EQ(jumpOff.contactRadius > 0.0, table.text(row, "do_kind") == "contact");
        expectClose(law.curve().touchRadius(), table.number(row, "cc"), 1e-13);
    }
}

TEST(MaugisDugdale, LandsWhereTheReferenceDoesAfterJumpIn) {
    const ReferenceTable table = test::referenceTable("T02_md_critical.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const MaugisDugdale law(table.number(row, "lambda"));
        const auto landing = law.stable(MaugisControl::displacement(), -law.curve().range());
        ASSERT_TRUE(landing);
        expectClose(landing->force, table.number(row, "land_P"), 1e-12);
        expectClose(landing->contactRadius, table.number(row, "land_a"), 1e-12);
        expectClose(landing->cohesiveRadius, table.number(row, "land_c"), 1e-12);
        EXPECT_EQ(landing->contactRadius > 0.0, table.text(row, "land_kind") == "contact");
    }
}

TEST(MaugisDugdale, FindsTheStableStateAtGivenLoad) {
    const ReferenceTable table = test::referenceTable("T03_md_by_load.csv");
    ASSERT_EQ(table.rows(), 688U);
    int stable = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "stability") != "stable") {
            continue;
        }
        SCOPED_TRACE(row);
        const double force = table.number(row, "P_bar");
        const MaugisDugdale law(table.number(row, "lambda"));
        expectState(law, MaugisControl::load(), force,
                    pointOf(table.number(row, "a_bar"), table.number(row, "c_bar"), force,
                            table.number(row, "delta_bar")));
        ++stable;
    }
    EXPECT_GT(stable, 400);
}

TEST(MaugisDugdale, FindsTheStableStateAtGivenIndentation) {
    const ReferenceTable table = test::referenceTable("T04_md_by_delta.csv");
    ASSERT_EQ(table.rows(), 738U);
    int stable = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "stability") != "stable" || table.text(row, "kind") == "free") {
            continue;
        }
        SCOPED_TRACE(row);
        const double indentation = table.number(row, "delta_bar");
        const MaugisDugdale law(table.number(row, "lambda"));
        expectState(law, MaugisControl::displacement(), indentation,
                    pointOf(table.number(row, "a_bar"), table.number(row, "c_bar"),
                            table.number(row, "P_bar"), indentation));
        ++stable;
    }
    EXPECT_GT(stable, 400);
}

/// Unstable states lie on the same curve, beyond the fold.
TEST(MaugisDugdale, PutsUnstableStatesOnTheCurveBeyondTheFold) {
    const ReferenceTable table = test::referenceTable("T03_md_by_load.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "stability") != "unstable") {
            continue;
        }
        SCOPED_TRACE(row);
        const double a = table.number(row, "a_bar");
        const MaugisDugdale law(table.number(row, "lambda"));
        const MaugisPoint point =
            a > 0.0 ? law.atContactRadius(a) : law.curve().noncontact(table.number(row, "c_bar"));
        expectClose(point.force, table.number(row, "P_bar"), 1e-12, 1.0);
        expectClose(point.indentation, table.number(row, "delta_bar"), 1e-12,
                    std::max(1.0, law.curve().range()));
        EXPECT_LT(a, law.fold(MaugisControl::load()).contactRadius);
    }
}

TEST(MaugisDugdale, FindsNothingBelowTheFold) {
    test::checkProperty([] {
        const MaugisDugdale law(*test::logUniform(1e-6, 1e6));
        const auto control = MaugisControl::spring(*test::logUniform(1e-6, 1e6));
        const double value = control.held(law.fold(control));
        const double step = 1e-9 * (std::abs(value) + law.curve().range());
        RC_ASSERT(!law.stable(control, value - step));
        RC_ASSERT(law.stable(control, value + step));
    });
}

/// Any double, most of them of no use as a coordinate.
rc::Gen<double> anyStart() {
    return rc::gen::oneOf(test::logUniform(1e-150, 1e150), test::logUniform(1e-3, 1e3),
                          rc::gen::element(0.0, -1.0, kNan, kInfinity, -kInfinity, 1e-308, 1e308));
}

rc::Gen<MaugisControl> anyControl() {
    return rc::gen::oneOf(rc::gen::element(MaugisControl::load(), MaugisControl::displacement()),
                          rc::gen::map(test::logUniform(1e-6, 1e6),
                                       [](double c) { return MaugisControl::spring(c); }));
}

/// Whether it is the one stable state: the held value rises along the whole stable branch, so that
/// a state on it which has the value to rounding is that one.
bool isTheStableState(const MaugisDugdale& law, const MaugisControl& control, double value,
                      const MaugisPoint& state) {
    const double square = state.contactRadius * state.contactRadius;
    const double cube = square * state.contactRadius;
    const double gap = state.contactRadius > 0.0 ? 0.0 : law.curve().range();
    const double size =
        (control.perIndentation * (square + gap + std::abs(square - state.indentation))) +
        (control.perForce * (cube + std::abs(cube - state.force)));
    return std::abs(control.held(state) - value) <= 16.0 * kEpsilon * size &&
           state.coordinate >= law.fold(control).coordinate;
}

TEST(MaugisDugdale, FindsTheSameStateFromAnyStart) {
    test::checkProperty([] {
        const MaugisDugdale law(*test::logUniform(1e-4, 1e4));
        const MaugisControl control = *anyControl();
        const double above = *test::logUniform(1e-12, 1e4) - 1e-6;
        const double value = control.held(law.fold(control)) + above;
        const double start = *anyStart();
        const auto cold = law.stable(control, value);
        const auto warm = law.stable(control, value, start);
        RC_ASSERT(cold.has_value() == warm.has_value());
        if (warm) {
            RC_ASSERT(isTheStableState(law, control, value, *warm));
        }
    });
}

TEST(MaugisDugdale, FollowsASlowMotionToTheSameStates) {
    test::checkProperty([] {
        const MaugisDugdale law(*test::logUniform(1e-3, 1e3));
        const MaugisControl control = *anyControl();
        const double end = control.held(law.fold(control));
        const double step = *test::logUniform(1e-6, 1.0);
        MaugisPoint last;
        for (int i = 50; i > -2; --i) {
            const double value = end + (step * i);
            const auto cold = law.stable(control, value);
            const auto warm = law.stable(control, value, last);
            RC_ASSERT(cold.has_value() == warm.has_value());
            if (warm) {
                RC_ASSERT(isTheStableState(law, control, value, *warm));
            }
            last = warm.value_or(last);
        }
    });
}

/// As where the surface curves under a moving tip.
TEST(MaugisDugdale, StartsFromAStateOfAnotherTransitionParameter) {
    test::checkProperty([] {
        const double lambda = *test::logUniform(1e-3, 1e3);
        const MaugisDugdale before(lambda);
        const MaugisDugdale law(lambda * *test::logUniform(0.1, 10.0));
        const MaugisControl control = *anyControl();
        const double value = control.held(before.fold(control)) + *test::logUniform(1e-6, 1e3);
        const auto last = before.stable(control, value);
        const double moved = value + *test::logUniform(1e-6, 1.0);
        const auto cold = law.stable(control, moved);
        const auto warm = law.stable(control, moved, *last);
        RC_ASSERT(cold.has_value() == warm.has_value());
        if (warm) {
            RC_ASSERT(isTheStableState(law, control, moved, *warm));
        }
    });
}

/// From the fold in load control to the one in displacement control the stiffness only falls, so
/// that a spring of any compliance meets exactly one fold.
TEST(MaugisDugdale, LosesStiffnessMonotonicallyBetweenItsFolds) {
    test::checkProperty([] {
        const MaugisDugdale law(*test::logUniform(1e-13, 1e7));
        const double loadFold = law.fold(MaugisControl::load()).coordinate;
        const double jumpOff = law.fold(MaugisControl::displacement()).coordinate;
        const double low = *test::fraction();
        const double high = low + ((1.0 - low) * *test::fraction());
        const MaugisPoint stiff = law.curve().contact(jumpOff + (high * (loadFold - jumpOff)));
        const MaugisPoint soft = law.curve().contact(jumpOff + (low * (loadFold - jumpOff)));
        const double rounding =
            1e-12 * std::abs(stiff.indentationRate) * (1.0 + std::abs(soft.forceRate));
        RC_ASSERT(stiff.forceRate * soft.indentationRate >=
                  (soft.forceRate * stiff.indentationRate) - rounding);
    });
}

/// Canonical Maugis-Dugdale on a spring, in SI units.
class SpringReference {
public:
    SpringReference(const ContactPair& pair, double cohesiveRange)
        : units(maugisUnits(pair))
        , law(transitionParameter(units, pair.workOfAdhesion / cohesiveRange)) {}

    [[nodiscard]] MaugisControl spring(double stiffness) const {
        return MaugisControl::spring(units.force / (stiffness * units.indentation));
    }

    MaugisUnits units;
    MaugisDugdale law;
};

double canonicalRange() { return 0.165e-9 * (std::sqrt(10.0) - 1.0); }

TEST(MaugisDugdale, BalancesASpringLikeTheReference) {
    const ReferenceTable table = test::referenceTable("T14_quasistatic_curve.csv");
    ASSERT_EQ(table.rows(), 81U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const SpringReference tip(test::paperPair(table.text(row, "material")), canonicalRange());
        const auto control = tip.spring(table.number(row, "k"));
        const double value = table.number(row, "x_base_m") / tip.units.indentation;
        expectState(tip.law, control, value,
                    pointOf(table.number(row, "a_m") / tip.units.radius,
                            table.number(row, "c_m") / tip.units.radius,
                            table.number(row, "P_N") / tip.units.force,
                            table.number(row, "delta_m") / tip.units.indentation));
    }
}

TEST(MaugisDugdale, PullsOffASpringLikeTheReference) {
    const ReferenceTable table = test::referenceTable("T14c_quasistatic_critical.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const SpringReference tip(test::paperPair(table.text(row, "material")), canonicalRange());
        const auto control = tip.spring(table.number(row, "k"));
        const MaugisPoint fold = tip.law.fold(control);
        expectClose(tip.law.curve().lambda(), table.number(row, "lambda"), 1e-13);
        expectClose(control.held(fold) * tip.units.indentation, table.number(row, "off_xb_m"),
                    1e-12);
        expectClose(fold.force * tip.units.force, table.number(row, "off_P_N"), 1e-12);
        expectClose(fold.contactRadius * tip.units.radius, table.number(row, "off_a_m"), 1e-10);
        const double jumpIn = -tip.law.curve().range();
        const auto landing = tip.law.stable(control, jumpIn);
        ASSERT_TRUE(landing);
        expectClose(jumpIn * tip.units.indentation, table.number(row, "in_xb_m"), 1e-13);
        expectClose(landing->force * tip.units.force, table.number(row, "land_P_N"), 1e-12);
        expectClose(landing->contactRadius * tip.units.radius, table.number(row, "land_a_m"),
                    1e-11);
    }
}

TEST(MaugisDugdale, HoldsOverExtremeMaterials) {
    const ReferenceTable table = test::referenceTable("T12_extremes.csv");
    ASSERT_EQ(table.rows(), 1120U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double work = table.number(row, "w");
        if (work == 0.0) {
            continue;
        }
        SCOPED_TRACE(row);
        const ContactPair pair{table.number(row, "R_m"), table.number(row, "Es_Pa"), work};
        const MaugisUnits units = maugisUnits(pair);
        const MaugisDugdale law(transitionParameter(units, table.number(row, "s0_Pa")));
        expectClose(law.curve().lambda(), table.number(row, "lambda"), 1e-13);
        const double indentation = table.number(row, "delta_m") / units.indentation;
        expectState(law, MaugisControl::displacement(), indentation,
                    pointOf(table.number(row, "a_m") / units.radius,
                            table.number(row, "c_m") / units.radius,
                            table.number(row, "P_N") / units.force, indentation));
    }
}

}  // namespace
}  // namespace asperity
