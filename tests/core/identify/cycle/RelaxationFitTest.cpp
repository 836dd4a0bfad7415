#include "core/identify/cycle/RelaxationFit.h"

#include "core/Error.h"
#include "tests/core/identify/cycle/CycleFiles.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace asperity {
namespace {

using test::ReferenceTable;

/// A row of EXPECTED_VISCO.csv and its curve.
class ViscousRow {
public:
    ViscousRow(const std::string& curve, double stiffness)
        : table_(test::sharedData("curves/EXPECTED_VISCO.csv"))
        , cycle_(test::sharedCycle(curve, stiffness, 0.5)) {
        while (table_.text(row_, "curve") != curve) {
            ++row_;
        }
    }

    [[nodiscard]] double number(const std::string& column) const {
        return table_.number(row_, column);
    }
    [[nodiscard]] const MeasuredCycle& cycle() const { return cycle_; }
    [[nodiscard]] RelaxationFit fit(bool relaxation, bool drag) const {
        RelaxationFitOptions options;
        options.tipRadius = number("R");
        options.sphere = false;
        options.relaxation = relaxation;
        options.drag = drag;
        return relaxationFit(cycle_, options);
    }

private:
    ReferenceTable table_;
    std::size_t row_ = 0;
    MeasuredCycle cycle_;
};

bool has(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// JKR on the samples that the fit saw, as a share of the force range.
double rmsOfJkr(const RelaxationFit& fit, const MeasuredCycle& whole) {
    MeasuredCycle cycle;
    for (std::size_t i = 0; i < fit.samples.size(); ++i) {
        CycleBranch& branch = i < fit.turn ? cycle.approach : cycle.retract;
        branch.base.push_back(fit.samples.base[i]);
        branch.force.push_back(fit.samples.force[i]);
    }
    cycle.stiffness = whole.stiffness;
    cycle.noise = whole.noise;
    AdhesiveFitOptions options;
    options.law = ContactLaw::Jkr;
    options.tipRadius = fit.parameters.tipRadius;
    const AdhesiveFit jkr = adhesiveFit(cycle, options);
    const SimulatedCycle forces = simulated(AdhesiveCycle(jkr.parameters), cycle);
    return cycleResiduals(cycle, jkr.events, forces, forces).cycleWithJumps;
}

TEST(RelaxationFit, TissueInLiquid) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ViscousRow row("refpoints0_jpk", 0.010950848060582613);
    const RelaxationFit fit = row.fit(true, true);
    EXPECT_LE(fit.residuals.cycle, 0.010);
    EXPECT_LE(fit.residuals.forwardCycle, 0.010);
    EXPECT_LE(5.0 * fit.residuals.forwardCycle, row.number("rms_jkr_spring"));
    EXPECT_LE(5.0 * fit.residuals.forwardCycle, rmsOfJkr(fit, row.cycle()));
    EXPECT_NEAR(fit.simulated.lowestForce / fit.measured.lowestForce, 1.0, 0.06);
    EXPECT_NEAR(fit.simulated.loopEnergy / fit.measured.loopEnergy, 1.0, 0.06);
    EXPECT_NEAR(fit.parameters.longModulus / row.number("E_inf"), 1.0, 0.15);
    EXPECT_NEAR(fit.parameters.relaxingModulus / row.number("E_1"), 1.0, 0.15);
    EXPECT_NEAR(fit.parameters.relaxationTime / row.number("tau"), 1.0, 0.15);
    EXPECT_NEAR(fit.parameters.drag / row.number("drag_C"), 1.0, 0.15);
    EXPECT_NEAR(fit.parameters.dragOffset / row.number("h_off"), 1.0, 0.15);
    EXPECT_TRUE(fit.bounded.notIdentified().empty());
    EXPECT_NEAR(row.fit(false, true).residuals.cycle / row.number("rms_elastic_drag"), 1.0, 0.15);
    EXPECT_NEAR(row.fit(true, false).residuals.cycle / row.number("rms_ting_only"), 1.0, 0.15);
    EXPECT_NEAR(row.fit(false, false).residuals.cycle / row.number("rms_hertz"), 1.0, 0.15);
}

TEST(RelaxationFit, ForwardSimulationOfAllSamplesAgreesWithTheFew) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ViscousRow row("refpoints0_jpk", 0.010950848060582613);
    const SimulatedCycle forces = simulated(row.fit(true, true), row.cycle());
    ASSERT_EQ(forces.retract.size(), row.cycle().retract.size());
    CycleEvents all;
    all.contactEnd = forces.retract.size();
    EXPECT_LE(cycleResiduals(row.cycle(), all, forces, forces).cycleWithJumps, 0.01);
}

TEST(RelaxationFit, SaysWhatIsNotIdentified) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ViscousRow flipped("flipsign_jpk", 0.01868898956509838);
    const RelaxationFit partly = flipped.fit(true, true);
    EXPECT_LE(partly.residuals.cycle, 0.0126);
    EXPECT_LE(partly.residuals.forwardCycle, 0.0138);
    EXPECT_TRUE(has(partly.bounded.notIdentified(), "long_term_modulus_pa"));
    for (const auto& [curve, stiffness] :
         {std::pair{"refpoints1_jpk", 0.010950848060582613}, std::pair{"chiaro_txt", 0.019}}) {
        const RelaxationFit fit = ViscousRow(curve, stiffness).fit(true, true);
        EXPECT_GT(fit.residuals.cycle, 0.04) << curve;
        EXPECT_TRUE(has(fit.bounded.notIdentified(), "long_term_modulus_pa")) << curve;
    }
}

TEST(RelaxationFit, FindsWhatMadeTheCycle) {
    for (const char* name : {"relaxing_slow", "relaxing_fast", "relaxing_drag"}) {
        RelaxationFitOptions options;
        options.tipRadius = 7.5e-6;
        options.drag = std::string(name) == "relaxing_drag";
        options.forward = true;
        // Drag acts by the mean speed of a step, so it comes half a step late.
        const double tolerance = options.drag ? 0.03 : 0.01;
        const RelaxationFit fit = relaxationFit(test::syntheticCycle(name, 1e-4), options);
        EXPECT_NEAR(fit.parameters.longModulus / 1000.0, 1.0, tolerance) << name;
        EXPECT_NEAR(fit.parameters.relaxingModulus / 1500.0, 1.0, tolerance) << name;
        EXPECT_NEAR(fit.parameters.relaxationTime / 0.1, 1.0, tolerance) << name;
        if (options.drag) {
            EXPECT_NEAR(fit.parameters.drag / 1e-11, 1.0, 0.02);
            EXPECT_NEAR(fit.parameters.dragOffset / 0.5e-6, 1.0, 0.02);
        }
    }
}

TEST(RelaxationFit, NeedsTimes) {
    MeasuredCycle cycle = test::syntheticCycle("relaxing_slow", 1e-4);
    cycle.retract.time.clear();
    RelaxationFitOptions options;
    options.tipRadius = 7.5e-6;
    EXPECT_THROW((void)relaxationFit(cycle, options), Error);
}

}  // namespace
}  // namespace asperity
