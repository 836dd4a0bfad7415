#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::test {

inline constexpr double kLawTolerance = 1e-12;
inline constexpr double kFoldTolerance = 1e-7;
inline constexpr double kLeverFoldTolerance = 1e-9;  ///< of a state at a fold on a lever

/// Where a stable bonded state is asked for.
struct BondedPosition {
    double approach = 0.0;    ///< of the undeflected tip [m]
    double compliance = 0.0;  ///< of the lever [m/N]
};

/// What four roundings of the approach do to the stable bonded state there: the condition number
/// of a reference row times 4 eps, in SI units; and what is allowed beside that.
struct RowCondition {
    double force = 0.0;
    double indentation = 0.0;
    double contactRadius = 0.0;
    double cohesiveRadius = 0.0;
    double tolerance = kLawTolerance;  ///< relative
};

/// @param range of the cohesive stress [m]; 0: none
inline RowCondition rowCondition(const ContactModel& model, const BondedPosition& position,
                                 double range) {
    constexpr double kRoundings = 4.0 * std::numeric_limits<double>::epsilon();
    const double unit = std::max(maugisUnits(model.pair()).indentation, range);
    const double nudge = kRoundings * std::max(std::abs(position.approach), unit);
    const auto stateAt = [&](double approach) {
        const ContactState state =
            model.equilibrium(approach, position.compliance, {ContactBranch::Bonded});
        return state.branch == ContactBranch::Bonded ? state
                                                     : model.lastBonded(position.compliance);
    };
    const ContactState low = stateAt(position.approach - nudge);
    const ContactState high = stateAt(position.approach + nudge);
    const double end = model.pullOffApproach(position.compliance);
    const bool atFold = position.approach - end <= 1.1e-6 * std::abs(end);
    return {.force = std::abs(high.force - low.force),
            .indentation = std::abs(high.indentation - low.indentation),
            .contactRadius = std::abs(high.contactRadius - low.contactRadius),
            .cohesiveRadius = std::abs(high.cohesiveRadius - low.cohesiveRadius),
            .tolerance = atFold ? kFoldTolerance : kLawTolerance};
}

/// Force and indentation relative to their sizes or Maugis units, radii to their sizes.
inline void expectState(const ContactState& state, const ContactState& expected,
                        const RowCondition& condition, const MaugisUnits& units) {
    const auto expectNear = [&](double actual, double wanted, double unit, double rounding) {
        const double size = std::max(std::abs(wanted), unit);
        EXPECT_NEAR(actual, wanted, std::max(condition.tolerance * size, rounding));
    };
    EXPECT_TRUE(state.solved());
    expectNear(state.force, expected.force, units.force, condition.force);
    expectNear(state.indentation, expected.indentation, units.indentation, condition.indentation);
    expectNear(state.contactRadius, expected.contactRadius, 0.0, condition.contactRadius);
    expectNear(state.cohesiveRadius, expected.cohesiveRadius, 0.0, condition.cohesiveRadius);
}

}  // namespace asperity::test
