#pragma once

#include "app/session/BackgroundWork.h"

#include <QString>
#include <QTimer>

#include <functional>
#include <utility>

namespace asperity {

class MainWindow;

/// Where people see a long piece of work.
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
[[nodiscard]] WorkLine loadingLine(MainWindow& window);

/// Work that lasts this long is shown: sooner it would only flicker [ms].
inline constexpr int kShownAfter = 300;

/// Background work that a line shows once it has lasted 0.3 s, so that quick work does not flicker.
/// As BackgroundWork: one at a time, another one takes its place.
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
    /// Whether an answer is to come.
    [[nodiscard]] bool isAwaited() const { return isAwaited_; }
    /// Whether something is being done, an answer be to come or not.
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
