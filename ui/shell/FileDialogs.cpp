#include "ui/shell/FileDialogs.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <array>

namespace asperity {

namespace {

using FolderOfKinds = std::array<QString, kEnumTable<FileKind>.size()>;

/// Of the window's thread, as the dialogs are.
FolderOfKinds& folderOfKinds() {
    static FolderOfKinds folders;
    return folders;
}

QString& folderOf(FileKind kind) { return folderOfKinds().at(static_cast<std::size_t>(kind)); }

QString settingOf(const EnumRow<FileKind>& row) {
    return QStringLiteral("folders/") + QString::fromUtf8(row.key);
}

/// Where a dialog opens, with the name that it suggests.
QString beginOf(const FileQuestion& question) {
    const QString& folder = folderOf(question.kind);
    const bool hasFolder = question.suggestion.contains(QLatin1Char('/'));
    if (hasFolder || folder.isEmpty() || !QFileInfo(folder).isDir()) {
        return question.suggestion;
    }
    return question.suggestion.isEmpty() ? folder : QDir(folder).filePath(question.suggestion);
}

}  // namespace

QString askWhatToOpen(QWidget* window, const FileQuestion& question) {
    const QString file =
        QFileDialog::getOpenFileName(window, question.title, beginOf(question), question.filters);
    rememberFolderOf(question.kind, file);
    return file;
}

QString askWhereToSave(QWidget* window, const FileQuestion& question) {
    const QString file =
        QFileDialog::getSaveFileName(window, question.title, beginOf(question), question.filters);
    rememberFolderOf(question.kind, file);
    return file;
}

QString askWhichFolder(QWidget* window, const FileQuestion& question) {
    const QString folder =
        QFileDialog::getExistingDirectory(window, question.title, beginOf(question));
    if (!folder.isEmpty()) {
        folderOf(question.kind) = folder;
    }
    return folder;
}

QString lastFolder(FileKind kind) { return folderOf(kind); }

void rememberFolderOf(FileKind kind, const QString& file) {
    if (!file.isEmpty()) {
        folderOf(kind) = QFileInfo(file).absolutePath();
    }
}

void keepFolders(QVariantMap& kept) {
    for (const EnumRow<FileKind>& row : kEnumTable<FileKind>) {
        if (const QString& folder = folderOf(row.value); !folder.isEmpty()) {
            kept.insert(settingOf(row), folder);
        }
    }
}

void restoreFolders(const QVariantMap& kept) {
    for (const EnumRow<FileKind>& row : kEnumTable<FileKind>) {
        folderOf(row.value) = kept.value(settingOf(row)).toString();
    }
}

}  // namespace asperity
