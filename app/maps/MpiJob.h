#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

}  // namespace asperity
