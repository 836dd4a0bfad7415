#include "core/Units.h"
#include "core/haptics/HapticTick.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace asperity {
namespace {

/// A device, the tick and a simulated instrument, ticked one position of the device at a time.
class Bench {
public:
    explicit Bench(const Scene& scene) : scene_(scene), afm_(scene.surface, truthOf(scene)) {
        input_.settings = scene.settings;
        input_.timeStep = scene.timeStep();
    }

    TickOutput moveTo(const Vector3& position) {
        input_.device.position = position;
        input_.measurement = afm_.exchange(commandBase(scene_, input_, memory_).base);
        return tick(scene_, input_, memory_);
    }
    void control(PositionControl control) { input_.settings.positionControl = control; }
    [[nodiscard]] const TipState& truth() const { return afm_.trueState(); }

private:
    const Scene& scene_;
    SimulatedAfm afm_;
    TickInput input_;
    TickMemory memory_;
};

SceneDescription described(PositionControl control) {
    SceneDescription description = test::plainScene();
    description.settings.positionControl = control;
    return description;
}

/// Apex of a tip that indents the surface by `depth` along its normal at (x, y).
Vector3 indenting(const Scene& scene, double x, double y, double depth) {
    const HeightSample sample = scene.surface.at(x, y);
    const double radius = scene.belief.tipRadius();
    return Vector3(x, y, sample.height) + (radius - depth) * sample.normal() -
           Vector3(0.0, 0.0, radius);
}

/// Largest distance of the true tip from where the device wants it, on a raster of 50 nm in
/// contact.
double rasterError(PositionControl control) {
    const Scene scene = buildScene(described(control), test::hillyMap());
    Bench bench(scene);
    bench.moveTo(indenting(scene, 35.0_nm, 35.0_nm, 1.0_nm));  // snaps in
    double worst = 0.0;
    constexpr int kLines = 6;
    constexpr int kSteps = 200;
    for (int line = 0; line < kLines; ++line) {
        for (int i = 0; i <= kSteps; ++i) {
            const double along = (line % 2 == 0 ? i : kSteps - i) * 50.0_nm / kSteps;
            const Vector3 target =
                indenting(scene, 35.0_nm + along, 35.0_nm + line * 10.0_nm, 0.5_nm);
            const TickOutput out = bench.moveTo(target);
            EXPECT_FALSE(out.flags.has(Validity::TipNotHeld));
            worst = std::max(worst, (bench.truth().tip - target).norm());
        }
    }
    std::cout << "largest distance of the true tip from its target: " << worst * 1e12 << " pm\n";
    return worst;
}

TEST(PositionControl, TheTrueTipFollowsARasterInContact) {
    EXPECT_LT(rasterError(PositionControl::Tip), 0.1_nm);
    EXPECT_GT(rasterError(PositionControl::Base), 0.2_nm) << "the lever bends";
}

/// Neither control can hold a tip where the lever is softer than the attraction: both jump from the
/// same position of the tip, and tip control says that it lost it.
TEST(PositionControl, SnapsInFromTheSamePositionAndSaysSo) {
    const Scene scene = buildScene(described(PositionControl::Tip), test::flatMap());
    const auto snapHeight = [&scene](PositionControl control, bool& lost) {
        Bench bench(scene);
        bench.control(control);
        double last = 0.0;
        for (double z = 3.0_nm; z > 0.0; z -= 1.0_pm) {
            const TickOutput out = bench.moveTo({64.0_nm, 64.0_nm, z});
            lost = lost || out.flags.has(Validity::TipNotHeld);
            if (out.model.contact.branch == ContactBranch::Bonded) {
                break;
            }
            last = bench.truth().tip.z();
        }
        return last;
    };
    bool lostTip = false;
    bool lostBase = false;
    const double ofTip = snapHeight(PositionControl::Tip, lostTip);
    const double ofBase = snapHeight(PositionControl::Base, lostBase);
    EXPECT_GT(ofTip, 0.1_nm);
    EXPECT_NEAR(ofTip, ofBase, 5.0_pm);
    EXPECT_TRUE(lostTip);
    EXPECT_FALSE(lostBase) << "it was never asked to hold the tip";
}

TEST(PositionControl, HoldsTheTipAgainAfterSnapIn) {
    const Scene scene = buildScene(described(PositionControl::Tip), test::flatMap());
    Bench bench(scene);
    for (double z = 3.0_nm; z > -1.0_nm; z -= 10.0_pm) {
        bench.moveTo({64.0_nm, 64.0_nm, z});
    }
    const Vector3 target(64.0_nm, 64.0_nm, -1.0_nm);
    const TickOutput out = bench.moveTo(target);
    EXPECT_FALSE(out.flags.has(Validity::TipNotHeld));
    EXPECT_EQ(out.model.contact.branch, ContactBranch::Bonded);
    EXPECT_LT((out.model.tip - target).norm(), 1e-14);
}

/// A soft lever cannot hold a tip on stiff hills, where it is pushed aside: the tick must say so,
/// and nobody may feel a force that stands for no state.
TEST(PositionControl, SaysWhereASoftLeverLosesTheTip) {
    SceneDescription description = described(PositionControl::Tip);
    description.sample.material.elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27};
    description.sample.material.workOfAdhesion = 0.2;
    description.truth.material = description.sample.material;
    description.probe.thickness = thicknessForStiffness(description.probe, 0.185);
    description.truth.stiffness = 0.185;
    const Scene scene = buildScene(description, test::hillyMap());
    Bench bench(scene);
    int lost = 0;
    for (int i = 0; i <= 400; ++i) {
        const double x = 20.0_nm + i * 0.2_nm;
        const Vector3 target = indenting(scene, x, 40.0_nm, 0.5_nm);
        const TickOutput out = bench.moveTo(target);
        const bool held = !out.flags.has(Validity::TipNotHeld);
        lost += held ? 0 : 1;
        if (held) {
            ASSERT_LT((out.model.tip - target).norm(), 0.02_nm) << i;
        }
        if (out.flags.has(Validity::NotInEquilibrium)) {
            ASSERT_EQ(out.deviceForce, Vector3::Zero()) << i;
        }
        ASSERT_LT((out.base.position - target).norm(), 1e-3) << i;
    }
    EXPECT_GT(lost, 0);
}

TEST(PositionControl, SwitchingItMovesNothing) {
    const Scene scene = buildScene(described(PositionControl::Base), test::hillyMap());
    Bench bench(scene);
    const Vector3 device(64.0_nm, 60.0_nm, -2.0_nm);
    TickOutput before;
    for (int i = 0; i < 5; ++i) {
        before = bench.moveTo(device);
    }
    ASSERT_GT(before.model.force.norm(), 1.0_nN);
    for (const PositionControl control : {PositionControl::Tip, PositionControl::Base}) {
        bench.control(control);
        const TickOutput after = bench.moveTo(device);
        EXPECT_LT((after.base.position - before.base.position).norm(), 1e-14);
        EXPECT_LT((after.model.force - before.model.force).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace asperity
