#include "core/identify/cycle/RelaxingContact.h"

#include "core/contact/laws/HertzLaw.h"
#include "tests/core/identify/cycle/CycleFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// What tests/physics/cycles.py made its relaxing cycles of.
RelaxingParameters gel() {
    return {.tipRadius = 7.5e-6,
            .longModulus = 1000.0,
            .relaxingModulus = 1500.0,
            .relaxationTime = 0.1,
            .dragOffset = 0.5e-6};
}

struct GelMotion {
    std::vector<double> times;
    std::vector<double> indentations;
};

/// Into the sample and out of it again.
GelMotion triangle(double deepest, double duration, int count) {
    GelMotion motion;
    for (int i = -count / 4; i <= 2 * count + count / 4; ++i) {
        const double share = static_cast<double>(i) / count;
        motion.times.push_back(share * duration);
        motion.indentations.push_back(deepest * (share < 1.0 ? share : 2.0 - share));
    }
    return motion;
}

TEST(RelaxingContact, WithoutRelaxationIsElasticBothWays) {
    for (const bool sphere : {true, false}) {
        RelaxingParameters parameters = gel();
        parameters.relaxingModulus = 0.0;
        parameters.sphere = sphere;
        const GelMotion motion = triangle(12e-6, 1.0, 200);
        const auto forces = relaxingForces(parameters, motion.times, motion.indentations);
        const ContactPair pair{.tipRadius = 7.5e-6, .reducedModulus = 1000.0 / 0.75};
        const double largest = *std::max_element(forces.begin(), forces.end());
        for (std::size_t i = 0; i < forces.size(); ++i) {
            const double depth = motion.indentations[i];
            if (depth <= 1e-12) {
                EXPECT_EQ(forces[i], 0.0);
                continue;
            }
            const double exact = sphere ? SneddonLaw(pair).stable(depth, 0.0)->force
                                        : HertzLaw(pair).atIndentation(depth).force;
            EXPECT_NEAR(forces[i], exact, 1e-4 * largest) << i;
        }
    }
}

TEST(RelaxingContact, HeldIndentationRelaxesToTheLongModulus) {
    const RelaxingParameters parameters = gel();
    const double depth = 1e-6;
    const std::vector<double> times{0.0, 1e-7, 0.1, 0.2, 10.0};
    const auto forces = relaxingForces(parameters, times, {0.0, depth, depth, depth, depth});
    const double elastic =
        SneddonLaw({.tipRadius = 7.5e-6, .reducedModulus = 1.0}).stable(depth, 0.0)->force / 0.75;
    EXPECT_NEAR(forces[1] / (2500.0 * elastic), 1.0, 1e-5);
    EXPECT_NEAR(forces[2] / ((1000.0 + 1500.0 * std::exp(-1.0)) * elastic), 1.0, 1e-5);
    EXPECT_NEAR(forces[4] / (1000.0 * elastic), 1.0, 1e-5);
}

TEST(RelaxingContact, LosesEnergyInEveryLoop) {
    RelaxingParameters parameters = gel();
    parameters.drag = 1e-11;
    for (const double duration : {1e-3, 0.1, 10.0}) {
        const GelMotion motion = triangle(2e-6, duration, 400);
        const auto forces = relaxingForces(parameters, motion.times, motion.indentations);
        double work = 0.0;
        for (std::size_t i = 1; i < forces.size(); ++i) {
            work += 0.5 * (forces[i] + forces[i - 1]) *
                    (motion.indentations[i] - motion.indentations[i - 1]);
        }
        EXPECT_GT(work, 0.0);
    }
}

TEST(RelaxingContact, SmallNoiseOfTheIndentationMakesSmallErrors) {
    const RelaxingParameters parameters = gel();
    GelMotion motion = triangle(2e-6, 0.2, 400);
    const auto smooth = relaxingForces(parameters, motion.times, motion.indentations);
    for (std::size_t i = 0; i < motion.times.size(); i += 2) {
        motion.indentations[i] += 1e-8;  // twice a step
    }
    const auto rough = relaxingForces(parameters, motion.times, motion.indentations);
    const double largest = *std::max_element(smooth.begin(), smooth.end());
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        EXPECT_NEAR(rough[i], smooth[i], 0.03 * largest) << i;
    }
}

TEST(RelaxingContact, ForwardSimulationIsTheCycleOfFormulasOfItsOwn) {
    struct Case {
        const char* name;
        double drag;
    };
    for (const auto& [name, drag] :
         {Case{"relaxing_slow", 0.0}, Case{"relaxing_fast", 0.0}, Case{"relaxing_drag", 1e-11}}) {
        const MeasuredCycle cycle = test::syntheticCycle(name);
        CycleBranch all = cycle.approach;
        all.time.insert(all.time.end(), cycle.retract.time.begin(), cycle.retract.time.end());
        all.base.insert(all.base.end(), cycle.retract.base.begin(), cycle.retract.base.end());
        all.force.insert(all.force.end(), cycle.retract.force.begin(), cycle.retract.force.end());
        RelaxingParameters parameters = gel();
        parameters.drag = drag;
        const auto forces = simulatedForces(parameters, cycle.stiffness, all.time, all.base);
        for (std::size_t i = 1; i < forces.size(); ++i) {
            ASSERT_NEAR(forces[i], all.force[i], 0.005 * cycle.forceRange()) << name << " " << i;
        }
    }
}

TEST(RelaxingContact, TwoSamplesOfOneTimeHaveNoSpeed) {
    RelaxingParameters parameters = gel();
    parameters.drag = 1e-11;
    const auto forces =
        simulatedForces(parameters, 0.02, {0.0, 0.1, 0.1, 0.2}, {-1e-6, 0.5e-6, 0.5e-6, 1e-6});
    for (const double force : forces) {
        EXPECT_TRUE(std::isfinite(force));
    }
    EXPECT_GT(forces[3], forces[1]);
}

TEST(RelaxingContact, ScalesWithAllLengths) {
    RelaxingParameters parameters = gel();
    GelMotion motion = triangle(2e-6, 0.2, 200);
    const auto small = relaxingForces(parameters, motion.times, motion.indentations);
    parameters.tipRadius *= 2.0;
    for (double& indentation : motion.indentations) {
        indentation *= 2.0;
    }
    const auto large = relaxingForces(parameters, motion.times, motion.indentations);
    for (std::size_t i = 0; i < small.size(); ++i) {
        EXPECT_NEAR(large[i], 4.0 * small[i], 1e-9 * 4.0 * small[200]);
    }
}

}  // namespace
}  // namespace asperity
