#pragma once

#include "app/window/scene/PreviewPane.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace asperity {

class FileChooser;
class PreviewPane;

/// Chooses a scan or a scene to open: recent files and folders on the left, and on the right what
/// the chosen file holds and how it is opened. It only asks: who answers with previews is behind
/// it.
class OpenDialog : public QDialog {
    Q_OBJECT

public:
    /// @param filters of file types
    OpenDialog(const QStringList& filters, QWidget* window);

    void setFolder(const QString& folder);
    /// Folders that are one click away.
    void setFolders(const QStringList& folders);
    [[nodiscard]] QString folder() const;
    /// The newest first.
    void setRecent(const std::vector<RecentFile>& files);
    /// Chooses a file as a user does.
    void choose(const QString& file);

    [[nodiscard]] QSize sizeHint() const override;

    /// Shows the content of the file that was selected last.
    void showPreview(const OpenPreview& preview);
    /// Shows why the file cannot be previewed, a sentence.
    void showFailure(const QString& reason);
    /// Shows the progress of the preview, 0..1; none: it is done, or quick.
    void setProgress(const std::optional<double>& fraction);
    [[nodiscard]] PreviewPane& preview() { return *preview_; }

Q_SIGNALS:
    /// Another file is chosen; empty: none.
    void selected(QString file);
    /// The same file shall be opened in another way: preview().choices().
    void choicesChanged();
    /// OK, Return or a double click has closed the dialog.
    void opened(QString file);

private:
    [[nodiscard]] QWidget* newLeft(const QStringList& filters);
    [[nodiscard]] QWidget* newRight();
    [[nodiscard]] QDialogButtonBox* newButtons();
    void select(const QString& file);
    void openChosen();
    void showState();

    QListWidget* recent_ = nullptr;
    FileChooser* chooser_ = nullptr;
    QLabel* name_ = nullptr;
    QLabel* message_ = nullptr;
    PreviewPane* preview_ = nullptr;
    QPushButton* ok_ = nullptr;
    QString file_;           ///< that is chosen; empty: none
    bool isWanted_ = false;  ///< it is to be opened as soon as it is known to be whole
};

}  // namespace asperity
