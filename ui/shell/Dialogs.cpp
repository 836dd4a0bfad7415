#include "ui/shell/Dialogs.h"

#include "ui/widgets/Theme.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QGuiApplication>
#include <QHeaderView>
#include <QInputDialog>
#include <QLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QTreeView>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr int kTitleBar = 36;  ///< of a window's frame, at most as desktops draw it [px]
constexpr int kBorder = 6;     ///< same, at each side [px]

/// What a frame leaves of the screen.
QRect inFrame(const QRect& available) {
    return available.adjusted(kBorder, kTitleBar, -kBorder, -kBorder);
}

constexpr int kTextGap = 8;            // [px]
constexpr int kTextDialogWidth = 720;  // [px, as theme::scaled() takes them]
constexpr int kTextHeight = 460;       // same

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

QStringList scanFilters(const std::vector<ScanFileType>& types) {
    const QChar blank(' ');
    QStringList all{QStringLiteral("*.toml"), QStringLiteral("*.zip")};
    QStringList single{QObject::tr("Scenes (*.toml)"), QObject::tr("Bundles (*.zip)")};
    for (const ScanFileType& type : types) {
        all << type.patterns;
        const QString name = type.name.left(1).toUpper() + type.name.mid(1);
        single << QStringLiteral("%1 (%2)").arg(name, type.patterns.join(blank));
    }
    all.removeDuplicates();  // some types share theirs
    return QStringList{QObject::tr("Scans and scenes (%1)").arg(all.join(blank))}
           << single << QObject::tr("All files (*)");
}

void askForName(QWidget* window, const QString& title, const QString& label, const QString& name,
                const std::function<void(const QString&)>& take) {
    auto* dialog = new QInputDialog(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("askForName"));
    dialog->setWindowTitle(title);
    dialog->setLabelText(label);
    dialog->setTextValue(name);
    QObject::connect(dialog, &QInputDialog::textValueSelected, window,
                     [take](const QString& given) {
                         if (!given.trimmed().isEmpty()) {
                             take(given.trimmed());
                         }
                     });
    dialog->open();
}

void askWhether(QWidget* window, const QString& question, const QString& action,
                const std::function<void()>& act) {
    auto* box = new QMessageBox(QMessageBox::Question, QObject::tr("Asperity"), question,
                                QMessageBox::Cancel, window);
    box->setObjectName(QString::fromUtf8(kAskWhether));
    box->setTextFormat(Qt::PlainText);  // a name may look like markup
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* agree = box->addButton(action, QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(agree, &QPushButton::clicked, window, act);
    box->open();
}

void complainIn(QWidget* window, const QString& message) {
    auto* box = new QMessageBox(QMessageBox::Warning, QObject::tr("Asperity"), message,
                                QMessageBox::Ok, window);
    // A name of a file may look like markup.
    box->setTextFormat(Qt::PlainText);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

QRect openingGeometry(const QSize& wanted, const QRect& available) {
    const QRect room = inFrame(available);
    QRect geometry({}, wanted.boundedTo(room.size()));
    geometry.moveCenter(room.center());
    return geometry;
}

QRect placeBeside(const QRect& window, const QSize& wanted, const QRect& available) {
    const QRect room = inFrame(available);
    QRect geometry({}, wanted.boundedTo(room.size()));
    const int gap = 2 * kBorder + 1;
    const int right = window.right() + gap;
    const int left = window.left() - gap - geometry.width() + 1;
    const bool fitsRight = right + geometry.width() - 1 <= room.right();
    geometry.moveLeft(fitsRight             ? right
                      : left >= room.left() ? left
                                            : room.right() - geometry.width() + 1);
    geometry.moveTop(std::clamp(window.top(), room.top(), room.bottom() - geometry.height() + 1));
    return geometry;
}

TextDialog::TextDialog(const QString& title, const QString& tip, QWidget* window)
    : QDialog(window), text_(new QPlainTextEdit(this)) {
    setWindowTitle(title);
    setModal(false);
    text_->setObjectName(QStringLiteral("text"));
    text_->setReadOnly(true);
    text_->setToolTip(tip);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copyText"));
    copy->setToolTip(tr("Copy all of the text to the clipboard"));
    QPushButton* close = buttons->button(QDialogButtonBox::Close);
    close->setIcon({});  // no other button has one
    close->setToolTip(tr("Close this window"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kTextGap, kTextGap, kTextGap, kTextGap);
    column->setSpacing(kTextGap);
    column->addWidget(text_, 1);
    column->addWidget(buttons);
    resize(theme::scaled(kTextDialogWidth), theme::scaled(kTextHeight));
}

void TextDialog::setText(const QString& text) { text_->setPlainText(text); }

QString TextDialog::text() const { return text_->toPlainText(); }

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

void FileChooser::setFolders(const QStringList& folders) {
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
