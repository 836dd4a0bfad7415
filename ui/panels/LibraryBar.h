#pragma once

#include <QStringList>
#include <QWidget>

class QToolButton;

namespace asperity {

class ChoiceBox;

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
    /// Whether the present one is the user's own, so that it can be renamed and deleted.
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

}  // namespace asperity
