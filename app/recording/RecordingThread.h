#pragma once

#include "app/recording/Recording.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace asperity {

/// Why a recording takes no more ticks.
enum class RecordingEnd {
    None,         ///< it goes on
    TicksLost,    ///< some never came; what was taken ends before them
    DiskTooSlow,  ///< more wait to be written than it keeps; what was taken ends before the rest
    Failed,       ///< it cannot be written: finish() says why
};

/// A recording that is written on a thread of its own: who hands over ticks waits for no disk. For
/// one thread that hands them over. What is older than about 0.6 s survives the end of the process,
/// and where the disk follows, a power cut.
class RecordingThread {
public:
    /// @param loaded outlives it
    /// @throw Error as Recording
    RecordingThread(const RecordingPlace& place, const LoadedScene& loaded,
                    const TickMemory& memory, double delay);
    /// Where it was not finished, what was handed over is written, and said not to be complete.
    ~RecordingThread() = default;
    RecordingThread(const RecordingThread&) = delete;
    RecordingThread& operator=(const RecordingThread&) = delete;

    /// Every tick, until it ends. Does not wait for the writing.
    void take(const TickSample& sample);
    [[nodiscard]] RecordingEnd end() const;
    /// Waits until all that was taken is written and in place; once. @throw Error
    void finish();

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }
    /// That were written; when it is finished.
    [[nodiscard]] long ticks() const noexcept { return recording_.ticks(); }
    /// What the writing took of a processor, a tick, opening and closing included; when it is
    /// finished [s].
    [[nodiscard]] double timePerTick() const noexcept {
        return ticks() == 0 ? 0.0 : processorTime_ / static_cast<double>(ticks());
    }

private:
    void handOver();
    void work(const std::stop_token& stop);
    void writeAll(const std::stop_token& stop);
    void receive(std::vector<TickSample>& batch, const std::stop_token& stop);
    [[nodiscard]] bool allReceived(const std::stop_token& stop) const;
    void endBecause(RecordingEnd reason);
    void keepWritten(bool behind);

    using Clock = std::chrono::steady_clock;

    std::filesystem::path folder_;
    Recording recording_;            ///< the writer's while it runs
    double processorTime_ = 0.0;     ///< the writer's while it runs [s]
    std::exception_ptr error_;       ///< the writer's while it runs
    Clock::time_point kept_;         ///< the writer's: when it last flushed
    std::vector<TickSample> fresh_;  ///< not handed over yet
    mutable std::mutex mutex_;       ///< guards the rest
    std::condition_variable_any waiting_;
    std::vector<TickSample> handed_;  ///< in the order of time
    bool complete_ = false;           ///< no more will be handed over
    RecordingEnd end_ = RecordingEnd::None;
    std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace asperity
