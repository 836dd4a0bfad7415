#pragma once

#include "app/recording/RecordedRun.h"
#include "core/Progress.h"
#include "core/haptics/blackbox/BlackBox.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// The inputs of a recorded run, closely packed: an hour at 1 kHz takes about 0.5 GB. Times count
/// from its first tick, whenever the loop had begun.
class RunInputs {
public:
    /// @param memory at the start of the first tick
    explicit RunInputs(TickMemory memory) : memory_(std::move(memory)) {}

    void add(const TickSample& sample);
    /// Only the first ones stay.
    void shorten(std::size_t size);

    [[nodiscard]] std::size_t size() const noexcept { return inputs_.size(); }
    [[nodiscard]] const TickMemory& memory() const noexcept { return memory_; }
    [[nodiscard]] double time(std::size_t tick) const { return inputs_.at(tick).time; }  ///< [s]
    [[nodiscard]] TickInput input(std::size_t tick) const;
    /// The first tick that begins after this time [s]; size(): none does.
    [[nodiscard]] std::size_t firstAfter(double time) const;
    [[nodiscard]] double shortestStep() const noexcept { return shortestStep_; }  ///< [s]

private:
    /// Input of one tick; the settings, which seldom change, are kept once.
    struct Input {
        double time = 0.0;
        DeviceState device;
        AfmMeasurement measurement;
        double timeStep = 0.0;
        std::uint32_t starts = 0;
        std::uint32_t settings = 0;  ///< which of settings_
    };

    TickMemory memory_;
    std::vector<Input> inputs_;
    std::vector<Settings> settings_;
    double begin_ = 0.0;  ///< of the first tick, in the time of the loop [s]
    double shortestStep_ = 0.0;
};

/// Returns the last seconds of a live run as a recording. The box holds ticks.
[[nodiscard]] RunInputs inputsOf(const BlackBox& box);

/// Returns which of the last ticks of a live run is the last one with a snap-in or a pull-off: the
/// contact model's branch is another one than in the tick before; none: there was neither.
[[nodiscard]] std::optional<std::size_t> lastJump(const BlackBox& box);

/// The folder of a run without what it did: that can be computed again.
struct RunOnDisk {
    RunState state = RunState::Complete;
    ScanRecord scan;  ///< that it was made on
    RunInputs inputs;
};

/// Reads the inputs a piece at a time; of a run that is not complete, as many ticks as readRun().
/// @throw InputError as readRun()
[[nodiscard]] RunOnDisk readRunInputs(const std::filesystem::path& folder);

struct Scene;

/// Any tick of a recorded run with its output, bit for bit as it was. The inputs are in memory, the
/// outputs are not: they are computed again from the last checkpoint, every kCheckpointTicks ticks,
/// or from the tick before where ticks are asked for one after the other.
class RunPlayback {
public:
    static constexpr std::size_t kCheckpointTicks = 500;
    /// A tick that is due at 3.3 s may have 3.3000000000000003 s [s].
    static constexpr double kTimeRounding = 1e-9;

    /// @param scene outlives this object
    /// @throw Error where the run holds no tick, or the scene's settings are not those that it
    /// began with
    RunPlayback(const Scene& scene, RunInputs inputs);
    /// Plays the last seconds of a run on its own scene, whose knobs may have been turned before.
    /// @param scene outlives this object @param box holds ticks
    RunPlayback(const Scene& scene, const BlackBox& box);

    [[nodiscard]] std::size_t size() const noexcept { return inputs_.size(); }
    /// Since its first tick [s].
    [[nodiscard]] double time(std::size_t tick) const { return inputs_.time(tick); }
    [[nodiscard]] double firstTime() const { return inputs_.time(0); }
    [[nodiscard]] double lastTime() const { return inputs_.time(size() - 1); }
    /// The latest tick that had begun at this time [s]; the first or the last one beyond the run.
    [[nodiscard]] std::size_t tickAt(double time) const;

    /// The sample, with this time, holds until the next call. tick < size()
    [[nodiscard]] const TickSample& at(std::size_t tick);
    /// Passes ticks from `first` on to `sink`, in order, until it returns false.
    /// @throw Canceled
    void play(std::size_t first, const std::function<bool(const TickSample&)>& sink,
              Progress* progress = nullptr);

private:
    struct Unchecked {};
    RunPlayback(Unchecked, const Scene& scene, RunInputs inputs);

    void seek(std::size_t tick);
    void step();

    const Scene* scene_;
    RunInputs inputs_;
    std::vector<TickMemory> checkpoints_;  ///< before tick 0, kCheckpointTicks, ...
    TickMemory memory_;                    ///< before tick next_
    ClosestPointTracker tracker_;
    std::size_t next_ = 0;
    TickSample sample_;  ///< of the tick before next_
};

}  // namespace asperity
