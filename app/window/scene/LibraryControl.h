#pragma once

#include "app/program/DataFolder.h"
#include "app/window/Stage.h"

#include <QStringList>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QToolButton;

namespace asperity {

class ChoiceBox;
class LibraryBar;

/// Kind of a library: the part of a scene that is kept in its files.
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
    /// `scene` with its item under another name.
    std::function<SceneDescription(const SceneDescription& scene, const std::string& name)> renamed;
    /// The text of a file.
    std::function<std::string(const SceneDescription& scene, const std::string& notes)> textOf;
};

/// Materials or probes. Chooses, saves, renames and deletes them as a bar of the window asks for
/// it.
class LibraryControl : public Feature {
    Q_OBJECT

public:
    /// Sets the folder of the user's own instead of the platform's.
    void setFolder(const std::filesystem::path& folder);

Q_SIGNALS:
    /// The list is another, or another one of it is the scene's.
    void listed(QStringList names, int present);

protected:
    LibraryControl(Stage& stage, LibraryBar& bar, LibraryKind kind);

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
    /// Returns the item of the list that the scene has.
    [[nodiscard]] std::optional<std::size_t> present() const;
    [[nodiscard]] std::string notesOf(const SceneDescription& scene) const;
    /// Keeps one that no file has in the list while the program runs.
    void listUnsaved(const SceneDescription& scene);

    LibraryBar& bar_;
    LibraryKind kind_;
    UserLibrary library_;
    std::vector<Item> items_;
};

/// A list of things kept in files, those that come with the program and a user's own, with buttons
/// that save what the scene has as a new one, rename and delete an own one. Setters show a state
/// and emit nothing.
class LibraryBar : public QWidget {
    Q_OBJECT

public:
    /// @param kind what they are: "material"; of the widgets' names, too
    explicit LibraryBar(const QString& kind, QWidget* parent = nullptr);

    /// @param notes of each, for its tool tip
    void setEntries(const QStringList& names, const QStringList& notes);
    /// @param index -1: none of them
    void setCurrent(int index);
    /// Sets whether the present one is the user's own, so that it can be renamed and deleted.
    void setOwn(bool own);

Q_SIGNALS:
    void chosen(int index);
    void saveRequested();
    void renameRequested();
    void deleteRequested();

private:
    [[nodiscard]] QToolButton* newButton(const QString& name, const QString& text);

    QString kind_;
    ChoiceBox* list_;
    QToolButton* save_;
    QToolButton* rename_;
    QToolButton* delete_;
};

/// The materials that a sample can be, in the bar above the views and in the scene panel.
class MaterialControl : public LibraryControl {
public:
    explicit MaterialControl(Stage& stage);
};

/// The cantilevers with their calibration that a scene can have, in the scene panel.
class ProbeControl : public LibraryControl {
public:
    explicit ProbeControl(Stage& stage);
};

}  // namespace asperity
