#include "core/Units.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/cycle/CycleDetector.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/Places.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>

namespace asperity {
namespace {

/// What is read from the curve of a slow cycle on a flat sample, against the contact law itself.
/// Parameters: material, depth of the base below first touch [m], with the detector's noise.
class CycleOfScene : public ::testing::TestWithParam<std::tuple<const char*, double, bool>> {
protected:
    void SetUp() override {
        const auto [name, depth, noisy] = GetParam();
        SceneDescription description = test::plainScene();
        description.sample.material =
            readMaterialFile(test::dataFolder() / "materials" / (std::string(name) + ".toml"));
        description.truth.material = description.sample.material;
        description.truth.signalNoise = noisy ? description.truth.signalNoise : 0.0;
        const Scene scene = buildScene(description, test::flatMap());
        compliance = scene.belief.cantilever.compliance()(2, 2);
        ForceCurvePlan plan = curvePlan(scene.belief.contact, compliance);
        plan.deepest = depth;
        plan.points = 4000;
        law = forceCurve(scene.belief.contact, compliance, plan);
        cycle = read(scene, depth);
    }

    /// Down and up again in ten seconds each.
    static ContactCycle read(const Scene& scene, double depth) {
        const Vector3 above = waitingPosition(scene, {64.0_nm, 64.0_nm});
        const DevicePath path{{0.0, above}, {10.0, {above.x(), above.y(), -depth}}, {20.0, above}};
        SimulatedAfm afm(scene.surface, truthOf(scene));
        CycleDetector detector;
        runVirtually(scene, path, afm, 20001, [&](const TickSample& sample) {
            detector.take(sample.time, sample.input, sample.output);
        });
        return detector.cycle();
    }

    /// Area below zero force of the law's retract curve [J].
    [[nodiscard]] double lawWork() const {
        double work = 0.0;
        for (std::size_t i = 1; i < law.retract.size(); ++i) {
            const ForceCurvePoint& before = law.retract[i - 1];
            const ForceCurvePoint& now = law.retract[i];
            const bool off = before.state.branch == ContactBranch::Far;
            const double pull =
                std::max(0.0, -before.state.force) + std::max(0.0, -now.state.force);
            work += off ? 0.0 : 0.5 * pull * (before.basePosition - now.basePosition);
        }
        return work;
    }

    /// Strongest pull of the law's retract curve [N].
    [[nodiscard]] double lawPull() const {
        double pull = 0.0;
        for (const ForceCurvePoint& point : law.retract) {
            pull = std::max(pull, -point.state.force);
        }
        return pull;
    }

    /// Strongest pull of the law's approach, and the base's distance there.
    [[nodiscard]] const ForceCurvePoint& lawSnapIn() const {
        return *std::min_element(law.approach.begin(), law.approach.end(),
                                 [](const ForceCurvePoint& a, const ForceCurvePoint& b) {
                                     return a.state.force < b.state.force;
                                 });
    }

    [[nodiscard]] double lawHysteresis() const {
        return (law.snapIn ? law.snapIn->after.energyLost : 0.0) +
               (law.pullOff ? law.pullOff->after.energyLost : 0.0);
    }

    /// Stiffness of the law's contact where unloading has come half of the way that is fitted
    /// [N/m].
    [[nodiscard]] double lawStiffness() const {
        const double half = 0.875 * law.retract.front().state.force;
        for (const ForceCurvePoint& point : law.retract) {
            if (point.state.force < half) {
                return point.state.stiffness;
            }
        }
        return 0.0;
    }

    [[nodiscard]] static bool noisy() { return std::get<2>(GetParam()); }

    double compliance = 0.0;  ///< of the lever [m/N]
    ForceCurve law;
    ContactCycle cycle;
};

TEST_P(CycleOfScene, PullOffIsThatOfTheLaw) {
    ASSERT_TRUE(cycle.complete());
    ASSERT_TRUE(cycle.pullOff);
    const double tolerance = noisy() ? 0.2e-9 : 0.01 * lawPull();
    EXPECT_NEAR(cycle.pullOff->value, lawPull(), tolerance);
}

TEST_P(CycleOfScene, SnapInIsThatOfTheLaw) {
    ASSERT_TRUE(cycle.snapIn);
    const double pull = -lawSnapIn().state.force;
    EXPECT_NEAR(cycle.snapIn->value, pull, noisy() ? 5.0 * cycle.snapIn->sigma : 0.02 * pull);
    EXPECT_NEAR(cycle.snapInBaseDistance.value, -lawSnapIn().basePosition,
                noisy() ? 0.02_nm : 0.02 * std::abs(lawSnapIn().basePosition));
}

TEST_P(CycleOfScene, PositionIsWhereTheTipTouched) {
    // The lever is inclined: as it bends at the snap-in, the tip moves some 0.05 nm sideways.
    EXPECT_NEAR(cycle.position.x(), 64.0_nm, 0.1_nm);
    EXPECT_NEAR(cycle.position.y(), 64.0_nm, 0.1_nm);
}

TEST_P(CycleOfScene, WorkIsTheIntegralOfTheLawsCurve) {
    EXPECT_NEAR(cycle.adhesionWork, lawWork(), (noisy() ? 0.1 : 0.02) * lawWork());
}

TEST_P(CycleOfScene, HysteresisIsWhatTheJumpsDissipate) {
    EXPECT_NEAR(cycle.hysteresis, lawHysteresis(), (noisy() ? 0.15 : 0.02) * lawHysteresis());
}

TEST_P(CycleOfScene, IndentationAndForceAreThoseAtTheTurn) {
    const ContactState& deepest = law.retract.front().state;
    EXPECT_NEAR(cycle.maxForce->value, deepest.force, noisy() ? 0.2e-9 : 0.01 * deepest.force);
    EXPECT_NEAR(cycle.maxIndentation->value, deepest.indentation,
                noisy() ? 0.05_nm : 0.01 * deepest.indentation);
}

TEST_P(CycleOfScene, StiffnessIsThatOfTheLawWhereUnloadingBegins) {
    ASSERT_TRUE(cycle.stiffness);
    EXPECT_LT(cycle.stiffness->sigma, 0.15 * cycle.stiffness->value);
    const double tolerance = 0.03 * lawStiffness() + 4.0 * cycle.stiffness->sigma;
    EXPECT_NEAR(cycle.stiffness->value, lawStiffness(), tolerance);
}

INSTANTIATE_TEST_SUITE_P(Materials, CycleOfScene,
                         ::testing::Values(std::tuple{"polystyrene", 2.0_nm, false},
                                           std::tuple{"polystyrene", 2.0_nm, true},
                                           std::tuple{"silicon_oxide", 2.0_nm, false},
                                           std::tuple{"silicon_oxide", 2.0_nm, true},
                                           std::tuple{"silicone_rubber", 20.0_nm, false}));

}  // namespace
}  // namespace asperity
