#include "core/haptics/blackbox/BlackBox.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace asperity {

namespace {

constexpr double kSpare = 1.0;            // room for marks that come late [s]
constexpr double kMaxSamples = 110000.0;  // some 90 MB

std::size_t sampleRoom(double timeStep, double seconds) {
    return static_cast<std::size_t>(std::min((seconds + kSpare) / timeStep, kMaxSamples));
}

std::size_t markRoom(double seconds) {
    return static_cast<std::size_t>((seconds + kSpare) / BlackBox::kMarkSpacing) + 2;
}

}  // namespace

BlackBox::BlackBox(double timeStep, double seconds)
    : timeStep_(timeStep)
    , seconds_(seconds)
    , samples_(sampleRoom(timeStep, seconds))
    , marks_(markRoom(seconds)) {
    marks_.push_back({-std::numeric_limits<double>::infinity(), TickMemory{}});
}

void BlackBox::take(const TickSample& sample) {
    const double gap = sample.time - lastTime_ - sample.input.timeStep;
    lastTime_ = sample.time;
    const Fault before = std::exchange(fault_, sample.output.fault);
    if (frozen_) {
        return;
    }
    if (gap > 0.5 * timeStep_) {
        forgetBefore(sample.time - sample.input.timeStep - 0.5 * timeStep_);
    }
    keep(sample);
    frozen_ = before == Fault::None && fault_ != Fault::None;
}

void BlackBox::keep(const TickSample& sample) {
    const auto isLongEnough = [&] { return marks_[1].time <= sample.time - seconds_; };
    while (marks_.size() > 1 && (samples_.full() || isLongEnough())) {
        forgetUpToSecondMark();
    }
    if (samples_.full()) {
        forgetAll();
    }
    if (!marks_.empty() && sample.time > marks_.front().time) {
        samples_.push_back(sample);
    }
}

void BlackBox::mark(const Snapshot& latest) {
    const double time = latest.sample.time;
    // Before the first tick that did not fail, time is constant and ticks look alike.
    if (frozen_ || !latest.memory.started || time < lastTime_) {
        return;
    }
    if (!marks_.empty() && time < marks_.back().time + kMarkSpacing) {
        return;
    }
    if (marks_.full()) {
        forgetUpToSecondMark();
    }
    marks_.push_back({time, latest.memory});
}

void BlackBox::restart() noexcept {
    forgetAll();
    frozen_ = false;
}

BlackBox BlackBox::release() {
    BlackBox given(timeStep_, seconds_);
    given.samples_.swap(samples_);
    given.marks_.swap(marks_);
    given.frozen_ = true;
    restart();
    return given;
}

void BlackBox::forgetAll() noexcept {
    samples_.clear();
    marks_.clear();
}

/// All samples, and the marks before a time.
void BlackBox::forgetBefore(double time) noexcept {
    samples_.clear();
    while (!marks_.empty() && marks_.front().time < time) {
        marks_.pop_front();
    }
}

void BlackBox::forgetUpToSecondMark() noexcept {
    marks_.pop_front();
    while (!samples_.empty() && samples_.front().time <= marks_.front().time) {
        samples_.pop_front();
    }
}

}  // namespace asperity
