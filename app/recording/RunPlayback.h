#pragma once

#include "app/recording/RunInputs.h"
#include "core/Progress.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace asperity {

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

    /// What was computed so far is kept. @param scene the same one at another place; outlives this
    void moveTo(const Scene& scene) noexcept {
        scene_ = &scene;
        tracker_ = {};
    }

    [[nodiscard]] std::size_t size() const noexcept { return inputs_.size(); }
    /// Since the run began [s].
    [[nodiscard]] double time(std::size_t tick) const { return inputs_.time(tick); }
    [[nodiscard]] double firstTime() const { return inputs_.time(0); }
    [[nodiscard]] double lastTime() const { return inputs_.time(size() - 1); }
    /// The latest tick that had begun at this time [s]; the first or the last one beyond the run.
    [[nodiscard]] std::size_t tickAt(double time) const;

    /// The sample holds until the next call. tick < size()
    [[nodiscard]] const TickSample& at(std::size_t tick);
    /// Passes ticks from `first` on to `sink`, in order, until it returns false.
    /// @throw Canceled
    void play(std::size_t first, const std::function<bool(const TickSample&)>& sink,
              Progress* progress = nullptr);

private:
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
