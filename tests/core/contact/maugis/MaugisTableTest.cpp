#include "core/contact/maugis/MaugisTable.h"

#include "core/Error.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

using test::stiffnessOf;

constexpr double kMax = 100.0;
constexpr double kRadiusSpan = 2.15;  // of lambda for a tenth to ten times the effective radius
constexpr double kBound = 2e-9;

/// Transition parameters of the paper's materials: SiO2, polystyrene, silicone rubber.
const std::vector<double>& paperLambdas() {
    static const std::vector<double> lambdas{0.1879, 0.7199, 50.5};
    return lambdas;
}

/// One table around each of them.
const std::vector<MaugisTable>& paperTables() {
    static const std::vector<MaugisTable> tables = [] {
        std::vector<MaugisTable> built;
        for (const double lambda : paperLambdas()) {
            built.emplace_back(MaugisTableRange{lambda / kRadiusSpan, lambda * kRadiusSpan, kMax});
        }
        return built;
    }();
    return tables;
}

double scaledError(double value, double exact) {
    return std::abs(value - exact) / std::max(std::abs(exact), 1.0);
}

double worstError(const MaugisState& state, const MaugisPoint& exact) {
    return std::max({scaledError(state.force, exact.force),
                     scaledError(state.indentation, exact.indentation),
                     scaledError(state.contactRadius, exact.contactRadius),
                     scaledError(state.cohesiveRadius, exact.cohesiveRadius)});
}

TEST(MaugisTable, IsAsAccurateAsWantedForThePapersMaterials) {
    for (std::size_t i = 0; i < paperLambdas().size(); ++i) {
        SCOPED_TRACE(paperLambdas()[i]);
        const MaugisTable& table = paperTables()[i];
        EXPECT_GT(table.errorBound(), 0.0);
        EXPECT_LE(table.errorBound(), kBound);
        EXPECT_LT(table.exactShare(), 0.1);
        EXPECT_LT(table.bytes(), 16'000'000U);
        const MaugisTable flat({paperLambdas()[i], paperLambdas()[i], kMax});
        EXPECT_LE(flat.errorBound(), kBound);
        EXPECT_EQ(flat.exactShare(), 0.0);
    }
}

/// An indentation of stable contact, as often close to the lowest as far from it.
double anyIndentation(const MaugisDugdale& law) {
    const double root = *test::logUniform(1e-7, std::sqrt(kMax));
    return law.lowestContact().indentation + (root * root);
}

/// What four roundings of the indentation do to the exact state: close to a fold that is more than
/// the bound.
double conditionAt(const MaugisDugdale& law, double indentation) {
    const double nudge =
        4.0 * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(indentation));
    const auto control = MaugisControl::displacement();
    const MaugisPoint low = law.stable(control, indentation - nudge).value_or(law.lowestContact());
    const MaugisPoint high = *law.stable(control, indentation + nudge);
    return std::max({scaledError(high.force, low.force),
                     scaledError(high.contactRadius, low.contactRadius),
                     scaledError(high.cohesiveRadius, low.cohesiveRadius),
                     scaledError(stiffnessOf(high), stiffnessOf(low))});
}

TEST(MaugisTable, IsNeverOffByMoreThanItsBound) {
    test::checkProperty([] {
        const auto i = *rc::gen::inRange<std::size_t>(0, paperLambdas().size());
        const MaugisTable& table = paperTables()[i];
        const MaugisDugdale law(paperLambdas()[i] *
                                *test::logUniform(1.0 / kRadiusSpan, kRadiusSpan));
        const double indentation = anyIndentation(law);
        const auto state = table.at(law, indentation);
        const auto exact = law.stable(MaugisControl::displacement(), indentation);
        const double limit = std::max(table.errorBound(), conditionAt(law, indentation));
        RC_ASSERT(state.has_value());
        RC_ASSERT(worstError(*state, *exact) <= limit);
        RC_ASSERT(scaledError(state->stiffness, stiffnessOf(*exact)) <= limit);
    });
}

TEST(MaugisTable, BalancesASpringWithinItsBound) {
    test::checkProperty([] {
        const auto i = *rc::gen::inRange<std::size_t>(0, paperLambdas().size());
        const MaugisTable& table = paperTables()[i];
        const MaugisDugdale law(paperLambdas()[i] *
                                *test::logUniform(1.0 / kRadiusSpan, kRadiusSpan));
        const double compliance = *test::logUniform(1e-3, 1e3);
        const auto control = MaugisControl::spring(compliance);
        const double value = control.held(law.fold(control)) + *test::logUniform(1e-4, kMax) - 1e-3;
        const auto exact = law.stable(control, value);
        const double start = *rc::gen::oneOf(
            rc::gen::just(exact ? exact->indentation + 0.1 : 0.0), rc::gen::just(-1e9),
            rc::gen::just(1e9), rc::gen::just(std::numeric_limits<double>::quiet_NaN()),
            test::logUniform(1e-3, 1e3));
        const auto state = table.stable(law, compliance, value, start);
        RC_ASSERT(state.has_value() == exact.has_value());
        RC_ASSERT(!exact || worstError(*state, *exact) <= table.errorBound());
    });
}

