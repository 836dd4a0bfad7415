#pragma once

#include "core/EnumTable.h"

#include <QString>
#include <QVariantMap>

#include <cstdint>

class QWidget;

namespace asperity {

/// What a file dialog is for: each kind opens where the user last was for it.
enum class FileKind : std::uint8_t {
    Bundle,
    Curve,
    ExportFolder,
    Fit,
    Map,
    Path,
    Picture,
    Recording,
    Report,
    Session,
    Study,
    StudyFolder,
    Table
};

template <>
inline constexpr auto kEnumTable<FileKind> =
    std::to_array<EnumRow<FileKind>>({{FileKind::Bundle, "bundle"},
                                      {FileKind::Curve, "curve"},
                                      {FileKind::ExportFolder, "export"},
                                      {FileKind::Fit, "fit"},
                                      {FileKind::Map, "map"},
                                      {FileKind::Path, "path"},
                                      {FileKind::Picture, "picture"},
                                      {FileKind::Recording, "recording"},
                                      {FileKind::Report, "report"},
                                      {FileKind::Session, "session"},
                                      {FileKind::Study, "study"},
                                      {FileKind::StudyFolder, "study_folder"},
                                      {FileKind::Table, "table"}});

/// Words and content of a file dialog.
struct FileQuestion {
    FileKind kind;
    QString title;
    /// File or folder that is suggested. One with a folder decides where the dialog opens; a bare
    /// name, or none, leaves that to the kind.
    QString suggestion = {};
    QString filters = {};  ///< "Tables (*.csv);;All files (*)"
};

/// Asks for a file to open, for one to write, or for a folder. Where the user answers, the next
/// question of the kind opens there. @return empty: the user canceled
[[nodiscard]] QString askWhatToOpen(QWidget* window, const FileQuestion& question);
[[nodiscard]] QString askWhereToSave(QWidget* window, const FileQuestion& question);
[[nodiscard]] QString askWhichFolder(QWidget* window, const FileQuestion& question);

/// Returns the folder of a kind; empty: none was chosen yet.
[[nodiscard]] QString lastFolder(FileKind kind);
/// Sets the folder of a kind to that of a file: one that was typed, say.
void rememberFolderOf(FileKind kind, const QString& file);

/// Adds the folders of all kinds to what settings keep.
void keepFolders(QVariantMap& kept);
/// Sets them as settings have them.
void restoreFolders(const QVariantMap& kept);

}  // namespace asperity
