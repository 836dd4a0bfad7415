#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticTick.h"
#include "core/scene/Scene.h"
#include "tests/support/ScaledScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

using test::ScaledScene;

/// The model's forces on a tip that goes down, along x and up again, over scale squared [N].
std::vector<Vector3> forcesOn(const ScaledScene& scene, double scale) {
    constexpr int kTicks = 120;  // of each of the three ways
    const Scene built = buildScene(scene.description, scene.map);
    const double touch = touchHeight(built, scene.position.x(), scene.position.y());
    TickMemory memory;
    ClosestPointTracker tracker;
    std::vector<Vector3> forces;
    for (int i = 0; i < 3 * kTicks; ++i) {
        const double part = static_cast<double>(i % kTicks) / kTicks;
        const double down = i < kTicks ? part : (i < 2 * kTicks ? 1.0 : 1.0 - part);
        const double along = i < kTicks ? 0.0 : (i < 2 * kTicks ? part : 1.0);
        const Vector3 base(scene.position.x() + 0.3 * along * scene.reach, scene.position.y(),
                           touch + (1.0 - 2.0 * down) * scene.reach);
        const TickInput input{.device = {.position = base}, .timeStep = 1e-3};
        // A speed is no length: time is not scaled.
        BaseCommand command;
        command.base = {base, {1e-3, 0.0, 0.0}};
        const TickOutput out = tick(built, input, command, memory, tracker);
        forces.emplace_back(out.model.force / (scale * scale));
    }
    return forces;
}

/// Elasticity and adhesion know no length but those of the scene.
TEST(ScaledTick, HasTheSameForcesAtEveryScale) {
    for (const ScaledScene& scene : test::scenesWithoutLengths()) {
        SCOPED_TRACE(scene.name);
        const std::vector<Vector3> usual = forcesOn(scene, 1.0);
        double largest = 0.0;
        for (const Vector3& force : usual) {
            largest = std::max(largest, force.norm());
        }
        ASSERT_GT(largest, 0.0);
        for (const double scale : {0.125, 0.5, 2.0, 8.0, 64.0}) {
            const std::vector<Vector3> forces = forcesOn(test::scaled(scene, scale), scale);
            double worst = 0.0;
            for (std::size_t i = 0; i < forces.size(); ++i) {
                worst = std::max(worst, (forces[i] - usual[i]).norm());
            }
            EXPECT_LT(worst, 1e-6 * largest) << "scale " << scale;
        }
    }
}

}  // namespace
}  // namespace asperity
