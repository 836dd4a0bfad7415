#pragma once

#include "app/program/CancelOnSignal.h"
#include "app/program/LoadedScene.h"
#include "core/Progress.h"

#include <string>

namespace asperity {

/// Shows on the terminal how far long work is; silent where standard error is no terminal. The line
/// is wiped at the end. SIGINT, SIGTERM and SIGHUP cancel the work. One at a time.
class ProgressLine : public Progress {
public:
    /// @param work a word for people: "loading"
    explicit ProgressLine(std::string work);
    ~ProgressLine() override;

    void report(double fraction) override;
    [[nodiscard]] bool isCanceled() const override { return CancelOnSignal::hasArrived(); }

private:
    CancelOnSignal cancel_;
    std::string work_;
    bool isTerminal_;
    long shown_ = -1;  ///< percent
};

/// loadScene() that shows on the terminal how far it is. @throw as loadScene(); Canceled
[[nodiscard]] LoadedScene loadSceneOnTerminal(const std::filesystem::path& input,
                                              const SceneOverrides& overrides);

}  // namespace asperity
