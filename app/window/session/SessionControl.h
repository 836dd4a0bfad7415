#pragma once

#include "app/window/Stage.h"
#include "core/GrowingFile.h"
#include "core/LatestWriter.h"

#include <QTimer>
#include <QVariantMap>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// Folder in which the program keeps the session by itself. `session.toml` is the present one. An
/// earlier program's session becomes `session_before.toml` where its scene was edited, else
/// `session_last.toml`: a scene that was only viewed does not replace one that somebody worked on.
/// A session that cannot be opened becomes `session_unopened.toml`, which nothing replaces.
class SessionFolder {
public:
    /// Claims the folder; of several programs the first one has it.
    explicit SessionFolder(const std::filesystem::path& folder);

    /// Returns whether this program has the folder.
    [[nodiscard]] bool isOurs() const { return isOurs_; }
    [[nodiscard]] std::filesystem::path session() const;
    /// Returns the session of the program before this one; empty: there is none.
    [[nodiscard]] const std::filesystem::path& last() const { return last_; }
    /// The last one that somebody worked on, else one that could not be opened, else the last one;
    /// empty: there is none.
    [[nodiscard]] std::filesystem::path before() const;
    [[nodiscard]] bool holds(const std::filesystem::path& file) const;

    /// The last session cannot be opened: there is none from now on. @return where it stays
    [[nodiscard]] std::filesystem::path setLastAside();

private:
    void passOn();

    std::filesystem::path folder_;
    FileDescriptor lock_;  ///< of the folder
    bool isOurs_ = false;
    std::filesystem::path last_;
};

/// Notes in the section [window] of a session whether its scene was edited.
void keepEdited(bool isEdited, QVariantMap& kept);
[[nodiscard]] bool isEditedIn(const QVariantMap& kept);

/// Returns the folder of this user's sessions.
[[nodiscard]] std::filesystem::path sessionFolder();

/// The session: the scene with its views, panels and the tip's position, in one file that opens as
/// all of that. Saved when a user asks for it, and by itself while anything changes.
class SessionControl : public Feature {
    Q_OBJECT

public:
    explicit SessionControl(Stage& stage);

    /// From now on the session is kept in a folder, too, whatever ends the program. Of several
    /// programs the first one does.
    void keepIn(const std::filesystem::path& folder);
    /// Returns the folder in which the session is kept; null: it is not kept.
    [[nodiscard]] const SessionFolder* folder() const { return folder_ ? &*folder_ : nullptr; }
    /// Opens the session of the program before this one. There is one. Where it cannot be opened it
    /// is set aside, and the window says so.
    void openLast();

    /// To the file it was saved to, or opened from, as a session; else the user is asked for one.
    void save();
    void saveAs(const std::filesystem::path& file);
    /// Returns whether the program opens with the last session: there is one, and it is wanted.
    [[nodiscard]] bool startsWithLast() const;

private:
    /// Adds the entries of the menu; one is off where there is no session before.
    void addEntries();
    /// Another scene is there, as it was opened.
    void begin();
    void restore(const std::filesystem::path& file, const QVariantMap& kept);
    /// Passes the session to the writer where it has changed. The scene of a recording that is only
    /// looked at is no session.
    void keep();
    /// @param reason why the last session cannot be opened @return what to say of it
    [[nodiscard]] QString setLastAside(const QString& reason);
    [[nodiscard]] QString suggestedFile() const;
    /// The scene as it is now, with its knobs. There is a run.
    [[nodiscard]] SceneDescription scene() const;
    [[nodiscard]] QVariantMap window() const;
    /// Returns the text of the session that is kept by itself.
    [[nodiscard]] std::string text();

    QAction* saveAs_ = nullptr;
    QAction* startWithLast_ = nullptr;
    SceneOpener& scenes_;
    std::map<int, std::filesystem::path> files_;  ///< of sessions, by the origin of their scene
    std::map<int, std::string> names_;            ///< of what was opened, too
    SceneDescription opened_;                     ///< the scene as it was opened
    bool isEdited_ = false;
    std::optional<SessionFolder> folder_;
    std::unique_ptr<LatestWriter<std::string>> writer_;  ///< null: nothing is kept
    std::string kept_;                                   ///< that the writer has
    QTimer due_;
};

}  // namespace asperity
