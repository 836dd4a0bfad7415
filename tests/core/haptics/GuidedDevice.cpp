#include "tests/core/haptics/GuidedDevice.h"

#include "core/Units.h"
#include "tests/support/TestScenes.h"

namespace asperity::test {

Scene coupledScene(const CouplingGains& gains, const HeightMap& map) {
    SceneDescription description = plainScene();
    description.sample.material.elastic.youngsModulus = 70.0_GPa;
    description.sample.material.workOfAdhesion = 0.2;
    description.truth.material = description.sample.material;
    description.truth.signalNoise = 0.0;
    description.settings.positionGain = 1e-6;
    description.settings.forceGain = 1e8;
    description.settings.coupling = gains;
    return buildScene(description, map);
}

Scene coupledScene(const CouplingGains& gains) { return coupledScene(gains, flatMap()); }

TickOutput GuidedDevice::moveTo(const Vector3& target, int ticks) {
    TickInput input{.device = device, .settings = settings, .starts = starts};
    input.device.position = target;
    position_ = target;
    TickOutput out;
    for (int i = 0; i < ticks; ++i) {
        input.measurement = afm_.exchange(commandBase(scene_, input, memory_).base);
        out = tick(scene_, input, memory_);
    }
    return out;
}

TickOutput GuidedDevice::glideTo(const Vector3& target, int ticks) {
    const Vector3 from = position_;
    const int moving = ticks / 2;
    for (int i = 1; i < moving; ++i) {
        moveTo(from + static_cast<double>(i) / moving * (target - from));
    }
    return moveTo(target, ticks - moving);
}

}  // namespace asperity::test
