#include "app/window/ShownRecording.h"

#include "app/runs/LiveRun.h"

#include <algorithm>
#include <utility>

namespace asperity {

ShownRecording::ShownRecording(std::shared_ptr<const LoadedScene> loaded,
                               std::filesystem::path input, const TickSample& first)
    : loaded_(std::move(loaded))
    , input_(std::move(input))
    , halfSpace_(newHalfSpace(loaded_->scene)) {
    take(std::span(&first, 1), false);
}

void ShownRecording::take(std::span<const TickSample> ticks, bool goesOn) {
    constexpr std::size_t kMax = 10'000;
    if (!goesOn) {
        ticks_.clear();
    }
    ticks_.insert(ticks_.end(), ticks.begin(), ticks.end());
    if (ticks_.size() > kMax) {
        const auto old = static_cast<std::ptrdiff_t>(ticks_.size() - kMax);
        ticks_.erase(ticks_.begin(), ticks_.begin() + old);
    }
    std::ranges::for_each(ticks, [this](const TickSample& tick) { steady_.take(tick); });
}

void ShownRecording::setPlaying(double speed) {
    isPlaying_ = speed > 0.0;
    steady_.setPeriod(SteadyForce::kPeriod * (isPlaying_ ? std::min(speed, 1.0) : 1.0));
}

const Snapshot& ShownRecording::snapshot(const LoopStatistics& live) {
    snapshot_.sample = ticks_.back();
    if (isPlaying_) {
        steady_.apply(snapshot_.sample.output);
    }
    snapshot_.statistics = live;
    return snapshot_;
}

}  // namespace asperity
