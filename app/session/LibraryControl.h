#pragma once

#include "app/program/UserLibrary.h"
#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

class LibraryBar;

/// What scenes take from the files of a library.
struct LibraryKind {
    std::string folder;  ///< "materials"; of the program's data and of the user's
    QString noun;        ///< "Material"
    /// Puts what a file says into a scene of defaults. @throw InputError
    std::function<SceneDescription(const std::filesystem::path& file)> read;
    std::function<QString(const SceneDescription& scene, const std::filesystem::path& file)> nameOf;
    std::function<bool(const SceneDescription& a, const SceneDescription& b)> isSame;
    /// `scene` with what the list calls `item`.
    std::function<SceneDescription(const SceneDescription& scene, const SceneDescription& item)>
        with;
    /// What a scene has, under another name.
    std::function<SceneDescription(const SceneDescription& scene, const std::string& name)> renamed;
    /// The text of a file.
    std::function<std::string(const SceneDescription& scene, const std::string& notes)> textOf;
};

/// Materials or probes. Chooses, saves, renames and deletes them as a bar of the window asks for
/// it.
class LibraryControl : public QObject {
    Q_OBJECT

public:
    /// Where a user's own are, in place of the platform's folder.
    void setFolder(const std::filesystem::path& folder);

Q_SIGNALS:
    /// The list is another, or another one of it is the scene's.
    void listed(QStringList names, int present);

protected:
    LibraryControl(MainWindow& window, RunControl& runs, SceneEdits& edits, LibraryBar& bar,
                   LibraryKind kind);

    /// One of the list, in a scene of defaults.
    struct Item {
        UserLibrary::Entry entry;  ///< no file: it is of a scene
        SceneDescription scene;
        QString name;  ///< for people
        QString notes;
    };

    void readAll();
    void choose(int index);
    void show();

private:
    void add(const UserLibrary::Entry& entry);
    void save();
    void rename();
    void removePresent();
    void remove(const UserLibrary::Entry& entry);
    /// Saves what the scene has. @return whether it could
    bool saveAs(const QString& name);
    /// Does something under a name; asks first where another file of the user's has it.
    /// @param own the file that may have it
    void withName(const QString& name, const std::filesystem::path& own,
                  const std::function<void()>& act);
    /// Which of the list the scene has.
    [[nodiscard]] std::optional<std::size_t> present() const;
    [[nodiscard]] std::string notesOf(const SceneDescription& scene) const;
    /// Keeps one that no file has in the list while the program runs.
    void listUnsaved(const SceneDescription& scene);

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    LibraryBar& bar_;
    LibraryKind kind_;
    UserLibrary library_;
    std::vector<Item> items_;
};

}  // namespace asperity
