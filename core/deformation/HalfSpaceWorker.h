#pragma once

#include "core/deformation/HalfSpaceAnswer.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace asperity {

struct Scene;

/// Solves the half-space for the newest state that it was asked about, on a thread of its own: who
/// asks, once a frame, never waits for a solution. For one asking thread.
class HalfSpaceWorker {
public:
    /// @param scene outlives the worker
    explicit HalfSpaceWorker(const Scene& scene);
    /// Cancels what is being solved.
    ~HalfSpaceWorker();
    HalfSpaceWorker(const HalfSpaceWorker&) = delete;
    HalfSpaceWorker& operator=(const HalfSpaceWorker&) = delete;

    /// Takes the place of what was asked before and is not begun; a state that was asked about last
    /// is not solved again.
    void ask(const TipState& state);
    /// The newest answer; null until there is one.
    [[nodiscard]] std::shared_ptr<const HalfSpaceAnswer> newest() const;

private:
    void work(const std::stop_token& stop);

    const Scene& scene_;
    TipState asked_;  ///< last; of the asking thread
    mutable std::mutex mutex_;
    std::condition_variable_any waiting_;
    std::optional<TipState> next_;                   ///< guarded by mutex_
    std::shared_ptr<const HalfSpaceAnswer> newest_;  ///< guarded by mutex_
    std::jthread thread_;                            ///< last: it uses all of the above
};

}  // namespace asperity
