#include "core/Units.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/mapping/WorkspaceMapping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace asperity {
namespace {

constexpr double kStillAtEdge = 0.05e-3;  // [m]
constexpr double kShakesAtEdge = 0.5e-3;  // [m]
constexpr double kRadius = 50e-3;         // of the workspace [m]
constexpr double kReach = 60e-3;          // where the arm would like to be [m]
constexpr double kTimeStep = 1e-3;        // [s]

/// How far the handle goes to and fro at the edge, two seconds after it was thrown there [m].
double motionAtEdge(const Workspace& workspace, double delay) {
    VirtualBench bench({.arm = kLightGrip, .delay = delay}, Vector3::Zero());
    bench.reachFor({kReach, 0.0, 0.0});
    double low = kReach;
    double high = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const DeviceState device = bench.advance(kTimeStep);
        bench.setForce(edgeForce(workspace, device.position));
        if (i >= 2000) {
            low = std::min(low, bench.position().x());
            high = std::max(high, bench.position().x());
        }
    }
    return high - low;
}

TEST(HeldAtEdge, ALightGripStaysAtRest) {
    for (const double delay : {0.0, 1.0_ms, 2.0_ms, 5.0_ms, 8.0_ms}) {
        const Workspace workspace = workspaceOf(kRadius, 0.5 * kTimeStep + delay);
        const double motion = motionAtEdge(workspace, delay);
        std::cout << delay * 1e3 << " ms: " << workspace.stiffness << " N/m, moves " << motion * 1e3
                  << " mm\n";
        EXPECT_LT(motion, kStillAtEdge) << delay;
    }
}

TEST(HeldAtEdge, AStifferSpringThanTheGripDampsShakes) {
    Workspace workspace = workspaceOf(kRadius, 5.5_ms);
    workspace.stiffness = 400.0;
    workspace.forceLimit = 10.0;
    EXPECT_GT(motionAtEdge(workspace, 5.0_ms), kShakesAtEdge);
}

}  // namespace
}  // namespace asperity
