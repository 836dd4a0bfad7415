#pragma once

#include "app/loading/SceneLoader.h"
#include "app/session/RunControl.h"
#include "app/session/ScaleControl.h"
#include "app/session/SceneEdits.h"

#include <QVariantMap>

#include <filesystem>
#include <functional>

namespace asperity {

/// Which scene the window shows: opens files, and chooses the channel of a scan.
class SceneControl : public QObject {
    Q_OBJECT

public:
    using FailureWords = std::function<QString(const QString& reason)>;

    SceneControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

    /// Loads in the background, then shows; says so in the window when that fails. Where a file
    /// does not hold its scale the user is asked for it first. Another one that is being loaded is
    /// given up. What the scene requires of its model is found out beside its run, see
    /// ModelFitControl.
    /// @param failureWords what to say where that fails, of the reason; none: the reason
    void open(const std::filesystem::path& input, const SceneOverrides& overrides = {},
              const FailureWords& failureWords = {});
    /// From now on that is found out before the run begins, or beside it, as at first.
    void setFit(ModelFit fit) { fit_ = fit; }
    /// The same of a scene that is loaded in another way. @param shown is called once it is there
    void open(const std::filesystem::path& input, const LongWork<LoadedScene>::Work& load,
              const std::function<void()>& shown);
    [[nodiscard]] ScaleControl& scales() { return scales_; }
    /// Cancels what is being loaded; the scene stays as it is.
    void cancelOpen();
    /// Why the last scene that failed to open did so; null: none did.
    [[nodiscard]] std::exception_ptr openError() const { return openError_; }

Q_SIGNALS:
    /// Another scene was opened in whatever way, and is shown.
    void sceneTaken();
    /// After sceneTaken(), of a file that a user opens.
    void opened(std::filesystem::path file);
    /// After opened(), of a session: how the window showed the scene.
    void sessionOpened(std::filesystem::path file, QVariantMap kept);
    void openFailed(QString reason);
    void openCanceled();
    /// The user is asked for the scale of the file before it can be opened.
    void scaleAsked();

private:
    /// @param opening with `load`, `place` and `opened`
    void begin(const std::filesystem::path& input, SceneEdits::Opening opening,
               const FailureWords& failureWords = {});
    /// Of the scan that is open.
    void showChannels();
    void chooseChannel(const QString& name);
    /// @param words of the reason; none: the reason
    void fail(const std::exception_ptr& reason, const FailureWords& words);
    /// Whether the user is asked for the scale that is missing.
    [[nodiscard]] bool asksFor(const std::exception_ptr& reason);
    /// For what the scale is asked for: is called with it.
    using Retry = std::function<void(const GivenScale& scale)>;
    void askForScale(const std::filesystem::path& file, const ScaleGap& gap, const Retry& retry);

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    ScaleControl scales_;
    Retry retry_;                  ///< what was asked for last
    std::filesystem::path asked_;  ///< the file that was asked for last
    SceneOverrides askedWith_;
    ModelFit fit_ = ModelFit::Later;
    std::exception_ptr openError_;
};

}  // namespace asperity
