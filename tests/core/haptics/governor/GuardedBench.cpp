#include "tests/core/haptics/governor/GuardedBench.h"

#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "tests/support/TestScenes.h"

namespace asperity::test {

namespace {

constexpr double kHigh = 4e-3;   // [m]
constexpr double kDeep = -5e-3;  // [m]

/// The middle of the test map, in the device's frame.
Vector3 above(double height) { return {64e-3, 64e-3, height}; }

Scene coupledPolystyrene() {
    SceneDescription description = plainScene();
    description.settings.positionGain = 1.0_nm / 1e-3;
    description.settings.forceGain = 1.0 / 10.0_nN;
    description.settings.coupling = {.stiffness = 600.0, .damping = 2.9, .proxyDamping = 3.0};
    return buildScene(description, flatMap());
}

}  // namespace

GuardedBench::GuardedBench() : GuardedBench(coupledPolystyrene(), above(kHigh)) {}

GuardedBench::GuardedBench(const Scene& scene, const Vector3& start)
    : scene_(scene)
    , bench_({.arm = kNormalGrip}, start)
    , afm_(scene_.trueSurface(), truthOf(scene_)) {
    input.settings = scene_.settings;
    input.timeStep = scene_.timeStep();
}

void GuardedBench::reachFor(double height) { reachFor(above(height)); }

void GuardedBench::reachFor(const Vector3& position) { bench_.reachFor(position); }

TickSample GuardedBench::step() {
    time_ += input.timeStep;
    input.device = bench_.advance(input.timeStep);
    input.device.maxForce = kPhantomClass.maxForce;
    input.device.streams = true;
    if (tamper) {
        tamper(input.device, time_);
    }
    input.measurement = afm_.exchange(commandBase(scene_, input, memory).base);
    const TickOutput output = tick(scene_, input, memory);
    bench_.setForce(output.deviceForce);
    return {.time = time_, .input = input, .output = output};
}

std::vector<TickSample> GuardedBench::run(double duration) {
    std::vector<TickSample> samples;
    for (const double end = time_ + duration - 0.5 * input.timeStep; time_ < end;) {
        samples.push_back(step());
    }
    return samples;
}

double GuardedBench::pressDown() {
    run(1.2);
    reachFor(kDeep);
    return run(0.8).back().output.deviceForce.norm();
}

}  // namespace asperity::test
