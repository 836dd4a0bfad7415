#pragma once

#include "core/Progress.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace asperity {

/// Does a long piece of work on a thread of its own, so that the window goes on meanwhile. One at a
/// time: two large scans at once may be more than the memory holds. For one thread with an event
/// loop; there come the answers.
template <typename Result>
class BackgroundWork {
public:
    using Work = std::function<Result(Progress& progress)>;

    /// What becomes of the work that was asked for last.
    struct Answers {
        std::function<void(double fraction)> progressed;  ///< share of it that is done, 0..1
        std::function<void(Result& result)> finished;
        std::function<void(const std::exception_ptr& reason)> failed;
        std::function<void()> canceled = [] {};  ///< and it has ended
    };

    explicit BackgroundWork(Answers answers) : answers_(std::move(answers)) {}
    /// Cancels what is under way and waits for its end.
    ~BackgroundWork() {
        cancel();
        if (isBusy()) {
            thread_.join();
        }
    }
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Cancels what is under way; once that has ended, this begins.
    void start(Work work) {
        cancel();
        next_ = std::move(work);
        if (!isBusy()) {
            begin();
        }
    }
    /// From now on nothing comes of what is under way, but that it has ended.
    void cancel() {
        next_ = nullptr;
        canceled_ = true;
    }
    [[nodiscard]] bool isBusy() const { return thread_.joinable(); }

private:
    struct Outcome {
        std::shared_ptr<Result> result;  ///< null: there is a reason
        std::exception_ptr reason;
    };

    /// Reports the progress to the answers' thread.
    class Report : public Progress {
    public:
        explicit Report(BackgroundWork& work) : work_(work) {}

        void report(double fraction) override {
            work_.answer([&work = work_, fraction] {
                if (!work.canceled_) {
                    work.answers_.progressed(fraction);
                }
            });
        }
        [[nodiscard]] bool isCanceled() const override { return work_.canceled_; }

    private:
        BackgroundWork& work_;
    };

    void begin() {
        canceled_ = false;
        thread_ = std::thread([this, work = std::exchange(next_, nullptr)] {
            answer([this, outcome = outcomeOf(work)] { end(outcome); });
        });
    }

    [[nodiscard]] Outcome outcomeOf(const Work& work) {
        Report report(*this);
        try {
            return {.result = std::make_shared<Result>(work(report)), .reason = nullptr};
        } catch (...) {
            return {.result = nullptr, .reason = std::current_exception()};
        }
    }

    void end(const Outcome& outcome) {
        thread_.join();
        if (next_) {
            begin();
        } else if (canceled_) {
            answers_.canceled();
        } else if (outcome.result) {
            answers_.finished(*outcome.result);
        } else {
            answers_.failed(outcome.reason);
        }
    }

    template <typename Answer>
    void answer(Answer answer) {
        QMetaObject::invokeMethod(&here_, std::move(answer), Qt::QueuedConnection);
    }

    Answers answers_;
    Work next_;  ///< null: nothing is asked for
    std::atomic<bool> canceled_ = false;
    QObject here_;  ///< of the answers' thread
    std::thread thread_;
};

/// Why a piece of work failed, for people.
[[nodiscard]] QString reasonOf(const std::exception_ptr& error);

}  // namespace asperity
