#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace asperity {

/// Writes the latest of many values in a thread of its own: who passes one waits for no disk,
/// and values that come faster than the disk writes are left out. One that cannot be written is
/// tried again, or a later one in its place, from time to time and when this ends.
template <typename Value>
class LatestWriter {
public:
    /// Runs in the thread. @throw std::exception where the value cannot be written
    using Write = std::function<void(const Value& value)>;

    /// @param pause between two tries
    explicit LatestWriter(Write write,
                          std::chrono::milliseconds pause = std::chrono::milliseconds(3000))
        : write_(std::move(write))
        , pause_(pause)
        , thread_([this](const std::stop_token& stop) { work(stop); }) {}
    /// The last value is written, or tried once more.
    ~LatestWriter() = default;
    LatestWriter(const LatestWriter&) = delete;
    LatestWriter& operator=(const LatestWriter&) = delete;

    void write(Value value) {
        {
            const std::lock_guard lock(mutex_);
            next_ = std::move(value);
        }
        waiting_.notify_one();
    }
    /// Returns why values cannot be written, once until one is written again; empty: they can.
    [[nodiscard]] std::string takeFailure() {
        const std::lock_guard lock(mutex_);
        return std::exchange(failure_, {});
    }

private:
    // A thread may not throw.
    void work(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (waiting_.wait(lock, stop, [this] { return next_.has_value(); })) {
            Value value = *std::exchange(next_, std::nullopt);
            lock.unlock();
            const std::string failure = failureOf(value);
            lock.lock();
            if (!failure.empty() && !std::exchange(fails_, true)) {
                failure_ = failure;
            }
            fails_ = !failure.empty();
            if (!fails_) {
                continue;
            }
            if (stop.stop_requested()) {
                return;
            }
            if (!next_) {
                next_ = std::move(value);
            }
            waiting_.wait_for(lock, stop, pause_, [] { return false; });
        }
    }
    /// Writes. @return why that fails; empty: it does not
    [[nodiscard]] std::string failureOf(const Value& value) const {
        try {
            write_(value);
            return {};
        } catch (const std::exception& error) {
            return error.what();
        }
    }

    Write write_;
    std::chrono::milliseconds pause_;
    std::mutex mutex_;  ///< guards the rest
    std::condition_variable_any waiting_;
    std::optional<Value> next_;  ///< to be written
    std::string failure_;
    bool fails_ = false;   ///< the last try failed
    std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace asperity
