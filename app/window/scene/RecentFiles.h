#pragma once

#include "app/window/scene/PreviewPane.h"

#include <QObject>
#include <QSettings>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <memory>
#include <vector>

class QMenu;

namespace asperity {

/// The files that were opened last, the newest first, and the folder where files are looked for.
/// Kept from one session to the next where there are settings to keep them in.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    static constexpr int kMax = 10;

    /// Reads from `settings` what they remember, and keeps there what changes from now on.
    void remember(std::unique_ptr<QSettings> settings);

    /// Files of this folder are never listed.
    void leaveOut(const std::filesystem::path& folder);
    /// @param file as it was opened
    void add(const std::filesystem::path& file);
    void clear();
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

    /// Returns the folder of the last file that was opened; empty: none was.
    [[nodiscard]] const QString& folder() const { return folder_; }
    void setFolder(const QString& folder);

Q_SIGNALS:
    /// files() are others.
    void changed();

private:
    void write();

    std::unique_ptr<QSettings> settings_;
    std::vector<std::filesystem::path> files_;
    QString folder_;
    std::filesystem::path leftOut_;  ///< empty: none is
};

/// A menu of the files that were opened last, with an entry that forgets them.
class RecentMenu : public QObject {
    Q_OBJECT

public:
    /// Fills the menu, which owns it.
    explicit RecentMenu(QMenu& menu);

    /// The newest first. One that is not there any more is disabled, and its tool tip says so.
    void setFiles(const std::vector<RecentFile>& files);

Q_SIGNALS:
    void aboutToShow();
    /// @param index of the files
    void chosen(int index);
    void clearRequested();

private:
    QMenu& menu_;
};

}  // namespace asperity
