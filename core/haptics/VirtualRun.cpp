#include "core/haptics/VirtualRun.h"

namespace asperity {

void runVirtually(const Scene& scene, const DevicePath& path, AfmController& afm, long ticks,
                  const TickSink& sink) {
    TickMemory memory;
    TickSample sample;
    sample.input.settings = scene.settings;
    sample.input.timeStep = scene.timeStep();
    for (long i = 0; i < ticks; ++i) {
        sample.time = static_cast<double>(i) * scene.timeStep();
        sample.input.device.position = positionAt(path, sample.time) / scene.settings.positionGain;
        const BaseCommand command = commandBase(scene, sample.input, memory);
        sample.input.measurement = afm.exchange(command.base);
        sample.output = tick(scene, sample.input, command, memory);
        sink(sample);
    }
}

}  // namespace asperity
