#include "app/RecordingThread.h"

#include "core/realtime/PacedThread.h"

#include <utility>

namespace asperity {

namespace {

constexpr std::size_t kBatch = 250;  // ticks handed over at once
/// That wait; as many again may be in the writer's hands.
constexpr std::size_t kMostWaiting = (std::size_t{50} << 20U) / sizeof(TickSample);

}  // namespace

RecordingThread::RecordingThread(const std::filesystem::path& folder, const LoadedScene& loaded,
                                 const TickMemory& memory, double delay)
    : folder_(folder)
    , recording_(folder, loaded, memory, delay)
    , thread_([this](const std::stop_token& stop) { work(stop); }) {
    fresh_.reserve(kBatch);
}

void RecordingThread::take(const TickSample& sample) {
    fresh_.push_back(sample);
    if (fresh_.size() == kBatch) {
        handOver();
    }
}

void RecordingThread::handOver() {
    {
        const std::lock_guard lock(mutex_);
        if (end_ == RecordingEnd::None && handed_.size() + fresh_.size() > kMostWaiting) {
            end_ = RecordingEnd::DiskTooSlow;
        }
        if (end_ == RecordingEnd::None) {
            handed_.insert(handed_.end(), fresh_.begin(), fresh_.end());
        }
    }
    fresh_.clear();
    waiting_.notify_one();
}

RecordingEnd RecordingThread::end() const {
    const std::lock_guard lock(mutex_);
    return end_;
}

void RecordingThread::endBecause(RecordingEnd reason) {
    const std::lock_guard lock(mutex_);
    end_ = reason;
}

void RecordingThread::finish() {
    handOver();
    {
        const std::lock_guard lock(mutex_);
        complete_ = true;
    }
    waiting_.notify_one();
    thread_.join();
    if (error_) {
        std::rethrow_exception(error_);
    }
}

// A thread may not throw.
void RecordingThread::work(const std::stop_token& stop) {
    try {
        writeAll(stop);
    } catch (...) {
        error_ = std::current_exception();
        endBecause(RecordingEnd::Failed);
    }
    processorTime_ = processorSeconds();
}

void RecordingThread::writeAll(const std::stop_token& stop) {
    std::vector<TickSample> batch;
    while (receive(batch, stop)) {
        for (const TickSample& sample : batch) {
            recording_.take(sample);
        }
        if (recording_.broken()) {
            endBecause(RecordingEnd::TicksLost);
        }
    }
    if (!stop.stop_requested()) {
        recording_.finish();
    }
}

/// @return false: all was received
bool RecordingThread::receive(std::vector<TickSample>& batch, const std::stop_token& stop) {
    batch.clear();
    std::unique_lock lock(mutex_);
    waiting_.wait(lock, stop, [this] { return complete_ || !handed_.empty(); });
    std::swap(batch, handed_);
    return !stop.stop_requested() && !batch.empty();
}

}  // namespace asperity
