#include "core/identify/cycle/AdhesiveCycle.h"

#include "core/identify/cycle/CycleResiduals.h"
#include "tests/core/identify/cycle/CycleFiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using std::numbers::pi;

/// What tests/physics/cycles.py made its adhesive cycles of.
AdhesiveParameters rubber(double retractWork) {
    return {.law = ContactLaw::SphereJkr,
            .tipRadius = 7.5e-6,
            .reducedModulus = 2e6,
            .approachWork = 0.04,
            .retractWork = retractWork,
            .lever = {.stiffness = 5.0}};
}

/// Base positions there and back.
MeasuredCycle motion(double farthest, double deepest, int count, double stiffness) {
    MeasuredCycle cycle;
    cycle.stiffness = stiffness;
    for (int i = 0; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        cycle.approach.base.push_back(farthest + (share * (deepest - farthest)));
        cycle.retract.base.push_back(deepest + (share * (farthest - deepest)));
    }
    return cycle;
}

double largestMiss(const std::vector<double>& one, const std::vector<double>& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        largest = std::max(largest, std::abs(one[i] - other[i]));
    }
    return largest;
}

MeasuredCycle withForces(MeasuredCycle cycle, const SimulatedCycle& forces) {
    cycle.approach.force = forces.approach;
    cycle.retract.force = forces.retract;
    return cycle;
}

TEST(AdhesiveCycle, IsTheCycleOfFormulasOfItsOwn) {
    for (const auto& [name, work] : {std::pair{"jkr_one", 0.04}, std::pair{"jkr_two", 0.048}}) {
        const MeasuredCycle cycle = test::syntheticCycle(name);
        const SimulatedCycle forces = simulated(AdhesiveCycle(rubber(work)), cycle);
        EXPECT_LT(largestMiss(forces.approach, cycle.approach.force), 1e-7 * cycle.forceRange());
        EXPECT_LT(largestMiss(forces.retract, cycle.retract.force), 1e-7 * cycle.forceRange());
    }
}

TEST(AdhesiveCycle, SoftLeverPullsOffAtTheLoadFold) {
    AdhesiveParameters parameters = rubber(0.05);
    parameters.law = ContactLaw::Jkr;
    parameters.lever.stiffness = 1e-5;
    const AdhesiveCycle jkr(parameters);
    EXPECT_NEAR(jkr.pullOffForce() / (-1.5 * pi * 0.05 * 7.5e-6), 1.0, 1e-6);
    parameters.law = ContactLaw::Dmt;
    const AdhesiveCycle dmt(parameters);
    EXPECT_NEAR(dmt.lowestForce() / (-2.0 * pi * 0.04 * 7.5e-6), 1.0, 1e-6);
}

TEST(AdhesiveCycle, LoopLosesWhatItsJumpsLose) {
    AdhesiveParameters parameters = rubber(0.04);
    const AdhesiveCycle model(parameters);
    const MeasuredCycle path = motion(-1e-6, 1e-6, 100000, parameters.lever.stiffness);
    const ContactModel& law = model.growing();
    const double compliance = 1.0 / parameters.lever.stiffness;
    double lost = 0.0;
    ContactMemory memory;
    for (const CycleBranch* branch : {&path.approach, &path.retract}) {
        for (const double base : branch->base) {
            const ContactState state = law.equilibrium(base, compliance, memory);
            lost += state.energyLost;
            memory = state.memory();
        }
    }
    const MeasuredCycle cycle = withForces(path, simulated(model, path));
    EXPECT_NEAR(cycleFigures(cycle, cycleEvents(cycle)).loopEnergy / lost, 1.0, 1e-3);
}

TEST(AdhesiveCycle, ScalesWithAllLengths) {
    AdhesiveParameters parameters = rubber(0.048);
    AdhesiveParameters twice = parameters;
    twice.tipRadius *= 2.0;
    twice.approachWork *= 2.0;
    twice.retractWork *= 2.0;
    twice.lever.stiffness *= 2.0;
    const MeasuredCycle path = motion(-1e-6, 1e-6, 500, 5.0);
    const MeasuredCycle small = withForces(path, simulated(AdhesiveCycle(parameters), path));
    const MeasuredCycle large = test::scaled(small, 2.0);
    const SimulatedCycle forces = simulated(AdhesiveCycle(twice), large);
    EXPECT_LT(largestMiss(forces.approach, large.approach.force), 1e-9 * large.forceRange());
    EXPECT_LT(largestMiss(forces.retract, large.retract.force), 1e-9 * large.forceRange());
}

TEST(AdhesiveCycle, GainChangesLeverOrForce) {
    const CycleLever thermal{.stiffness = 2.0, .gain = 2.0};
    EXPECT_EQ(thermal.trueStiffness(), 0.5);
    EXPECT_EQ(thermal.forceFactor(), 2.0);
    const CycleLever fixed{.stiffness = 2.0, .gain = 2.0, .calibration = SpringCalibration::Fixed};
    EXPECT_EQ(fixed.trueStiffness(), 2.0);
    EXPECT_EQ(fixed.forceFactor(), 0.5);
}

TEST(AdhesiveCycle, RangeIsWhereItSnapsIn) {
    AdhesiveParameters parameters = rubber(0.04);
    parameters.law = ContactLaw::Maugis;
    parameters.cohesiveRange = 20e-9;
    parameters.contactPoint = 1e-6;
    EXPECT_NEAR(AdhesiveCycle(parameters).snapIn().value(), 1e-6 - 20e-9, 1e-15);
}

}  // namespace
}  // namespace asperity
