#include "tests/core/haptics/bench/HeldTip.h"

#include "core/Units.h"
#include "core/io/SceneFile.h"
#include "core/probe/SimulatedAfm.h"
#include "tests/support/TestScenes.h"

#include <algorithm>

namespace asperity::test {

namespace {

constexpr double kApproach = 10.0_ms;
constexpr double kTurn = 0.5;     // [s]
constexpr double kSettled = 2.0;  // [s]
constexpr double kEnd = 2.5;      // [s]

/// The middle of the test maps, in the hand's frame.
Vector3 above(double height) { return {64e-3, 64e-3, height}; }

/// Tick, simulated instrument and, where there is one, the coupling before them.
class CoupledTick {
public:
    CoupledTick(const Scene& scene, const std::optional<CouplingGains>& gains)
        : scene_(scene), gains_(gains), afm_(scene.touched(), scene.truth) {
        input_.settings = scene.settings;
        input_.timeStep = scene.timeStep();
    }

    /// The force for the hand.
    Vector3 moveTo(const HandState& hand) {
        input_.hand = hand;
        if (!gains_) {
            return felt();
        }
        if (!coupling_.started) {
            proxy_ = hand.position;
        }
        const CouplingStep step =
            stepCoupling(*gains_, hand.position, load(), input_.timeStep, coupling_);
        proxy_ += step.motion;
        input_.hand.position = proxy_;
        felt();
        return step.hand;
    }

    [[nodiscard]] const Vector3& tipForce() const { return afm_.trueState().force; }

private:
    [[nodiscard]] ProxyLoad load() const {
        constexpr double kRestSpeed = 1.0_nm;  // v0 of docs/physics.md 6.2, of the base [m/s]
        const Settings& settings = scene_.settings;
        double friction = 0.0;
        for (std::size_t i = 0; i < memory_.model.footCount; ++i) {
            friction += memory_.model.feet.at(i).friction;
        }
        const Vector3 normal = output_.model.normal;
        return {.force =
                    settings.forceGain * (output_.model.normalForce * normal + memory_.correction),
                .normal = normal,
                .friction = settings.forceGain * friction,
                .restSpeed = kRestSpeed / settings.positionGain};
    }

    Vector3 felt() {
        input_.measurement = afm_.exchange(commandBase(scene_, input_, memory_).base);
        output_ = tick(scene_, input_, memory_);
        return output_.handForce;
    }

    const Scene& scene_;
    std::optional<CouplingGains> gains_;
    SimulatedAfm afm_;
    CouplingMemory coupling_;
    Vector3 proxy_ = Vector3::Zero();
    TickInput input_;
    TickMemory memory_;
    TickOutput output_;
};

}  // namespace

Scene hapticScene(const std::string& material, const HeightMap& map, double tickRate,
                  double magnified) {
    SceneDescription description = plainScene();
    description.sample.material =
        readMaterialFile(std::string(ASPERITY_DATA_DIR) + "/materials/" + material + ".toml");
    description.truth.material = description.sample.material;
    description.tickRate = tickRate;
    description.positionGain = 1.0_nm / 1e-3;
    description.forceGain = magnified / 10.0_nN;
    return buildScene(description, map);
}

HeldTip holdTip(const Scene& scene, const Hold& hold, const PortWatch& watch) {
    constexpr double kStart = 4e-3;  // [m]
    VirtualBench bench(hold.bench, above(kStart));
    CoupledTick loop(scene, hold.coupling);
    HeldTip held;
    double low = kStart;
    double high = -1.0;
    int counted = 0;
    for (int i = 0; i * scene.timeStep() < kEnd; ++i) {
        const double time = i * scene.timeStep();
        const double way = std::min(1.0, time / kApproach);
        const double lift = time >= kTurn ? hold.lift : 0.0;
        bench.reachFor(above(kStart + way * (hold.goal - kStart) + lift));
        if (hold.letGo && time >= kTurn) {
            bench.grip(kNoHand);
        }
        const HandState hand = bench.advance(scene.timeStep());
        const Vector3 force = loop.moveTo(hand);
        bench.setForce(force);
        if (watch) {
            watch(hand.position, force);
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
