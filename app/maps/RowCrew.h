#pragma once

#include "core/Progress.h"
#include "core/ShareOut.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace asperity {

/// A row of a map that is computed.
struct FinishedRow {
    int row = 0;
    std::vector<double> values;  ///< as mapRow() gives them
};

/// Threads that compute rows of a map while another thread, which alone talks to other processes,
/// gives them rows and takes what they have made.
class RowCrew {
public:
    /// Computes a row on a thread of the crew.
    using Compute = std::function<std::vector<double>(int row, const CancelCheck& check)>;

    RowCrew(int threads, Compute compute);
    /// Cancels what is in work and waits for its end.
    ~RowCrew();
    RowCrew(const RowCrew&) = delete;
    RowCrew& operator=(const RowCrew&) = delete;

    void give(int row);
    /// Rows that were given and are not taken yet.
    [[nodiscard]] std::size_t open() const { return open_; }
    /// What was finished since the last call. @throw what computing a row threw
    [[nodiscard]] std::vector<FinishedRow> take();

private:
    void work(const std::stop_token& stop);

    Compute compute_;
    std::size_t open_ = 0;  ///< of the thread that gives
    std::atomic<bool> ended_ = false;
    std::mutex mutex_;  ///< guards the rest
    std::condition_variable_any waiting_;
    std::deque<int> wanted_;
    std::vector<FinishedRow> finished_;
    std::exception_ptr error_;
    std::vector<std::jthread> threads_;  ///< last: they use all of the above
};

}  // namespace asperity
