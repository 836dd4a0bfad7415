#include "ui/window/FileChooser.h"

#include "ui/Theme.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QHeaderView>
#include <QLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <QUrl>

#include <utility>

namespace asperity {

namespace {

enum FileColumn : int { Name, Size, Type, Date };

/// A narrower list has room for names alone [px, as theme::scaled() takes them].
constexpr int kDatedWidth = 270;

/// Name and date alone: there is little room.
void simplify(QTreeView& list) {
    list.hideColumn(Type);
    list.hideColumn(Size);
    list.header()->setStretchLastSection(false);
    list.header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    list.header()->setSectionResizeMode(Date, QHeaderView::ResizeToContents);
}

}  // namespace

FileChooser::FileChooser(const QStringList& filters, QWidget* parent) : QFileDialog(parent) {
    setObjectName(QStringLiteral("fileChooser"));
    // The patterns of all types together are wider than a screen.
    setOptions(DontUseNativeDialog | HideNameFilterDetails | ReadOnly);
    name_ = findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    setWindowFlags(Qt::Widget);
    setSizeGripEnabled(false);
    setFileMode(ExistingFile);
    setNameFilters(filters);
    setViewMode(Detail);
    setLabelText(FileName, tr("File"));
    setLabelText(FileType, tr("Type"));
    layout()->setContentsMargins(0, 0, 0, 0);
    if (auto* buttons = findChild<QDialogButtonBox*>()) {
        buttons->hide();
    }
    if (auto* list = findChild<QTreeView*>(QStringLiteral("treeView"))) {
        list->setToolTip(tr("Files of this folder; choose one to look into it"));
        simplify(*list);
        list->installEventFilter(this);
    }
    for (const char* name : {"newFolderButton", "listModeButton", "detailModeButton"}) {
        if (auto* button = findChild<QToolButton*>(QString::fromUtf8(name))) {
            button->hide();  // the name of the folder has their room
        }
    }
    watchName();
}

/// Whatever chooses a file, its name is in this line.
void FileChooser::watchName() {
    name_->setToolTip(tr("Name or path of the file to open"));
    const auto look = [this] {
        if (const QString now = file(); now != file_) {
            file_ = now;
            Q_EMIT chosen(file_);
        }
    };
    connect(name_, &QLineEdit::textChanged, this, look);
    connect(findChild<QFileSystemModel*>(), &QFileSystemModel::rootPathChanged, this, look,
            Qt::QueuedConnection);
}

/// While a path is typed, Qt's list of chosen files holds the folders on its way, too, and its line
/// may show a name without them.
QString FileChooser::file() const {
    const QString name = QFileInfo(name_->text()).fileName();
    for (const QString& path : selectedFiles()) {
        const QFileInfo there(path);
        if (!name.isEmpty() && there.fileName() == name && there.isFile()) {
            return there.absoluteFilePath();
        }
    }
    return {};
}

void FileChooser::setPlaces(const QStringList& folders) {
    QList<QUrl> urls;
    for (const QString& folder : folders) {
        urls << QUrl::fromLocalFile(folder);
    }
    setSidebarUrls(urls);
}

void FileChooser::choose(const QString& file) {
    setDirectory(QFileInfo(file).absolutePath());
    selectFile(file);
    name_->setText(QFileInfo(file).fileName());  // Qt leaves a name that is being typed
}

bool FileChooser::eventFilter(QObject* watched, QEvent* event) {
    auto* list = qobject_cast<QTreeView*>(watched);
    if (list != nullptr && event->type() == QEvent::Resize) {
        list->setColumnHidden(Date, list->width() < theme::scaled(kDatedWidth));
    }
    return QFileDialog::eventFilter(watched, event);
}

/// A folder is entered.
void FileChooser::accept() {
    if (file().isEmpty()) {
        QFileDialog::accept();
    } else {
        Q_EMIT activated();
    }
}

}  // namespace asperity
