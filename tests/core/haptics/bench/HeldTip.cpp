#include "tests/core/haptics/bench/HeldTip.h"

#include "core/Units.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/core/haptics/TestDevice.h"
#include "tests/support/Places.h"
#include "tests/support/TestScenes.h"

#include <algorithm>
#include <limits>

namespace asperity::test {

namespace {

constexpr double kApproach = 10.0_ms;
constexpr double kTurn = 0.5;     // [s]
constexpr double kSettled = 2.0;  // [s]
constexpr double kEnd = 2.5;      // [s]

/// The middle of the test maps, in the device's frame.
Vector3 above(double height) { return {64e-3, 64e-3, height}; }

/// Tick and simulated instrument.
class CoupledTick {
public:
    CoupledTick(const Scene& scene, const Hold& hold)
        : scene_(scene), afm_(scene.trueSurface(), truthOf(scene)) {
        input_.settings = scene.settings;
        input_.settings.coupling = hold.coupling;
        input_.settings.guide = hold.guide;
        input_.timeStep = scene.timeStep();
    }

    /// The device force.
    Vector3 moveTo(const DeviceState& device) {
        input_.device = device;
        input_.measurement = afm_.exchange(commandBase(scene_, input_, memory_).base);
        return tick(scene_, input_, memory_).deviceForce;
    }

    [[nodiscard]] const Vector3& tipForce() const { return afm_.trueState().force; }

private:
    const Scene& scene_;
    SimulatedAfm afm_;
    TickInput input_;
    TickMemory memory_;
};

}  // namespace

Scene hapticScene(const std::string& material, const HeightMap& map, double tickRate,
                  double magnified) {
    SceneDescription description = plainScene();
    description.sample.material =
        readMaterialFile(test::dataFolder().string() + "/materials/" + material + ".toml");
    description.truth.material = description.sample.material;
    description.tickRate = tickRate;
    description.settings.positionGain = 1.0_nm / 1e-3;
    description.settings.forceGain = magnified / 10.0_nN;
    return buildScene(description, map);
}

CouplingGains designed(const Scene& scene, double delay) {
    return designCoupling(kPhantom, {.timeStep = scene.timeStep(), .delay = delay});
}

HeldTip holdTip(const Scene& scene, const Hold& hold, const PortWatch& watch) {
    constexpr double kStart = 4e-3;  // [m]
    VirtualBench bench(hold.bench, above(kStart));
    CoupledTick loop(scene, hold);
    HeldTip held;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    int counted = 0;
    for (int i = 0; i * scene.timeStep() < kEnd; ++i) {
        const double time = i * scene.timeStep();
        const double way = std::min(1.0, time / kApproach);
        const double lift = time >= kTurn ? hold.lift : 0.0;
        bench.reachFor(above(kStart + way * (hold.goal - kStart) + lift));
        if (hold.letGo && time >= kTurn) {
            bench.grip(kNoGrip);
        }
        const DeviceState device = bench.advance(scene.timeStep());
        const Vector3 force = loop.moveTo(device);
        bench.setForce(force);
        if (watch) {
            watch(device.position, force);
        }
        if (time >= kSettled) {
            low = std::min(low, bench.position().z());
            high = std::max(high, bench.position().z());
            held.force += force;
            held.tipForce += loop.tipForce();
            ++counted;
        }
    }
    held.peakToPeak = high - low;
    held.force /= counted;
    held.tipForce /= counted;
    held.handle = bench.position();
    return held;
}

}  // namespace asperity::test
