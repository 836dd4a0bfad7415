#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"
#include "app/session/ScaleControl.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// Which scene the window shows: loads files in the background, and changes the material.
class SceneControl : public QObject {
    Q_OBJECT

public:
    SceneControl(MainWindow& window, RunControl& runs);

    /// Loads in the background, then shows; says so in the window when that fails. Where a file
    /// does not hold its scale the user is asked for it first. Another one that is being loaded is
    /// given up.
    void open(const std::filesystem::path& input, const SceneOverrides& overrides = {});
    /// Cancels what is being loaded; the scene stays as it is.
    void cancelOpen();
    /// Why the last scene that failed to open did so; null: none did.
    [[nodiscard]] std::exception_ptr openError() const { return openError_; }

Q_SIGNALS:
    void openFailed(QString reason);
    void openCanceled();
    /// The user is asked for the scale of the file before it can be opened.
    void scaleAsked();

private:
    void readMaterials();
    void chooseMaterial(int index);
    void showMaterials();
    /// Of the scan that is open.
    void showChannels();
    void endLoading();
    void use(LoadedScene& scene);
    void fail(const std::exception_ptr& reason);
    /// Whether the user is asked for the scale that is missing.
    [[nodiscard]] bool asksFor(const std::exception_ptr& reason);
    /// Of the scan that is open.
    void chooseChannel(const QString& name);

    MainWindow& window_;
    RunControl& runs_;
    std::vector<SampleMaterial> materials_;
    ScaleControl scales_;
    std::filesystem::path asked_;  ///< the file that was asked for last
    SceneOverrides askedWith_;
    std::filesystem::path open_;  ///< the file that is shown
    QString loading_;             ///< name of the file that is being loaded; empty: none
    std::exception_ptr openError_;
    BackgroundWork<LoadedScene> loader_;
};

}  // namespace asperity
