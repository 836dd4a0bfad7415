#pragma once

#include "core/haptics/HapticTick.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/probe/AfmController.h"
#include "core/probe/SimulatedAfm.h"
#include "core/realtime/PacedThread.h"
#include "core/realtime/TripleBuffer.h"

#include <functional>
#include <memory>
#include <optional>

namespace asperity {

/// Durations of ticks, and how late they began.
struct LoopTimes {
    LatencyHistogram tick;
    LatencyHistogram lateness;

    void add(double tickTime, double late) noexcept {
        tick.add(tickTime);
        lateness.add(late);
    }
};

/// The real-time loop: device, instrument and tick at the scene's rate on a thread of its own. One
/// other thread (the owner's) starts and stops it, turns the knobs and fetches what it made.
/// Time is that of the ticks: a skipped due time makes the next step longer, a stop adds none.
class HapticLoop {
public:
    /// All three must outlive the loop.
    HapticLoop(const Scene& scene, HapticDevice& device, AfmController& afm);
    ~HapticLoop();
    HapticLoop(const HapticLoop&) = delete;
    HapticLoop& operator=(const HapticLoop&) = delete;

    /// Starts, or goes on from where it stopped. @throw Error when there can be no more threads
    void start();
    /// One tick without waiting for its time; only while the loop does not run. The base is then
    /// where the present device has it, before another one takes over that may be anywhere.
    void step();
    /// Another device takes over; only while the loop does not run. It outlives the loop. Where it
    /// is at first moves nothing, and its force comes on as after a start.
    void setDevice(HapticDevice& device) noexcept;
    /// Lets the present tick end; the operator feels nothing from then on.
    void stop();
    [[nodiscard]] bool running() const noexcept { return thread_.has_value(); }

    /// The knobs for the next tick. Wait-free.
    void setSettings(const Settings& settings) noexcept { settings_.write(settings); }

    /// The latest tick. Wait-free; holds until the next call.
    const Snapshot& snapshot() noexcept { return snapshot_.read(); }

    /// Passes all ticks since the last call to `sink`, in order. Ticks are kept for five seconds
    /// (above 10 kHz: 50,000 ticks); those that find no room are counted as lost.
    void drain(const std::function<void(const TickSample&)>& sink);

    /// Times since the last start; only while the loop does not run.
    [[nodiscard]] const LoopTimes& times() const noexcept { return sinceStart_; }
    /// State that the next tick starts from; only while the loop does not run.
    [[nodiscard]] const TickMemory& memory() const noexcept { return latest_.memory; }

private:
    void beat(const Beat& beat) noexcept;
    void tickOnce(double timeStep) noexcept;
    void tellForce(const Vector3& force) noexcept;
    void publish() noexcept;
    void measure(const Beat& beat, double begin) noexcept;

    // First, since they are aligned to cache lines.
    TripleBuffer<Settings> settings_;
    TripleBuffer<Snapshot> snapshot_;

    const Scene& scene_;
    HapticDevice* device_;
    DeviceSpecification specification_;  ///< of the device
    AfmController& afm_;
    const TrueTip* truth_;  ///< of the instrument; null where it knows none

    // The loop thread's own while it runs.
    Snapshot latest_;
    ClosestPointTracker tracker_;
    LoopTimes thisSecond_;
    LoopTimes sinceStart_;

    /// A queue of one writer and one reader without locks.
    struct Ring;
    std::unique_ptr<Ring> samples_;
    std::optional<PacedThread> thread_;
};

}  // namespace asperity
