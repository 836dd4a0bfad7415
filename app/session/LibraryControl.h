#pragma once

#include "app/program/UserLibrary.h"
#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

class LibraryBar;

/// What scenes take from files of a library: materials, probes. Chooses, saves, renames and deletes
/// them as a bar of the window asks for it.
class LibraryControl : public QObject {
    Q_OBJECT

public:
    /// Where a user's own are, in place of the platform's folder.
    void setFolder(const std::filesystem::path& folder);

protected:
    /// @param folder "materials"; of the program's data and of the user's @param noun "Material"
    LibraryControl(MainWindow& window, RunControl& runs, SceneEdits& edits, LibraryBar& bar,
                   const std::string& folder, QString noun);

    /// One of the list, in a scene of defaults.
    struct Item {
        UserLibrary::Entry entry;  ///< no file: it is of a scene
        SceneDescription scene;
        QString name;  ///< for people
        QString notes;
    };

    /// Puts what a file says into a scene. @throw InputError
    [[nodiscard]] virtual SceneDescription read(const std::filesystem::path& file) const = 0;
    [[nodiscard]] virtual QString nameOf(const SceneDescription& scene,
                                         const std::filesystem::path& file) const = 0;
    [[nodiscard]] virtual bool isSame(const SceneDescription& a,
                                      const SceneDescription& b) const = 0;
    /// `scene` with what the list calls `item`.
    [[nodiscard]] virtual SceneDescription with(const SceneDescription& scene,
                                                const SceneDescription& item) const = 0;
    /// What a scene has, under another name.
    [[nodiscard]] virtual SceneDescription renamed(SceneDescription scene,
                                                   const std::string& name) const = 0;
    /// The text of a file.
    [[nodiscard]] virtual std::string textOf(const SceneDescription& scene,
                                             const std::string& notes) const = 0;
    /// The list is another, or another one of it is the scene's.
    virtual void listed(const QStringList& /*names*/, int /*present*/) {}

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
    /// Which of the list the scene has.
    [[nodiscard]] std::optional<std::size_t> present() const;
    [[nodiscard]] std::string notesOf(const SceneDescription& scene) const;
    /// Keeps one that no file has in the list while the program runs.
    void listUnsaved(const SceneDescription& scene);

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    LibraryBar& bar_;
    UserLibrary library_;
    QString noun_;
    std::vector<Item> items_;
};

}  // namespace asperity
