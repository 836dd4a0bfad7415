#pragma once

#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/probe/AfmController.h"

#include <functional>

namespace asperity {

/// One tick with its time.
struct TickSample {
    double time = 0.0;  ///< since the run began [s]
    TickInput input;
    TickOutput output;
};

using TickSink = std::function<void(const TickSample&)>;

/// Runs the tick on a virtual clock: the device along `path`, `afm` answering. Every tick goes to
/// `sink`, in order, without a gap.
void runVirtually(const Scene& scene, const DevicePath& path, AfmController& afm, long ticks,
                  const TickSink& sink);
/// The same with a device that only senses; it sees every tick's output, as in the loop.
void runVirtually(const Scene& scene, HapticDevice& device, AfmController& afm, long ticks,
                  const TickSink& sink);

}  // namespace asperity
