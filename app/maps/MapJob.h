#pragma once

#include "app/maps/MapPart.h"
#include "core/Progress.h"
#include "core/ShareOut.h"
#include "core/map/MapPlan.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace asperity {

/// The processes that an MPI launcher has started to work together, each with its rank from 0;
/// without a launcher this one alone, and MPI is not even initialized. One at a time; one thread
/// calls it.
class MpiJob {
public:
    MpiJob();
    /// Waits for the others; not while an exception is on its way, which has to abort() the job.
    ~MpiJob();
    MpiJob(const MpiJob&) = delete;
    MpiJob& operator=(const MpiJob&) = delete;

    [[nodiscard]] int rank() const noexcept { return rank_; }
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] bool isAlone() const noexcept { return size_ == 1; }
    /// It may end this process any time.
    [[nodiscard]] bool hasLauncher() const noexcept { return isInitialized_; }

    /// Waits for all ranks. @throw Error where one of them has another text than rank 0
    /// @param what the text says: "the map"
    void requireSame(const std::string& text, const std::string& what) const;

    struct Message {
        int rank = 0;  ///< of the sender
        std::vector<double> numbers;
    };
    void send(int rank, const std::vector<double>& numbers) const;
    /// A message that has come; none: there is none. Does not wait.
    [[nodiscard]] std::optional<Message> receive() const;

    /// Ends all processes of the job with this exit code.
    [[noreturn]] void abort(int exitCode) const noexcept;

private:
    int rank_ = 0;
    int size_ = 1;
    bool isInitialized_ = false;
    int exceptions_;
};

/// A row of a map that is computed.
struct FinishedRow {
    int row = 0;
    std::vector<double> values;  ///< as mapRow() gives them
};

/// Threads that compute rows of a map while another thread, which alone talks to other processes,
/// gives them rows and takes what they have made.
class MapWorkers {
public:
    /// Computes a row on a thread of the crew.
    using Compute = std::function<std::vector<double>(int row, const CancelCheck& check)>;

    MapWorkers(int threads, Compute compute);
    /// Cancels what is in work and waits for its end.
    ~MapWorkers();
    MapWorkers(const MapWorkers&) = delete;
    MapWorkers& operator=(const MapWorkers&) = delete;

    void give(int row);
    /// Rows that were given and are not taken yet.
    [[nodiscard]] std::size_t open() const { return open_; }
    /// Returns the rows finished since the last call. @throw what computing a row threw
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

/// The part of rank 0: keeps the rows that the part lacks, computed by all ranks of a job, and
/// computes as well. Each rank asks for another row as soon as it has finished one: a slow machine
/// gets fewer.
/// @param threads of this rank; 0: as many as it may use cores @param progress may be null
/// @throw Canceled, Error; the rows finished until then are kept
void leadRows(const MpiJob& job, MapPart& part, MapWorkers::Compute compute, int threads,
              Progress* progress);

/// The part of the other ranks: computes rows that rank 0 assigns, until there are no more.
/// @param progress is asked for cancellation alone; may be null @throw Canceled, Error
void followRows(const MpiJob& job, MapWorkers::Compute compute, int threads,
                const Progress* progress);

/// leadRows() of a map.
void leadMap(const MpiJob& job, const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
             Progress* progress);

/// followRows() of a map.
void followMap(const MpiJob& job, const Scene& scene, const MapPlan& plan, int threads,
               const Progress* progress);

struct Scene;

/// Computes the rows of a map that its part lacks, each on one thread, and keeps them there. The
/// values do not depend on the number of threads.
/// @param threads 0: as many as the machine has cores
/// @param progress may be null; of the whole map
/// @throw Canceled: the rows finished until then are kept; Error where the part cannot be written
void computeMap(const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
                Progress* progress);

}  // namespace asperity
