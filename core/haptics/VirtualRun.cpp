#include "core/haptics/VirtualRun.h"

#include "core/scene/Scene.h"

namespace asperity {

namespace {

/// @param advance gives the device's state at a time [s]
/// @param observe gets every tick's output, before `sink` gets the tick
template <class Advance, class Observe>
void run(const Scene& scene, AfmController& afm, long ticks, const TickSink& sink,
         const Advance& advance, const Observe& observe) {
    TickMemory memory;
    ClosestPointTracker tracker;
    TickSample sample;
    sample.input.settings = scene.settings;
    sample.input.timeStep = scene.timeStep();
    for (long i = 0; i < ticks; ++i) {
        sample.time = static_cast<double>(i) * scene.timeStep();
        sample.input.device = advance(sample.time);
        const BaseCommand command = commandBase(scene, sample.input, memory, tracker);
        sample.input.measurement = afm.exchange(command.base);
        sample.output = tick(scene, sample.input, command, memory, tracker);
        observe(sample.output);
        sink(sample);
    }
}

}  // namespace

void runVirtually(const Scene& scene, const DevicePath& path, AfmController& afm, long ticks,
                  const TickSink& sink) {
    const auto advance = [&](double time) -> DeviceState {
        return {.position = positionAt(path, time) / scene.settings.positionGain};
    };
    run(scene, afm, ticks, sink, advance, [](const TickOutput&) {});
}

void runVirtually(const Scene& scene, HapticDevice& device, AfmController& afm, long ticks,
                  const TickSink& sink) {
    run(
        scene, afm, ticks, sink, [&](double) { return device.advance(scene.timeStep()); },
        [&](const TickOutput& output) { device.observe(output); });
}

}  // namespace asperity
