#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/Recording.h"
#include "app/runs/LiveRun.h"
#include "core/haptics/blackbox/BlackBox.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <future>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace asperity {

/// Reason for which a recording accepts no more ticks.
enum class RecordingEnd {
    None,         ///< it is being written
    TicksLost,    ///< some never came; what was taken ends before them
    DiskTooSlow,  ///< more wait to be written than it keeps; what was taken ends before the rest
    Failed,       ///< it cannot be written: finish() says why
};

/// A recording that is written on a thread of its own: who passes ticks waits for no disk. For
/// one thread that passes them. What is older than about 0.6 s survives the end of the process,
/// and where the disk follows, a power cut.
class RecordingThread {
public:
    /// @param loaded outlives it
    /// @throw Error as Recording
    RecordingThread(const RecordingTarget& target, const LoadedScene& loaded,
                    const TickMemory& memory, double delay);
    /// Without finish(), writes the ticks passed so far and marks the recording as not complete.
    ~RecordingThread() = default;
    RecordingThread(const RecordingThread&) = delete;
    RecordingThread& operator=(const RecordingThread&) = delete;

    /// Every tick, until it ends. Does not wait for the writing.
    void take(const TickSample& sample);
    [[nodiscard]] RecordingEnd end() const;
    /// Waits until all that was taken is written and in place; once. @throw Error
    void finish();

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }
    /// Returns the number of ticks written; once it is finished.
    [[nodiscard]] long ticks() const noexcept { return recording_.ticks(); }
    /// Returns the processor time of writing, per tick, opening and closing included; when it is
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
    std::vector<TickSample> fresh_;  ///< not passed on yet
    mutable std::mutex mutex_;       ///< guards the rest
    std::condition_variable_any waiting_;
    std::vector<TickSample> handed_;  ///< in the order of time
    bool complete_ = false;           ///< no more ticks will come
    RecordingEnd end_ = RecordingEnd::None;
    std::jthread thread_;  ///< last: it uses all of the above
};

/// A recording of a live run that begins with the tick after its latest one.
class RunRecording {
public:
    /// @param run outlives this @throw Error as Recording
    RunRecording(const RecordingTarget& target, LiveRun& run)
        : RunRecording(target, run, run.loop().snapshot()) {}

    /// Every tick that is fetched; what came before the beginning is left out.
    void take(const TickSample& sample) {
        if (sample.time > after_) {
            thread_.take(sample);
        }
    }
    [[nodiscard]] RecordingThread& thread() noexcept { return thread_; }

private:
    RunRecording(const RecordingTarget& target, LiveRun& run, const Snapshot& before)
        : after_(before.statistics.ticks > 0 ? before.sample.time : -1.0)
        , thread_(target, run.loaded(), before.memory, run.device().delay()) {}

    double after_;  ///< tick time [s]
    RecordingThread thread_;
};

/// A black box written as a recording.
struct LastSeconds {
    std::filesystem::path folder;
    long ticks = 0;
    Fault fault = Fault::None;  ///< of the last tick
};

/// Writes it on a thread of its own.
/// @param box holds ticks
/// @param loaded outlives the writing
/// @param delay  of the device [s]
/// @return throws Error where the folder cannot be written; its destructor waits
[[nodiscard]] std::future<LastSeconds> writeLastSeconds(std::filesystem::path folder,
                                                        const LoadedScene& loaded, BlackBox box,
                                                        double delay);

}  // namespace asperity
