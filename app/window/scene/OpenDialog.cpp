#include "app/window/scene/OpenDialog.h"

#include "app/window/scene/PreviewPane.h"
#include "ui/shell/Dialogs.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <utility>

namespace asperity {

namespace {

constexpr int kOpenGap = 8;         // [px]
constexpr int kChooserWidth = 400;  // [px, as theme::scaled() takes them]
constexpr int kShownRecent = 5;     // without scrolling
constexpr int kOpenWidth = 1220;    // [px, as theme::scaled() takes them]
constexpr int kOpenHeight = 760;    // [px, as theme::scaled() takes them]

QVBoxLayout* newColumn(QWidget& side) {
    auto* column = new QVBoxLayout(&side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kOpenGap);
    return column;
}

}  // namespace

OpenDialog::OpenDialog(const QStringList& filters, QWidget* window) : QDialog(window) {
    setObjectName(QStringLiteral("openDialog"));
    setWindowTitle(tr("Open a scan or a scene"));
    auto* sides = new QSplitter(Qt::Horizontal, this);
    sides->addWidget(newLeft(filters));
    sides->addWidget(newRight());
    sides->setStretchFactor(0, 0);
    sides->setStretchFactor(1, 1);
    sides->setChildrenCollapsible(false);
    sides->setHandleWidth(2 * kOpenGap);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(2 * kOpenGap, 2 * kOpenGap, 2 * kOpenGap, 2 * kOpenGap);
    rows->setSpacing(kOpenGap);
    rows->addWidget(sides, 1);
    rows->addWidget(newButtons());
    sides->setSizes({theme::scaled(kChooserWidth), theme::scaled(kOpenWidth - kChooserWidth)});
    setGeometry(openingGeometry(OpenDialog::sizeHint(), screen()->availableGeometry()));
    select({});
}

QSize OpenDialog::sizeHint() const {
    return {theme::scaled(kOpenWidth), theme::scaled(kOpenHeight)};
}

QWidget* OpenDialog::newLeft(const QStringList& filters) {
    auto* side = new QWidget(this);
    QVBoxLayout* column = newColumn(*side);
    recent_ = new QListWidget(side);
    recent_->setObjectName(QStringLiteral("recentFiles"));
    recent_->setToolTip(tr("Files that were opened last"));
    const int line = recent_->fontMetrics().lineSpacing() + 2;
    recent_->setFixedHeight(kShownRecent * line + kOpenGap);
    chooser_ = new FileChooser(filters, side);
    column->addWidget(captionLabel(tr("Recent files"), side));
    column->addWidget(recent_);
    column->addWidget(chooser_, 1);
    connect(chooser_, &FileChooser::chosen, this, &OpenDialog::select);
    connect(chooser_, &FileChooser::activated, this, &OpenDialog::openChosen);
    connect(chooser_, &FileChooser::canceled, this, &QDialog::reject);
    connect(recent_, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem* item) { choose(item->data(Qt::UserRole).toString()); });
    connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        choose(item->data(Qt::UserRole).toString());
        openChosen();
    });
    return side;
}

QWidget* OpenDialog::newRight() {
    auto* side = new QWidget(this);
    QVBoxLayout* column = newColumn(*side);
    name_ = new QLabel(side);
    name_->setObjectName(QStringLiteral("openName"));
    name_->setTextFormat(Qt::PlainText);
    name_->setFont(theme::boldFont());
    name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    preview_ = new PreviewPane(side);
    column->addWidget(name_);
    column->addWidget(preview_, 1);
    connect(preview_, &PreviewPane::choicesChanged, this, [this] {
        showState();
        Q_EMIT choicesChanged();
    });
    return side;
}

QDialogButtonBox* OpenDialog::newButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    for (QAbstractButton* const button : buttons->buttons()) {
        button->setIcon({});  // no other button has one
    }
    ok_ = buttons->button(QDialogButtonBox::Open);
    ok_->setDefault(true);
    ok_->setToolTip(tr("Open the chosen file as it is previewed"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Open nothing"));
    message_ = new QLabel(buttons);
    message_->setObjectName(QStringLiteral("openMessage"));
    message_->setTextFormat(Qt::PlainText);
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    theme::colorText(*message_, &ThemeColors::fault);
    buttons->layout()->removeWidget(message_);
    static_cast<QBoxLayout*>(buttons->layout())->insertWidget(0, message_, 1);
    connect(ok_, &QPushButton::clicked, this, &OpenDialog::openChosen);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void OpenDialog::setFolder(const QString& folder) { chooser_->setDirectory(folder); }

void OpenDialog::setFolders(const QStringList& folders) { chooser_->setFolders(folders); }

/// A path may be typed whatever folder is listed.
QString OpenDialog::folder() const {
    return file_.isEmpty() ? chooser_->directory().absolutePath() : QFileInfo(file_).absolutePath();
}

void OpenDialog::setRecent(const std::vector<RecentFile>& files) {
    recent_->clear();
    for (const RecentFile& file : files) {
        auto* item = new QListWidgetItem(
            tr("%1 – %2").arg(file.name, QFileInfo(file.path).absolutePath()), recent_);
        item->setData(Qt::UserRole, file.path);
        item->setToolTip(file.isThere ? file.path.toHtmlEscaped()
                                      : tr("The file is not there any more"));
        item->setFlags(file.isThere ? item->flags() : Qt::NoItemFlags);
    }
}

void OpenDialog::choose(const QString& file) { chooser_->choose(file); }

void OpenDialog::select(const QString& file) {
    file_ = file;
    isWanted_ = false;
    preview_->clear(file.isEmpty() ? tr("Choose a file to look into it") : QString());
    setProgress(std::nullopt);
    const QString name = QFileInfo(file).fileName();
    name_->setText(name);
    name_->setToolTip(file.toHtmlEscaped());
    message_->clear();
    showState();
    Q_EMIT selected(file);
}

void OpenDialog::showPreview(const OpenPreview& preview) {
    preview_->showPreview(preview);
    message_->setText(preview.refusal);
    showState();
    if (std::exchange(isWanted_, false)) {
        openChosen();
    }
}

void OpenDialog::showFailure(const QString& reason) {
    isWanted_ = false;
    preview_->refuse(reason);
    message_->setText(reason);
    showState();
}

void OpenDialog::setProgress(const std::optional<double>& fraction) {
    preview_->setProgress(fraction);
}

void OpenDialog::openChosen() {
    isWanted_ = !ok_->isEnabled();
    if (!isWanted_) {
        accept();
        Q_EMIT opened(file_);
    }
}

void OpenDialog::showState() { ok_->setEnabled(!file_.isEmpty() && preview_->isComplete()); }

}  // namespace asperity
