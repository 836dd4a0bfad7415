#pragma once

#include "app/session/LatestFile.h"
#include "app/session/RunControl.h"
#include "app/session/SceneControl.h"
#include "core/FileDescriptor.h"

#include <QTimer>
#include <QVariantMap>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// The session: the scene with its views, panels and the tip's place, in one file that opens as all
/// of that. Saved when a user asks for it, and by itself while anything changes.
class SessionControl : public QObject {
    Q_OBJECT

public:
    SessionControl(MainWindow& window, RunControl& runs, SceneControl& scenes);

    /// From now on the session is kept in a folder, too, whatever ends the program; what an earlier
    /// program kept there becomes the session before. Of several programs the first one does.
    void keepIn(const std::filesystem::path& folder);
    /// The session before; empty: there is none.
    [[nodiscard]] std::filesystem::path before() const;

    /// To the file it was saved to, or opened from, as a session; else the user is asked for one.
    void save();
    void saveAs(const std::filesystem::path& file);

private:
    /// Whether there is a session before.
    void showBefore();
    void restore(const std::filesystem::path& file, const QVariantMap& kept);
    /// Hands the session to the writer where it has changed.
    void keep();
    /// The scene as it is now, with its knobs. There is a run.
    [[nodiscard]] SceneDescription scene() const;
    [[nodiscard]] QVariantMap window() const;
    [[nodiscard]] std::string text() const;

    MainWindow& window_;
    RunControl& runs_;
    SceneControl& scenes_;
    std::filesystem::path file_;  ///< of the session; empty: none yet
    std::filesystem::path folder_;
    FileDescriptor lock_{-1};             ///< of the folder
    std::unique_ptr<LatestFile> writer_;  ///< null: nothing is kept
    std::string kept_;                    ///< that the writer has
    QTimer due_;
};

/// Where sessions of this user are kept.
[[nodiscard]] std::filesystem::path sessionFolder();

}  // namespace asperity
