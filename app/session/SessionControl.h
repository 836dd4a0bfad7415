#pragma once

#include "app/session/PlaybackControl.h"
#include "app/session/RunControl.h"
#include "app/session/SceneControl.h"
#include "app/session/SessionFolder.h"
#include "core/LatestWriter.h"

#include <QTimer>
#include <QVariantMap>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// The session: the scene with its views, panels and the tip's place, in one file that opens as all
/// of that. Saved when a user asks for it, and by itself while anything changes.
class SessionControl : public QObject {
    Q_OBJECT

public:
    SessionControl(MainWindow& window, RunControl& runs, SceneEdits& edits, SceneControl& scenes,
                   const PlaybackControl& playback);

    /// From now on the session is kept in a folder, too, whatever ends the program. Of several
    /// programs the first one does.
    void keepIn(const std::filesystem::path& folder);
    /// Where the session is kept; null: nowhere.
    [[nodiscard]] const SessionFolder* folder() const { return folder_ ? &*folder_ : nullptr; }
    /// Opens what the program before this one left. There is a last one. Where it cannot be opened
    /// it is set aside, and the window says so.
    void openLast();

    /// To the file it was saved to, or opened from, as a session; else the user is asked for one.
    void save();
    void saveAs(const std::filesystem::path& file);

private:
    /// Whether there is a session before.
    void showBefore();
    /// Another scene is there, as it was opened.
    void begin();
    void restore(const std::filesystem::path& file, const QVariantMap& kept);
    /// Hands the session to the writer where it has changed. The scene of a recording that is only
    /// looked at is no session.
    void keep();
    /// @param reason why the last session cannot be opened @return what to say of it
    [[nodiscard]] QString setLastAside(const QString& reason);
    void suggestFile();
    /// The scene as it is now, with its knobs. There is a run.
    [[nodiscard]] SceneDescription scene() const;
    [[nodiscard]] QVariantMap window() const;
    /// Of the session that is kept by itself.
    [[nodiscard]] std::string text();

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    SceneControl& scenes_;
    std::map<int, std::filesystem::path> files_;  ///< of sessions, by the origin of their scene
    std::map<int, std::string> names_;            ///< of what was opened, likewise
    QString saved_;                               ///< folder of the last one; empty: none yet
    SceneDescription opened_;                     ///< the scene as it was at first
    bool isEdited_ = false;
    bool rests_ = false;  ///< a recording is looked at: what is kept is of before
    std::optional<SessionFolder> folder_;
    std::unique_ptr<LatestWriter<std::string>> writer_;  ///< null: nothing is kept
    std::string kept_;                                   ///< that the writer has
    QTimer due_;
};

}  // namespace asperity
