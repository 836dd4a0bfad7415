#include "core/identify/cycle/AdhesiveFit.h"

#include "core/Error.h"
#include "core/identify/cycle/CycleResiduals.h"
#include "tests/core/identify/cycle/CycleFiles.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace asperity {
namespace {

AdhesiveFitOptions rubberOptions(bool twoWorks) {
    AdhesiveFitOptions options;
    options.law = ContactLaw::SphereJkr;
    options.tipRadius = 7.5e-6;
    options.twoWorks = twoWorks;
    return options;
}

TEST(AdhesiveFit, FindsWhatMadeTheCycle) {
    for (const bool two : {false, true}) {
        const auto cycle = test::syntheticCycle(two ? "jkr_two" : "jkr_one", 1e-4);
        const AdhesiveFit fit = adhesiveFit(cycle, rubberOptions(two));
        EXPECT_TRUE(fit.bounded.fit.converged);
        EXPECT_NEAR(fit.parameters.reducedModulus / 2e6, 1.0, 0.01);
        EXPECT_NEAR(fit.parameters.approachWork / 0.04, 1.0, 0.01);
        EXPECT_NEAR(fit.parameters.retractWork / (two ? 0.048 : 0.04), 1.0, 0.01);
        EXPECT_NEAR(fit.parameters.contactPoint, 0.0, 1e-9);
        EXPECT_TRUE(fit.bounded.notIdentified().empty());
    }
}

TEST(AdhesiveFit, ScalesWithAllLengths) {
    const auto cycle = test::syntheticCycle("jkr_two", 1e-4);
    AdhesiveFitOptions options = rubberOptions(true);
    const AdhesiveFit small = adhesiveFit(cycle, options);
    options.tipRadius *= 2.0;
    const AdhesiveFit large = adhesiveFit(test::scaled(cycle, 2.0), options);
    EXPECT_NEAR(large.parameters.reducedModulus / small.parameters.reducedModulus, 1.0, 1e-4);
    EXPECT_NEAR(large.parameters.retractWork / small.parameters.retractWork, 2.0, 1e-4);
}

TEST(AdhesiveFit, SaysThatOneWorkIsEnough) {
    auto cycle = test::syntheticCycle("jkr_one");
    cycle.noise = 1e-6 * cycle.forceRange();
    const AdhesiveFit fit = adhesiveFit(cycle, rubberOptions(true));
    const auto missing = fit.bounded.notIdentified();
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_EQ(missing.front(), "work_of_adhesion_ratio");
}

TEST(AdhesiveFit, ApproachDoesNotShowTheWorkOnRetract) {
    AdhesiveFitOptions options = rubberOptions(true);
    options.branch = FittedBranch::Approach;
    const AdhesiveFit fit = adhesiveFit(test::syntheticCycle("jkr_two", 1e-4), options);
    EXPECT_EQ(fit.bounded.notIdentified(), std::vector<std::string>{"work_of_adhesion_ratio"});
}

TEST(AdhesiveFit, TransitionParameterChoosesTheLaw) {
    AdhesiveFitOptions options;
    options.tipRadius = 7.5e-6;
    const AdhesiveFit fit = adhesiveFit(test::syntheticCycle("jkr_one", 1e-4), options);
    EXPECT_EQ(fit.parameters.law, ContactLaw::SphereJkr);
    EXPECT_NEAR(fit.parameters.reducedModulus / 2e6, 1.0, 0.01);
}

/// Without a named tip fits know products with its radius alone: then they take one of 1 m.
TEST(AdhesiveFit, AnyRadiusGivesTheSameProducts) {
    const auto cycle = test::syntheticCycle("jkr_one", 1e-4);
    AdhesiveFitOptions options = rubberOptions(false);
    options.law = ContactLaw::Jkr;
    const AdhesiveParameters small = adhesiveFit(cycle, options).parameters;
    options.tipRadius = 1.0;
    const AdhesiveParameters large = adhesiveFit(cycle, options).parameters;
    EXPECT_NEAR(large.approachWork / (small.approachWork * small.tipRadius), 1.0, 1e-4);
    EXPECT_NEAR(large.reducedModulus / (small.reducedModulus * std::sqrt(small.tipRadius)), 1.0,
                1e-4);
}

TEST(AdhesiveFit, RefusesWhatDoesNotGoTogether) {
    const auto cycle = test::syntheticCycle("jkr_two", 1e-4);
    AdhesiveFitOptions options = rubberOptions(true);
    options.law = ContactLaw::Maugis;
    EXPECT_THROW((void)adhesiveFit(cycle, options), Error);
    options = rubberOptions(false);
    options.tipRadius = 10.0;
    EXPECT_THROW((void)adhesiveFit(cycle, options), Error);
    options = rubberOptions(false);
    options.law = ContactLaw::SphereSplit;
    EXPECT_THROW((void)adhesiveFit(cycle, options), Error);
}

/// One column of EXPECTED_MATCH.csv.
class SiliconNitride {
public:
    SiliconNitride(bool rigid, FittedBranch branch)
        : column_(std::string(rigid ? "rigid" : "elastic") +
                  (branch == FittedBranch::Both ? "_all" : "_from_retract_only"))
        , cycle_(test::sharedCycle("sin_ibw", 1.1841, 0.6)) {
        AdhesiveFitOptions options;
        options.law = ContactLaw::Maugis;
        options.tipRadius = 10e-9;
        options.freeGain = true;
        options.branch = branch;
        if (rigid) {
            options.fixedModulus = 70e9;
        }
        fit_ = adhesiveFit(cycle_, options);
    }

