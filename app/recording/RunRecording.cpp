#include "app/recording/RunRecording.h"

#include "core/realtime/PacedThread.h"

#include <utility>

namespace asperity {

namespace {

constexpr std::size_t kBatch = 250;                    // ticks passed at once at most
constexpr double kBatchTime = 0.1;                     // that they span at most [s]
constexpr std::chrono::milliseconds kKeepPeriod{500};  // between flushes
constexpr double kMaxWriteLag = 0.5;  // ticks of a batch, where the disk follows [s]
/// Ticks that wait; the writer may hold as many again.
constexpr std::size_t kMaxWaiting = (std::size_t{50} << 20U) / sizeof(TickSample);

/// Returns the time that a batch spans [s].
double timeOf(const std::vector<TickSample>& batch) {
    return batch.empty() ? 0.0 : batch.back().time - batch.front().time;
}

}  // namespace

RecordingThread::RecordingThread(const RecordingTarget& target, const LoadedScene& loaded,
                                 const TickMemory& memory, double delay)
    : folder_(target.folder)
    , recording_(target, loaded, memory, delay)
    , thread_([this](const std::stop_token& stop) { work(stop); }) {
    fresh_.reserve(kBatch);
}

void RecordingThread::take(const TickSample& sample) {
    fresh_.push_back(sample);
    if (fresh_.size() == kBatch || sample.time - fresh_.front().time >= kBatchTime) {
        handOver();
    }
}

void RecordingThread::handOver() {
    {
        const std::lock_guard lock(mutex_);
        if (end_ == RecordingEnd::None && handed_.size() + fresh_.size() > kMaxWaiting) {
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
    kept_ = Clock::now();
    std::vector<TickSample> batch;
    do {
        receive(batch, stop);
        for (const TickSample& sample : batch) {
            recording_.take(sample);
        }
        if (recording_.broken()) {
            endBecause(RecordingEnd::TicksLost);
        }
        if (Clock::now() - kept_ >= kKeepPeriod) {
            keepWritten(timeOf(batch) > kMaxWriteLag);
        }
    } while (!allReceived(stop));
    stop.stop_requested() ? recording_.flush() : recording_.finish();
}

/// A disk that is behind has no time to be waited for.
void RecordingThread::keepWritten(bool behind) {
    kept_ = Clock::now();  // before the disk is waited for: the period includes that
    recording_.flush();
    if (!behind) {
        recording_.sync();
    }
}

void RecordingThread::receive(std::vector<TickSample>& batch, const std::stop_token& stop) {
    batch.clear();
    std::unique_lock lock(mutex_);
    waiting_.wait_until(lock, stop, kept_ + kKeepPeriod,
                        [this] { return complete_ || !handed_.empty(); });
    std::swap(batch, handed_);
}

bool RecordingThread::allReceived(const std::stop_token& stop) const {
    const std::lock_guard lock(mutex_);
    return (complete_ || stop.stop_requested()) && handed_.empty();
}

std::future<LastSeconds> writeLastSeconds(std::filesystem::path folder, const LoadedScene& loaded,
                                          BlackBox box, double delay) {
    return std::async(
        std::launch::async, [folder = std::move(folder), &loaded, box = std::move(box), delay] {
            Recording recording({folder}, loaded, box.memory(), delay);
            for (const TickSample& sample : box.samples()) {
                recording.take(sample);
            }
            recording.finish();
            return LastSeconds{folder, recording.ticks(), box.samples().back().output.fault};
        });
}

}  // namespace asperity
