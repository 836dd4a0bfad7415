#pragma once

#include "core/Progress.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace asperity {

class Host;

/// Does a long piece of work on a thread of its own, so that the window stays usable. One at a
/// time: two large scans at once may be more than the memory holds. For one thread with an event
/// loop; there come the answers.
template <typename Result>
class BackgroundWork {
public:
    using Work = std::function<Result(Progress& progress)>;

    /// Callbacks for the work that was asked for last.
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
    /// Cancels the work under way: only its end is still reported.
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

/// Returns why a piece of work failed, for people.
[[nodiscard]] QString reasonOf(const std::exception_ptr& error);

/// Returns what complains in the window of a failed piece of work.
[[nodiscard]] std::function<void(const std::exception_ptr& reason)> complaintIn(Host& host);

/// Line in which the window shows a long piece of work.
struct WorkLine {
    std::function<void(const QString& words)> begin;   ///< what is being done
    std::function<void(double fraction)> setFraction;  ///< how far it is, 0..1
    std::function<void()> end;
    /// Work is under way, shown or not yet. @param cancel ends it, as a user asks for it
    std::function<void(const std::function<void()>& cancel)> enter =
        [](const std::function<void()>& /*cancel*/) {};
    std::function<void()> leave = [] {};  ///< it is not any more
};

/// The window's bottom line. Its button, File > Cancel loading and Esc cancel what it names.
[[nodiscard]] WorkLine loadingLine(Host& host);

/// Work that lasts this long is shown: sooner it would only flicker [ms].
inline constexpr int kShownAfter = 300;

/// Background work that a line shows once it has lasted 0.3 s, so that quick work does not flicker.
/// As BackgroundWork: one at a time, another one replaces it.
template <typename Result>
class LongWork {
public:
    using Work = typename BackgroundWork<Result>::Work;

    struct Answers {
        std::function<void(Result& result)> finished;
        std::function<void(const std::exception_ptr& reason)> failed;
        std::function<void()> cancel =
            {};  ///< what a user's Cancel does; none: nothing comes of it
    };

    LongWork(WorkLine line, Answers answers)
        : line_(std::move(line))
        , answers_(std::move(answers))
        , work_({.progressed = [this](double fraction) { progress(fraction); },
                 .finished =
                     [this](Result& result) {
                         leave();
                         answers_.finished(result);
                     },
                 .failed =
                     [this](const std::exception_ptr& reason) {
                         leave();
                         answers_.failed(reason);
                     }}) {
        soon_.setSingleShot(true);
        QObject::connect(&soon_, &QTimer::timeout, &soon_, [this] { show(); });
    }

    /// @param words what is being done: "Loading steps.gsf …"
    void start(const QString& words, Work work) {
        words_ = words;
        fraction_ = 0.0;
        isAwaited_ = true;
        line_.enter([this] {
            if (answers_.cancel) {
                answers_.cancel();
            } else {
                cancel();
            }
        });
        if (isShown_) {
            line_.begin(words_);
        } else if (!soon_.isActive()) {  // changes in a row do not put it off
            soon_.start(kShownAfter);
        }
        work_.start(std::move(work));
    }
    /// Nothing comes of what is under way. @return whether there was anything
    bool cancel() {
        if (!isAwaited_) {
            return false;
        }
        work_.cancel();
        leave();
        return true;
    }
    [[nodiscard]] bool isAwaited() const { return isAwaited_; }
    /// Returns whether work is under way, with or without an answer to come.
    [[nodiscard]] bool isBusy() const { return work_.isBusy(); }

private:
    void progress(double fraction) {
        fraction_ = fraction;
        if (isShown_) {
            line_.setFraction(fraction_);
        }
    }
    void show() {
        isShown_ = true;
        line_.begin(words_);
        line_.setFraction(fraction_);
    }
    void leave() {
        isAwaited_ = false;
        soon_.stop();
        if (std::exchange(isShown_, false)) {
            line_.end();
        }
        line_.leave();
    }

    WorkLine line_;
    Answers answers_;
    QString words_;
    double fraction_ = 0.0;
    bool isAwaited_ = false;
    bool isShown_ = false;
    QTimer soon_;
    BackgroundWork<Result> work_;
};

}  // namespace asperity
