#include "app/recording/RunPlayback.h"

#include "app/recording/Replay.h"
#include "core/Error.h"

#include <algorithm>

namespace asperity {

RunPlayback::RunPlayback(const Scene& scene, const RecordedRun& run)
    : scene_(scene), checkpoints_({run.memory}), memory_(run.memory) {
    if (run.samples.empty()) {
        throw Error("the run was cut off before its first tick: there is nothing to show");
    }
    requireSameSettings(scene, run);
    inputs_.reserve(run.samples.size());
    for (const TickSample& sample : run.samples) {
        const TickInput& input = sample.input;
        if (settings_.empty() || settings_.back() != input.settings) {
            settings_.push_back(input.settings);
        }
        inputs_.push_back({.time = sample.time,
                           .device = input.device,
                           .measurement = input.measurement,
                           .timeStep = input.timeStep,
                           .starts = input.starts,
                           .settings = static_cast<std::uint32_t>(settings_.size() - 1)});
    }
}

std::size_t RunPlayback::tickAt(double time) const {
    const auto after = std::ranges::upper_bound(inputs_, time + kTimeRounding, {}, &Input::time);
    return after == inputs_.begin() ? 0 : static_cast<std::size_t>(after - inputs_.begin()) - 1;
}

const TickSample& RunPlayback::at(std::size_t tick) {
    seek(tick);
    return sample_;
}

void RunPlayback::play(std::size_t first, const std::function<bool(const TickSample&)>& sink,
                       Progress* progress) {
    for (std::size_t tick = first; tick < size(); ++tick) {
        if ((tick - first) % kCheckpointTicks == 0) {
            reportTo(progress,
                     static_cast<double>(tick - first) / static_cast<double>(size() - first));
        }
        if (!sink(at(tick))) {
            return;
        }
    }
}

/// Until `tick` is the one before next_.
void RunPlayback::seek(std::size_t tick) {
    if (next_ == tick + 1) {
        return;
    }
    const std::size_t checkpoint =
        std::min(tick / kCheckpointTicks, checkpoints_.size() - 1) * kCheckpointTicks;
    if (next_ > tick || next_ < checkpoint) {
        next_ = checkpoint;
        memory_ = checkpoints_[checkpoint / kCheckpointTicks];
    }
    while (next_ <= tick) {
        step();
    }
}

void RunPlayback::step() {
    const Input& input = inputs_[next_];
    sample_.time = input.time;
    sample_.input = {.device = input.device,
                     .measurement = input.measurement,
                     .settings = settings_[input.settings],
                     .timeStep = input.timeStep,
                     .starts = input.starts};
    sample_.output = tick(scene_, sample_.input, memory_);
    ++next_;
    if (next_ % kCheckpointTicks == 0 && checkpoints_.size() == next_ / kCheckpointTicks) {
        checkpoints_.push_back(memory_);
    }
}

}  // namespace asperity