    [[nodiscard]] double expected(const std::string& quantity) const {
        const test::ReferenceTable table(test::sharedData("curves/EXPECTED_MATCH.csv"));
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (table.text(row, "quantity") == quantity) {
                return table.number(row, column_);
            }
        }
        ADD_FAILURE() << "no row " << quantity;
        return 0.0;
    }
    void expectRatio(double value, const std::string& quantity, double tolerance) const {
        EXPECT_NEAR(value / expected(quantity), 1.0, tolerance) << quantity << " of " << column_;
    }
    void expectGainAndSample() const {
        const AdhesiveParameters& found = fit_.parameters;
        expectRatio(found.lever.gain, "g", 0.03);
        expectRatio(found.reducedModulus, "E_star", 0.3);
        expectRatio(found.cohesiveRange, "h0", 0.2);
    }
    void expectParameters() const {
        expectGainAndSample();
        expectRatio(fit_.parameters.lever.trueStiffness(), "k_true", 0.03);
        expectRatio(fit_.parameters.approachWork * fit_.parameters.tipRadius, "w_times_R", 0.03);
    }
    void expectSmallerResidualOfTheRetract() const {
        const SimulatedCycle forces = simulated(AdhesiveCycle(fit_.parameters), cycle_);
        EXPECT_LT(cycleResiduals(cycle_, fit_.events, forces, forces).retractContact,
                  expected("rms_ret_contact"));
    }
    void expectFigures(double approach, double place) const {
        const AdhesiveCycle model(fit_.parameters);
        const SimulatedCycle forces = simulated(model, cycle_);
        const CycleResiduals rms = cycleResiduals(cycle_, fit_.events, forces, forces);
        EXPECT_LE(rms.approachContact, approach) << column_;
        EXPECT_LE(rms.retractContact, 0.012) << column_;
        EXPECT_LE(rms.cycle, 0.005) << column_;
        EXPECT_LE(rms.cycleWithJumps, 0.04) << column_;
        EXPECT_EQ(rms.forwardCycle, rms.cycle);
        const CycleFigures measured = cycleFigures(cycle_, fit_.events);
        const CycleFigures found = simulatedFigures(cycle_, fit_.events, model, forces);
        EXPECT_NEAR(model.lowestForce() / measured.lowestForce, 1.0, 0.02) << column_;
        EXPECT_NEAR(*found.pullOffBase, *measured.pullOffBase, place) << column_;
        expectRatio(measured.loopEnergy, "loop_meas", 0.02);
        expectRatio(found.loopEnergy, "loop_sim", 0.03);
        expectRatio(*measured.snapInForce, "F_after_snap_meas", 0.02);
        expectRatio(*found.snapInForce, "F_after_snap_sim", 0.05);
    }

private:
    std::string column_;
    MeasuredCycle cycle_;
    AdhesiveFit fit_;
};

TEST(AdhesiveFit, RigidSampleInAir) {
    ASPERITY_NEEDS_SHARED_DATA();
    const SiliconNitride all(true, FittedBranch::Both);
    all.expectParameters();
    all.expectFigures(0.012, 1.5e-9);
    const SiliconNitride retract(true, FittedBranch::Retract);
    retract.expectParameters();
    retract.expectFigures(0.015, 1.5e-9);
}

TEST(AdhesiveFit, ElasticSampleInAir) {
    ASPERITY_NEEDS_SHARED_DATA();
    const SiliconNitride all(false, FittedBranch::Both);
    all.expectParameters();
    all.expectFigures(0.012, 0.3e-9);
    // Stiffness and work do not hold here: +5.5 and +6.2 %, at a residual below the table's, so
    // that its fit had not reached its own minimum (docs/measured.md).
    const SiliconNitride retract(false, FittedBranch::Retract);
    retract.expectGainAndSample();
    retract.expectSmallerResidualOfTheRetract();
    retract.expectFigures(0.015, 0.3e-9);
}

}  // namespace
}  // namespace asperity
