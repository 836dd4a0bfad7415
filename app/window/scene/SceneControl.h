#pragma once

#include "app/window/Stage.h"
#include "app/window/scene/ScaleControl.h"

#include <QPointer>
#include <QVariantMap>

#include <filesystem>
#include <functional>

class QAction;
class QActionGroup;
class QMenu;

namespace asperity {

class TextDialog;

/// File > About this scan: what is known of the scan that is open, to be read back.
class ScanReportControl : public Feature {
    Q_OBJECT

public:
    explicit ScanReportControl(Stage& stage);

private:
    void open();
    /// Another scene has another text.
    void refresh();

    QPointer<TextDialog> dialog_;
};

/// The scene that the window shows: opens files, and chooses the channel of a scan.
class SceneControl : public SceneOpener {
    Q_OBJECT

public:
    explicit SceneControl(Stage& stage);

    using SceneOpener::open;
    void open(const std::filesystem::path& input, const SceneOverrides& overrides,
              const FailureWords& failureWords = {}) override;
    void open(const std::filesystem::path& input, const LongWork<LoadedScene>::Work& load,
              const std::function<void()>& shown) override;
    /// From now on what a scene requires is found out before the run begins, or beside it, as at
    /// first.
    void setFit(ModelFit fit) { fit_ = fit; }
    [[nodiscard]] ScaleControl& scales() { return scales_; }
    [[nodiscard]] const RunControl& runs() const { return runs_; }
    /// Cancels what is being loaded; the scene stays as it is.
    void cancelOpen();
    /// Returns why the last scene that failed to open did so; null: none did.
    [[nodiscard]] std::exception_ptr openError() const { return openError_; }

Q_SIGNALS:
    void openFailed(QString reason);
    void openCanceled();
    /// The user is asked for the scale of the file before it can be opened.
    void scaleAsked();

private:
    /// @param opening with `load`, `position` and `opened`
    void begin(const std::filesystem::path& input, SceneEdits::Opening opening,
               const FailureWords& failureWords = {});
    /// Lists the channels of the open scan.
    void showChannels();
    void addEntries();
    void showHistory();
    void chooseChannel(const QString& name);
    [[nodiscard]] QString partsInWords() const;
    [[nodiscard]] QString scanInWords() const;
    void tellWhatStays(const std::filesystem::path& input, const SceneDescription& before);
    /// @param words of the reason; none: the reason
    void fail(const std::exception_ptr& reason, const FailureWords& words);
    /// Asks the user for the scale where that is the reason. @return whether it is
    [[nodiscard]] bool asksFor(const std::exception_ptr& reason);
    /// Receives the scale that was asked for.
    using Retry = std::function<void(const GivenScale& scale)>;
    void askForScale(const std::filesystem::path& file, const ScaleGap& gap, const Retry& retry);

    ScaleControl scales_;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QMenu* channels_ = nullptr;
    QActionGroup* channelGroup_ = nullptr;  ///< of its entries
    Retry retry_;                           ///< what was asked for last
    std::filesystem::path asked_;           ///< the file that was asked for last
    SceneOverrides askedWith_;
    ModelFit fit_ = ModelFit::Later;
    std::exception_ptr openError_;
};

}  // namespace asperity
