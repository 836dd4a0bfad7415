#pragma once

#include "core/FileDescriptor.h"

#include <QVariantMap>

#include <filesystem>

namespace asperity {

/// The folder in which the program keeps the session by itself. `session.toml` is the present one.
/// What an earlier program left becomes `session_before.toml` where its scene was edited, else
/// `session_last.toml`: a scene that was only looked at replaces none that somebody worked on. A
/// session that cannot be opened becomes `session_unopened.toml`, which nothing replaces.
class SessionFolder {
public:
    /// Of several programs the first one has the folder.
    explicit SessionFolder(const std::filesystem::path& folder);

    /// Whether this program has the folder.
    [[nodiscard]] bool isOurs() const { return isOurs_; }
    [[nodiscard]] std::filesystem::path session() const;
    /// What the program before this one left; empty: nothing.
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

/// Where sessions of this user are kept.
[[nodiscard]] std::filesystem::path sessionFolder();

}  // namespace asperity
