#include "app/maps/RowCrew.h"

#include <utility>

namespace asperity {

RowCrew::RowCrew(int threads, Compute compute) : compute_(std::move(compute)) {
    for (int i = 0; i < threads; ++i) {
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
}

RowCrew::~RowCrew() { ended_ = true; }

void RowCrew::give(int row) {
    ++open_;
    const std::scoped_lock lock(mutex_);
    wanted_.push_back(row);
    waiting_.notify_one();
}

std::vector<FinishedRow> RowCrew::take() {
    const std::scoped_lock lock(mutex_);
    if (error_) {
        std::rethrow_exception(error_);
    }
    open_ -= finished_.size();
    return std::exchange(finished_, {});
}

void RowCrew::work(const std::stop_token& stop) {
    const CancelCheck check(nullptr, ended_, nullptr);
    for (;;) {
        std::unique_lock lock(mutex_);
        if (!waiting_.wait(lock, stop, [this] { return !wanted_.empty(); })) {
            return;
        }
        const int row = wanted_.front();
        wanted_.pop_front();
        lock.unlock();
        try {
            FinishedRow made{.row = row, .values = compute_(row, check)};
            lock.lock();
            finished_.push_back(std::move(made));
        } catch (...) {
            lock.lock();
            error_ = std::current_exception();
            return;
        }
    }
}

}  // namespace asperity
