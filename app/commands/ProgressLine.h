#pragma once

#include "app/loading/SceneLoader.h"
#include "app/program/EndSignals.h"
#include "core/Progress.h"

#include <chrono>
#include <string>

namespace asperity {

/// Shows on standard error how far long work is: on a terminal in one line, which is wiped at the
/// end; elsewhere, as in a log, in a line now and then. Work that takes long shows how much longer
/// it will take, at the pace since its beginning. SIGINT, SIGTERM and SIGHUP cancel the work. One
/// at a time.
class ProgressLine : public Progress {
public:
    /// @param work a word for people: "loading" @param pause between lines of a log
    explicit ProgressLine(std::string work, std::chrono::seconds pause = std::chrono::seconds(10));
    ~ProgressLine() override;
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void report(double fraction) override;
    [[nodiscard]] bool isCanceled() const override { return CancelOnSignal::hasArrived(); }

private:
    [[nodiscard]] std::string textOf(double fraction);

    CancelOnSignal cancel_;
    std::string work_;
    bool isTerminal_;
    std::chrono::seconds pause_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point lastLine_ = begin_;
    double first_ = -1.0;  ///< fraction that was reported first; below 0: none
    long shown_ = -1;      ///< percent
};

/// loadScene() that shows on the terminal how far it is. @throw as loadScene(); Canceled
[[nodiscard]] LoadedScene loadSceneOnTerminal(const std::filesystem::path& input,
                                              const SceneOverrides& overrides);

}  // namespace asperity