TEST(MaugisTable, EqualsTheReferenceOnASpring) {
    const test::ReferenceTable reference = test::referenceTable("T14_quasistatic_curve.csv");
    for (std::size_t row = 0; row < reference.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactPair pair = test::paperPair(reference.text(row, "material"));
        const MaugisUnits units = maugisUnits(pair);
        const double range = 0.165e-9 * (std::sqrt(10.0) - 1.0);
        const MaugisDugdale law(transitionParameter(units, pair.workOfAdhesion / range));
        const double lambda = law.curve().lambda();
        const MaugisTable table({lambda, lambda, kMax});
        const double compliance = units.force / (reference.number(row, "k") * units.indentation);
        const auto state = table.stable(law, compliance,
                                        reference.number(row, "x_base_m") / units.indentation, 1.0);
        ASSERT_TRUE(state);
        const double nearFold = 1e-7;
        test::expectClose(state->force, reference.number(row, "P_N") / units.force, nearFold, 1.0);
    }
}

/// Any transition parameter can be tabulated; what is not accurate enough is left to the law.
TEST(MaugisTable, KeepsItsBoundForAnyTransitionParameter) {
    for (const double lambda : {1e-3, 0.03, 0.9, 0.9379474, 0.938, 3.0, 1e3}) {
        SCOPED_TRACE(lambda);
        const MaugisTable table({lambda, 1.5 * lambda, kMax});
        EXPECT_LE(table.errorBound(), kBound);
        for (int i = 0; i < 16; ++i) {
            const MaugisDugdale law(lambda * (1.0 + (0.0317 * i)));
            for (int j = 0; j < 30; ++j) {
                const double root = 1e-3 * std::pow(1.37, j);
                const double indentation = law.lowestContact().indentation + (root * root);
                const auto exact = law.stable(MaugisControl::displacement(), indentation);
                EXPECT_LE(worstError(*table.at(law, indentation), *exact), table.errorBound());
            }
        }
    }
}

TEST(MaugisTable, LeavesFoldsAndWhatLiesOutsideToTheExactLaw) {
    for (const double lambda : paperLambdas()) {
        SCOPED_TRACE(lambda);
        const MaugisTable table({lambda, lambda, kMax});
        const MaugisDugdale law(lambda);
        const MaugisPoint fold = law.fold(MaugisControl::displacement());
        EXPECT_NEAR(table.at(law, fold.indentation)->force, fold.force, 1e-7);
        EXPECT_FALSE(table.at(law, fold.indentation - 1e-9));
        EXPECT_FALSE(table.stable(law, 0.5, fold.indentation - 10.0, fold.indentation));
        const double deep = 10.0 * kMax;
        const auto exact = law.stable(MaugisControl::displacement(), deep);
        EXPECT_EQ(table.at(law, deep)->force, exact->force);
        const MaugisDugdale other(1.1 * lambda);
        const auto elsewhere = other.stable(MaugisControl::displacement(), 1.0);
        EXPECT_EQ(table.at(other, 1.0)->force, elsewhere->force);
    }
}

TEST(MaugisTable, GivesStatesWithoutContactToo) {
    const double lambda = 0.1879;
    const MaugisTable table({lambda, lambda, kMax});
    const MaugisDugdale law(lambda);
    const double indentation = -law.curve().range();
    const auto state = table.at(law, indentation);
    const auto exact = law.stable(MaugisControl::displacement(), indentation);
    EXPECT_EQ(state->contactRadius, 0.0);
    EXPECT_EQ(state->cohesiveRadius, exact->cohesiveRadius);
    EXPECT_EQ(state->force, exact->force);
}

TEST(MaugisTable, AllocatesNothingInUse) {
    const MaugisTable& table = paperTables()[1];
    const std::size_t before = test::allocationCount();
    double indentation = 5.0;
    for (int i = 0; i < 110; ++i) {
        const double lambda = 0.4 + (0.01 * i);
        const MaugisDugdale law(lambda);
        const auto held = table.stable(law, 0.5, 8.0 - (8.0 * lambda), indentation);
        const auto state = table.at(law, lambda);
        indentation = held && state ? held->indentation : 5.0;
    }
    EXPECT_EQ(test::allocationCount(), before);
}

TEST(MaugisTable, RefusesARangeItCannotCover) {
    const double nan = std::nan("");
    EXPECT_THROW(MaugisTable({0.0, 1.0, 1.0}), Error);
    EXPECT_THROW(MaugisTable({1.0, 0.5, 1.0}), Error);
    EXPECT_THROW(MaugisTable({1.0, 6.0, 1.0}), Error);
    EXPECT_THROW(MaugisTable({nan, 1.0, 1.0}), Error);
    EXPECT_THROW(MaugisTable({1.0, nan, 1.0}), Error);
    EXPECT_THROW(MaugisTable({1.0, 1.0, -1.0}), Error);
    EXPECT_THROW(MaugisTable({1.0, 1.0, 1e7}), Error);
    EXPECT_THROW(MaugisTable({1.0, 1.0, nan}), Error);
}

TEST(MaugisTable, OfARangeThatWasAskedForBeforeIsTheSame) {
    const MaugisTableRange range{1.0, 1.0, 2.0};
    const auto table = sharedMaugisTable(range);
    EXPECT_NE(sharedMaugisTable({1.0, 1.0, 3.0}), table);
    EXPECT_EQ(sharedMaugisTable(range), table);
    EXPECT_THROW((void)sharedMaugisTable({1.0, 0.5, 1.0}), Error);
}

}  // namespace
}  // namespace asperity
