#include "app/recording/RunPlayback.h"

#include "app/recording/Replay.h"
#include "core/Error.h"

#include <algorithm>
#include <utility>

namespace asperity {

RunPlayback::RunPlayback(const Scene& scene, RunInputs inputs)
    : scene_(&scene)
    , inputs_(std::move(inputs))
    , checkpoints_({inputs_.memory()})
    , memory_(inputs_.memory()) {
    if (inputs_.size() == 0) {
        throw Error("the run was cut off before its first tick: there is nothing to show");
    }
    requireSameSettings(scene, inputs_.input(0), inputs_.shortestStep());
}

std::size_t RunPlayback::tickAt(double time) const {
    const std::size_t after = inputs_.firstAfter(time + kTimeRounding);
    return after == 0 ? 0 : after - 1;
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
    sample_.time = inputs_.time(next_);
    sample_.input = inputs_.input(next_);
    sample_.output = tick(*scene_, sample_.input, memory_, tracker_);
    ++next_;
    if (next_ % kCheckpointTicks == 0 && checkpoints_.size() == next_ / kCheckpointTicks) {
        checkpoints_.push_back(memory_);
    }
}

}  // namespace asperity
